// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace oplus {

/// The root of the source tree this was built from.
std::filesystem::path source_root();

/// Where the build looks for the published polygon pairs; the folder need not exist.
std::filesystem::path data_folder();

}  // namespace oplus
