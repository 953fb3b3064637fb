// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// The union of components, which may overlap, touch and share edges, of segments and of points, as a
/// closed set in canonical form:
///  1. its chains are those of the union of the components;
///  2. its dangling edges are the pieces of the segments outside that union, those in line that share a
///     point as one;
///  3. its isolated vertices are the points that are in neither.
///
/// Requires: each component, alone, is a valid region: its chains are simple, the outer one
/// counterclockwise, holes clockwise. One whose outer chain is empty is the plane without its holes. A
/// segment without length counts as a point. Exact; O((n + k) log n) for n edges, segments and points and
/// k pairs of edges that meet.
PlanarSet union_of(const Region& region, const std::vector<Segment>& segments = {},
                   const std::vector<Point>& points = {});

}  // namespace oplus
