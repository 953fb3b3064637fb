// SPDX-License-Identifier: GPL-3.0-or-later
// The tie rule is an infinitesimal turn of Q's directions; and nothing depends on the length of
// vectors, so that all other queries can use one vector for each direction.
#include "properties/proofs/smt/sectors.hpp"
#include "reference/definitions/cyclic_order.hpp"
#include "reference/definitions/tangent_set.hpp"

namespace oplus::smt {

namespace {

const Vectors e = direction("e"), f = direction("f");

/// e is turned to f, if e is an edge of Q; if it is of P, f is turned to e, as the corner of Q is past it.
bool turns_counterclockwise(Summand of) { return of == Summand::Q; }

/// f is so near that none of the edges' directions, nor their opposites, is between or equal to f.
Claim is_turned_a_little(Summand of) {
  const Vectors &from = turns_counterclockwise(of) ? e : f,
                &to = turns_counterclockwise(of) ? f : e;
  std::vector<Claim> parts = {is_left(from, to)};
  for (const Vectors& edge : {corner().in, corner().out}) {
    for (const Vectors& other : {edge, opposite(edge)}) {
      parts.push_back(negation(are_equal(f, other)));
      parts.push_back(negation(all_of({is_left(from, other), is_left(other, to)})));
    }
  }
  return all_of(parts);
}

Query tie_rule(Summand of) {
  const std::string letter = of == Summand::P ? "p" : "q";
  return {
      .id = "definition-2.2.7.tie-rule-" + letter,
      .unknowns = {any_direction("e"), any_direction("f"), any_direction("in"),
                   any_direction("out")},
      .hypotheses = {{"turned",
                      {std::string("f is e turned a little ") +
                           (turns_counterclockwise(of) ? "counterclockwise" : "clockwise"),
                       is_turned_a_little(of)}}},
      .conclusion = {"e is in the tangent set of the corner iff f is",
                     same(is_in_tangent_set(e, of, corner()), is_in_tangent_set(f, of, corner()))},
      .is_false_by_definition = [of](const Model& model) {
        return in_tangent_set({direction_in(model, "e"), of}, corner_in(model)) !=
               in_tangent_set({direction_in(model, "f"), of}, corner_in(model));
      }};
}

/// Comparing the angles of u and v, or of k u and l v.
Claim angles_compare(bool are_scaled, int how) {
  return executed([=](const Values& values) {
    TermVector u = values.vector("u"), v = values.vector("v");
    if (are_scaled) {
      u = values.number("k") * u;
      v = values.number("l") * v;
    }
    return sign(Term(cyclic_order::compare_angle(u, v))) == how;
  });
}

/// In the twins.
Condition with_factors(int k, int l, int how) {
  const int of_v = how < 0 ? -1 : 1;
  return {"k = " + std::to_string(k) + ", l = " + std::to_string(l) + ", v = (" +
              std::to_string(of_v) + ", " + std::to_string(of_v) + "), and u is not zero",
          executed([k, l, of_v](const Values& values) {
            const TermVector u = values.vector("u"), v = values.vector("v");
            return values.number("k") == k && values.number("l") == l && v.x == of_v &&
                   v.y == of_v && !(u.x == 0 && u.y == 0);
          })};
}

Hypothesis is_positive_factor(const std::string& name, const Condition& of_twin) {
  return {
      name + "-positive",
      {name + " > 0", [name](const Values& values) { return is_positive(values.number(name)); }},
      {of_twin}};
}

/// k u and l v instead of u and v.
Query scaling(int how) {
  const std::string name = how < 0 ? "before" : how > 0 ? "after" : "equal";
  return {.id = "definition-2.2.7.scaling-" + name,
          .unknowns = {any_number("k"), any_number("l"), any_vector("u"), any_vector("v")},
          .hypotheses = {is_positive_factor("k", with_factors(-1, 1, 1)),
                         is_positive_factor("l", with_factors(1, -1, how)),
                         {"order",
                          {"comparing the angles of u and v gives " + std::to_string(how),
                           angles_compare(false, how)},
                          {with_factors(1, 1, 1)}}},
          .conclusion = {"so does comparing those of k u and l v", angles_compare(true, how)},
          .is_false_by_definition = [how](const Model& model) {
            const int compared = compare_angle(model.numbers.at("k") * vector_in(model, "u"),
                                               model.numbers.at("l") * vector_in(model, "v"));
            return (compared > 0) - (compared < 0) != how;
          }};
}

const RegisteredQueries registered({tie_rule(Summand::P), tie_rule(Summand::Q), scaling(-1),
                                    scaling(0), scaling(1)});

}  // namespace

}  // namespace oplus::smt
