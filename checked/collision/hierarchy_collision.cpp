// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/collision/hierarchy_collision.hpp"

#include "checked/collision/bounding_volume_hierarchy.hpp"
#include "checked/collision/pairwise_collision.hpp"

namespace oplus {

namespace {

class HierarchyCollision : public PairwiseCollision {
 public:
  HierarchyCollision(const Region& p, const Region& q)
      : PairwiseCollision(p, q),
        hierarchy_of_p_(this->p().pieces),
        hierarchy_of_minus_q_(minus_q().pieces) {}

 private:
  bool visit_pairs(const Point& x, const Visit& visit) const override {
    return hierarchy_of_p_.visit_meeting(hierarchy_of_minus_q_, x, visit);
  }

  BoundingVolumeHierarchy hierarchy_of_p_;
  BoundingVolumeHierarchy hierarchy_of_minus_q_;
};

}  // namespace

std::unique_ptr<CollisionTest> hierarchy_collision(const Region& p, const Region& q) {
  return std::make_unique<HierarchyCollision>(p, q);
}

}  // namespace oplus
