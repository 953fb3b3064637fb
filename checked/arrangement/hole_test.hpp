// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "checked/collision/collision_test.hpp"
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

/// ray: shoots rays through the full convolution (Section 5.2). Winding numbers are numbers of
/// faces, so it leaves the second question to the hierarchies.
enum class HoleTestMethod { hierarchy, sweep, naive, ray };

/// All methods and what the program calls them, the default first.
const std::vector<std::pair<std::string, HoleTestMethod>>& hole_test_methods();

/// The collision test that a method asks about points.
CollisionMethod collision_method(HoleTestMethod method);

/// Requires: p and q are valid (validity.hpp).
std::unique_ptr<HoleTest> hole_test(HoleTestMethod method, const Region& p, const Region& q);

}  // namespace oplus
