// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "reference/definitions/segment.hpp"

namespace oplus {

/// A segment, directed from its lexicographically smaller end, and which of the given segments run
/// along all of it, in its direction or against it.
struct Strand {
  Segment segment;
  std::vector<std::uint32_t> along;
  std::vector<std::uint32_t> against;
};

/// Cuts segments where they overlap, so that strands share but points: overlapping parts of several
/// segments are one strand. Segments that overlap no other are strands as they are. O(n log n).
std::vector<Strand> strands(const std::vector<Segment>& segments);

}  // namespace oplus
