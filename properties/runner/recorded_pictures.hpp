// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "properties/runner/record.hpp"

namespace oplus {

/// Draw what pages show, into pictures/ beside the record: the pair of middle size of each run as
/// ID-typical.svg, the first shrunk pair of each statement's kills as ID-shrunk.svg: P, Q, and their convolution
/// over the sum of the open regions. Remove other pictures with these endings. Throw std::system_error.
void draw_beside(const std::filesystem::path& record, const std::vector<PropertyRun>& runs);
void draw_beside(const std::filesystem::path& record, const std::vector<Kill>& kills);

}  // namespace oplus
