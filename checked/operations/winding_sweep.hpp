// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// What is swept: closed chains, and segments and points besides.
class SweptSets {
 public:
  /// Adds the edges of a closed chain, those without length left out.
  void add(const Chain& chain);
  void add(const PlanarSet& sum, const Vector& moved_by = {});  ///< its chains
  /// Adds the chains run backwards, so that they wind around each point once less.
  void subtract(const PlanarSet& sum, const Vector& moved_by);
  /// Adds an edge that runs forth and back so many times.
  void add_both_ways(const Segment& edge, int times);

  /// From its smaller end to its larger one, and how often chains run along it, and back.
  struct Edge {
    Segment segment;
    int forth, back;
  };

  /// Adds up equal edges. Edges with `forth` == `back` are removed unless they are to be kept.
  void merge(bool keep_balanced);

  std::vector<Edge> edges;
  std::vector<Segment> segments;  ///< each has length
  std::vector<Point> points;
  int around = 0;  ///< the winding number far away
};

/// A piece of an edge or a segment that no other one meets but in its ends, or wholly.
struct SweptPiece {
  Segment segment;  ///< from its smaller end to its larger one
  int left, right;  ///< the winding numbers beside it
  int forth, back;  ///< how often chains run along it, and back
  bool is_of_segment;
};

/// A point at which edges or segments begin, end or meet, or a given point.
struct SweptPoint {
  const Point& point;
  int least, most;  ///< of the winding numbers around it
  int ends;         ///< how often chains end there or start there; twice, where they pass
  bool is_on_edge;  ///< or on a segment
  bool is_given;
};

/// Visits all pieces and all such points, in one sweep.
void sweep_windings(const SweptSets& sets, const std::function<void(const SweptPiece&)>& see_piece,
                    const std::function<void(const SweptPoint&)>& see_point);

/// The closure of what the chains wind around, with the segments and the points: a closed set in canonical
/// form. Requires: no winding number is negative; no edge or vertex of the chains is outside the closure.
PlanarSet closed_set(SweptSets sets);

}  // namespace oplus
