// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/region.hpp"

namespace oplus {

// Each takes a valid region, and O(n log n) for n vertices and touching points.

/// Returns the points in which different chains touch, sorted.
std::vector<Point> touching_points(const Region& region);

/// Returns the edges of each chain, cut where another chain touches it: around each point inside
/// such a piece, the region fills exactly the half disk to its left.
std::vector<std::vector<Segment>> pieces_by_chain(const Region& region);

/// The same of all chains together.
std::vector<Segment> boundary_pieces(const Region& region);

}  // namespace oplus
