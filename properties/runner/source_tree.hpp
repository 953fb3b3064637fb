// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace oplus {

/// The root of the source tree this was built from.
std::filesystem::path source_root();

/// The published polygons (tests/data/README.md). An installed program may be without them.
std::filesystem::path data_folder();

}  // namespace oplus
