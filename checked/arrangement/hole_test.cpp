// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/hole_test.hpp"

#include "checked/arrangement/ray_shooting.hpp"
#include "checked/cycles/convolution_cycles.hpp"
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
    return !collision_->interiors_meet_at(midpoint(edge.source, edge.target));
  }
  bool interiors_meet_at(const Point& x) override { return collision_->interiors_meet_at(x); }

 private:
  std::unique_ptr<CollisionTest> collision_;
};

/// A face is in the complement iff its winding number is zero (thesis, Theorem 4.2.1).
class HoleTestByRays : public HoleTest {
 public:
  HoleTestByRays(const Region& p, const Region& q)
      : rays_(segments(traced_convolution(p, q))),
        collision_(collision_test(CollisionMethod::hierarchy, p, q)) {}

  bool is_hole_right_of(const Segment& edge) override {
    const int winding_number = rays_.winding_number_right_of(edge);
    OPLUS_ENSURES(winding_number >= 0, "Theorem 4.2.1");
    return winding_number == 0;
  }
  bool interiors_meet_at(const Point& x) override { return collision_->interiors_meet_at(x); }

 private:
  RayShooting rays_;
  std::unique_ptr<CollisionTest> collision_;
};

}  // namespace

const std::vector<std::pair<std::string, HoleTestMethod>>& hole_test_methods() {
  static const std::vector<std::pair<std::string, HoleTestMethod>> methods = {
      {"bvh", HoleTestMethod::hierarchy},
      {"sweep", HoleTestMethod::sweep},
      {"naive", HoleTestMethod::naive},
      {"ray", HoleTestMethod::ray},
  };
  return methods;
}

CollisionMethod collision_method(HoleTestMethod method) {
  switch (method) {
    case HoleTestMethod::sweep:
      return CollisionMethod::sweep;
    case HoleTestMethod::naive:
      return CollisionMethod::naive;
    default:
      return CollisionMethod::hierarchy;
  }
}

std::unique_ptr<HoleTest> hole_test(HoleTestMethod method, const Region& p, const Region& q) {
  if (method == HoleTestMethod::ray) return std::make_unique<HoleTestByRays>(p, q);
  return std::make_unique<HoleTestByCollision>(collision_test(collision_method(method), p, q));
}

}  // namespace oplus
