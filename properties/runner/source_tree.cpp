// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/source_tree.hpp"

namespace oplus {

std::filesystem::path source_root() { return OPLUS_SOURCE_DIR; }

std::filesystem::path data_folder() { return source_root() / "tests/data"; }

}  // namespace oplus
