// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "checked/engine.hpp"
#include "reference/definitions/segment.hpp"

namespace oplus {

/// Decides what the filters leave open (thesis, Chapter 5). Implementations are built once a pair of
/// regions; a question may change their state, never their answers.
class HoleTest {
 public:
  HoleTest() = default;
  HoleTest(const HoleTest&) = delete;
  HoleTest& operator=(const HoleTest&) = delete;
  virtual ~HoleTest() = default;

  /// Whether the face to the right of an edge is in the complement of the sum.
  /// Requires: the edge is a part of a segment of the reduced convolution, in its direction, inside
  /// an edge of their arrangement along which no segment runs the other way.
  virtual bool is_hole_right_of(const Segment& edge) = 0;

  /// Whether x is in the sum of the open regions: what low-dimensional features depend on.
  virtual bool interiors_meet_at(const Point& x) = 0;
};

// Requires: p and q are valid (validity.hpp).

/// By a collision test (Section 5.1).
std::unique_ptr<HoleTest> hierarchy_hole_test(const Region& p, const Region& q);
std::unique_ptr<HoleTest> sweep_hole_test(const Region& p, const Region& q);
std::unique_ptr<HoleTest> naive_hole_test(const Region& p, const Region& q);

/// Shoots rays through the full convolution (Section 5.2). Winding numbers are numbers of faces, so it
/// leaves the second question to the hierarchies.
std::unique_ptr<HoleTest> ray_hole_test(const Region& p, const Region& q);

/// All methods and what the program calls them, the default first.
const std::vector<std::pair<std::string, HoleTestMethod>>& hole_test_methods();

}  // namespace oplus
