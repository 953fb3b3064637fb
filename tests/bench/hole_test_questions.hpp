// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/definitions/segment.hpp"
#include "reference/families/family.hpp"

namespace oplus {

/// Questions for a hole test about a pair of regions: is there a hole to the right of an edge?

/// Those of rca about the closed sum: one per face that the other filters do not decide.
std::vector<Segment> questions_of_rca(const Summands& pair);

/// One per edge of the reduced convolution's arrangement that no segment passes in the other direction:
/// all kinds of faces, as if there were no other filter.
std::vector<Segment> questions_about_edges(const Summands& pair);

/// At most this many of them, evenly spread.
std::vector<Segment> thinned_out(const std::vector<Segment>& questions, std::size_t most);

}  // namespace oplus
