// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/hole_test.hpp"

#include "checked/arrangement/ray_shooting.hpp"
#include "checked/collision/collision_test.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "reference/definitions/contract.hpp"

namespace oplus {

namespace {

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
