// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "reference/definitions/minkowski_sum.hpp"

namespace oplus::slide {

/// Points and parts of segments in the closed sum's interior that may not be in the open sum.
struct Candidates {
  struct Piece {
    Segment segment;
    Point inside;  ///< if it is not in the open sum, nor is the whole piece but for its ends
  };
  std::vector<Piece> pieces;
  std::vector<Point> points;

  void take(Candidates&& more);
};

/// Adds to the closed sum the dangling edges and isolated vertices of the open one, as a collision
/// test finds them. `corners` are points on the regularized boundary, all vertices among them.
void add_low_dimensional_features(const Candidates& candidates, const Region& p, const Region& q,
                                  std::vector<Point> corners, MinkowskiSum& sum);

}  // namespace oplus::slide
