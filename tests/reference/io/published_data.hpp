// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "properties/runner/source_tree.hpp"
#include "reference/io/reading.hpp"

/// Skips a test of the published polygon pairs where they are not there.
#define NEEDS_PUBLISHED_DATA() \
  if (!std::filesystem::exists(data_folder())) GTEST_SKIP() << data_folder() << " is not there"

namespace oplus {

inline Region published(const std::string& name) {
  return read_region_file(data_folder() / (name + ".dat")).region;
}

}  // namespace oplus
