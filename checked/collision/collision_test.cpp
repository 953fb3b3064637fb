// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/collision/collision_test.hpp"

#include <stdexcept>

namespace oplus {

std::unique_ptr<CollisionTest> collision_test(CollisionMethod method, const Region& p,
                                              const Region& q) {
  switch (method) {
    case CollisionMethod::hierarchy:
      return hierarchy_collision(p, q);
    case CollisionMethod::sweep:
      return sweep_collision(p, q);
    case CollisionMethod::naive:
      return naive_collision(p, q);
  }
  throw std::logic_error("a collision test without a method");
}

}  // namespace oplus
