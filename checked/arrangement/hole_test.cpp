// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/hole_test.hpp"

#include "checked/arrangement/ray_shooting.hpp"
#include "checked/collision/collision_test.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "checked/sweep/sweep_collision.hpp"
#include "reference/definitions/contract.hpp"

namespace oplus {

namespace {

/// An edge all of whose segments run in one direction is not dangling (thesis, Theorem 3.2.8): to
/// its left is the sum, so its middle is in the open sum iff the face to its right is.
class HoleTestByCollision : public HoleTest {
 public:
  explicit HoleTestByCollision(std::unique_ptr<CollisionTest> collision)
      : collision_(std::move(collision)) {}

  bool is_hole_right_of(const Segment& edge) override {
    return !interiors_meet_at(midpoint(edge.source, edge.target));
  }
  bool interiors_meet_at(const Point& x) final { return collision_->interiors_meet_at(x); }

 private:
  std::unique_ptr<CollisionTest> collision_;
};

/// A face is in the complement iff its winding number is zero (thesis, Theorem 4.2.1).
class HoleTestByRays : public HoleTestByCollision {
 public:
  HoleTestByRays(const Region& p, const Region& q)
      : HoleTestByCollision(hierarchy_collision(p, q)), rays_(segments(traced_convolution(p, q))) {}

  bool is_hole_right_of(const Segment& edge) override {
    const int winding_number = rays_.winding_number_right_of(edge);
    OPLUS_ENSURES(winding_number >= 0, "Theorem 4.2.1");
    return winding_number == 0;
  }

 private:
  RayShooting rays_;
};

}  // namespace

std::unique_ptr<HoleTest> hierarchy_hole_test(const Region& p, const Region& q) {
  return std::make_unique<HoleTestByCollision>(hierarchy_collision(p, q));
}

std::unique_ptr<HoleTest> sweep_hole_test(const Region& p, const Region& q) {
  return std::make_unique<HoleTestByCollision>(sweep_collision(p, q));
}

std::unique_ptr<HoleTest> naive_hole_test(const Region& p, const Region& q) {
  return std::make_unique<HoleTestByCollision>(naive_collision(p, q));
}

std::unique_ptr<HoleTest> ray_hole_test(const Region& p, const Region& q) {
  return std::make_unique<HoleTestByRays>(p, q);
}

const std::vector<std::pair<std::string, HoleTestMethod>>& hole_test_methods() {
  static const std::vector<std::pair<std::string, HoleTestMethod>> methods = {
      {"bvh", hierarchy_hole_test},
      {"sweep", sweep_hole_test},
      {"naive", naive_hole_test},
      {"ray", ray_hole_test},
  };
  return methods;
}

}  // namespace oplus
