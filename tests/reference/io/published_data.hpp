// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "properties/runner/source_tree.hpp"
#include "reference/io/reading.hpp"

namespace oplus {

inline Region published(const std::string& name) {
  return read_region_file(data_folder() / (name + ".dat")).region;
}

}  // namespace oplus
