// SPDX-License-Identifier: GPL-3.0-or-later
// x = p + q = (p + n) + (q - n), and for small n these are inside P and Q iff n points to the left of
// the edge e of P around p, and -n to the left of the edge f of Q around q.
#include "properties/proofs/smt/built_regions.hpp"
#include "properties/proofs/smt/sectors.hpp"
#include "reference/definitions/collision.hpp"

namespace oplus::smt {

namespace {

Formula points_into_both(const Values& values, const Vectors& n) {
  return all_of({is_left(direction(values, "e"), n), is_left(direction(values, "f"), opposite(n))});
}

bool interiors_meet_at_sum(const Model& model) {
  return interiors_meet(region_with_edge(direction_in(model, "e"), 1),
                        reflected(region_with_edge(direction_in(model, "f"), 1)));
}

const std::vector<Unknown> two_edges = {{"e", Unknown::Kind::direction},
                                        {"f", Unknown::Kind::direction}};

Formula have_equal_directions(const Values& values) {
  return are_equal(direction(values, "e"), direction(values, "f"));
}

const RegisteredQueries registered({
    {.id = "lemma-2.2.5.half-disks",
     .statement = "lemma-2.2.5",
     .unknowns = two_edges,
     .hypotheses = {{"different",
                     {"the directions of e and f differ",
                      [](const Values& values) {
                        return negation(have_equal_directions(values));
                      }}}},
     .conclusion = {"e + f, its opposite, or a vector to the left of e points left of e and its "
                    "opposite left of f",
                    [](const Values& values) {
                      const Vectors e = direction(values, "e"), f = direction(values, "f");
                      return one_is_in(
                          {sum(e, f), opposite(sum(e, f)), leftwards(e)},
                          [&](const Vectors& n) { return points_into_both(values, n); });
                    }},
     .dropped = "different",
     .is_false_by_definition = [](const Model& model) { return !interiors_meet_at_sum(model); }},
    {.id = "lemma-2.2.5.equal-directions",
     .statement = "lemma-2.2.5",
     .unknowns = {two_edges[0], two_edges[1], {"n", Unknown::Kind::direction}},
     .hypotheses = {{"equal", {"the directions of e and f are equal", have_equal_directions}}},
     .conclusion = {"n does not point left of e, or its opposite not left of f",
                    [](const Values& values) {
                      return negation(points_into_both(values, direction(values, "n")));
                    }},
     .dropped = "equal",
     .is_false_by_definition = interiors_meet_at_sum},
});

}  // namespace

}  // namespace oplus::smt
