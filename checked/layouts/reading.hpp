// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "checked/layouts/layout.hpp"

namespace oplus {

/// Reads a layout (docs/layouts.md), told apart by what it starts with and by its members:
///  1. polygons where they lie, each one a part, in any form of a region (reading.hpp);
///  2. JSON with `parts` and `placements`;
///  3. JSON of jagua-rs and sparrow: `items` and a `solution`;
///  4. JSON of packingsolver, a solution with `bins`;
///  5. SVG.
///
/// Coordinates are exact. A rotation by degrees is exact for multiples of 90; any other one is taken for the
/// rotation that rational_rotation(degrees, angle_error) returns, and a note says so.
///
/// `name` is what messages call the text; files that it names are looked for in `folder`. Throws InvalidInput, which
/// names the part. Requires: angle_error > 0.
Layout read_layout(const std::string& text, const std::string& name,
                   const std::filesystem::path& folder, const Rational& angle_error);

/// The same of a file; "-" is standard input.
Layout read_layout_file(const std::string& path, const Rational& angle_error);

}  // namespace oplus
