// SPDX-License-Identifier: GPL-3.0-or-later
// x = p + q = (p + n) + (q - n), and for small n these are inside P and Q iff n points to the left of
// the edge e of P around p, and -n to the left of the edge f of Q around q.
#include "properties/proofs/smt/built_regions.hpp"
#include "properties/proofs/smt/sectors.hpp"
#include "reference/definitions/collision.hpp"

namespace oplus::smt {

namespace {

const Vectors e = direction("e"), f = direction("f");

Claim points_into_both(const Vectors& n) {
  return all_of({is_left(e, n), is_left(f, opposite(n))});
}

bool interiors_meet_at_sum(const Model& model) {
  return interiors_meet(region_with_edge(direction_in(model, "e"), 1),
                        reflected(region_with_edge(direction_in(model, "f"), 1)));
}

const RegisteredQueries registered({
    {.id = "lemma-2.2.5.half-disks",
     .unknowns = {any_direction("e"), any_direction("f")},
     .hypotheses = {{"different", {"the directions of e and f differ", negation(are_equal(e, f))}}},
     .conclusion = {"e + f, its opposite, or a vector to the left of e points left of e and its "
                    "opposite left of f",
                    one_is_in({sum(e, f), opposite(sum(e, f)), leftwards(e)}, points_into_both)},
     .is_false_by_definition = std::not_fn(interiors_meet_at_sum)},
    {.id = "lemma-2.2.5.equal-directions",
     .unknowns = {any_direction("e"), any_direction("f"), any_direction("n")},
     .hypotheses = {{"equal", {"the directions of e and f are equal", are_equal(e, f)}}},
     .conclusion = {"n does not point left of e, or its opposite not left of f",
                    negation(points_into_both(direction("n")))},
     .is_false_by_definition = interiors_meet_at_sum},
});

}  // namespace

}  // namespace oplus::smt
