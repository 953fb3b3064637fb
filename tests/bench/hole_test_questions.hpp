// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/definitions/segment.hpp"
#include "reference/families/family.hpp"

namespace oplus {

/// What a hole test may be asked about a pair of regions: is there a hole to the right of an edge?

/// The questions of rca about the closed sum: about the faces that the other filters leave open.
std::vector<Segment> questions_of_rca(const Summands& pair);

/// One about each edge of the reduced convolution's arrangement along which no segment runs the other
/// way: holes and others of all kinds, as if there were no other filter.
std::vector<Segment> questions_about_edges(const Summands& pair);

/// So many of them at most, evenly spread.
std::vector<Segment> thinned_out(const std::vector<Segment>& questions, std::size_t most);

}  // namespace oplus
