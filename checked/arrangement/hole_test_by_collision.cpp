// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/hole_test.hpp"
#include "checked/collision/collision_test.hpp"

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

}  // namespace

std::unique_ptr<HoleTest> hierarchy_hole_test(const Region& p, const Region& q) {
  return std::make_unique<HoleTestByCollision>(collision_test(CollisionMethod::hierarchy, p, q));
}

std::unique_ptr<HoleTest> sweep_hole_test(const Region& p, const Region& q) {
  return std::make_unique<HoleTestByCollision>(collision_test(CollisionMethod::sweep, p, q));
}

std::unique_ptr<HoleTest> naive_hole_test(const Region& p, const Region& q) {
  return std::make_unique<HoleTestByCollision>(collision_test(CollisionMethod::naive, p, q));
}

}  // namespace oplus
