// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter5/collision_outcome.hpp"

#include <memory>

#include "properties/statements/chapter5/boundary_contact.hpp"
#include "properties/statements/chapter5/placements.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

Outcome collision_outcome(CollisionMethod method, const Summands& summands) {
  const std::unique_ptr<CollisionTest> test = collision_test(method, summands.p, summands.q);
  const Region minus_q = reflected(summands.q);
  Outcome outcome;
  for (const Point& x : placements(summands)) {
    const Region placed = translated(minus_q, x);
    const bool meet = interiors_meet(summands.p, placed);
    const std::string contact = describe(strongest_contact(summands.p, placed));
    ++outcome.counts["placements " + contact + (meet ? " that collide" : " that do not")];
    if (test->interiors_meet_at(x) == meet) continue;
    outcome.fail("at " + to_string(x) + ", " + contact + ", the interiors of P and -Q+x " +
                 (meet ? "meet" : "do not meet") + ", but the method says the opposite");
    break;
  }
  return outcome;
}

}  // namespace oplus
