// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/collision/naive_collision.hpp"

#include "checked/collision/pairwise_collision.hpp"

namespace oplus {

namespace {

class NaiveCollision : public PairwiseCollision {
 public:
  NaiveCollision(const Region& p, const Region& q) : PairwiseCollision(p, q) {}

 private:
  bool visit_pairs(const Point&, const Visit& visit) const override {
    for (std::size_t i = 0; i < p().pieces.size(); ++i) {
      for (std::size_t j = 0; j < minus_q().pieces.size(); ++j) {
        if (visit(i, j)) return true;
      }
    }
    return false;
  }
};

}  // namespace

std::unique_ptr<CollisionTest> naive_collision(const Region& p, const Region& q) {
  return std::make_unique<NaiveCollision>(p, q);
}

}  // namespace oplus
