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
                       is_turned_a_little(of)}},
                     {"not-straight",
                      {"in and out have different directions",
                       negation(are_equal(corner().in, corner().out))}}},
      .conclusion = {"e is in the tangent set of the corner iff f is",
                     same(is_in_tangent_set(e, of, corner()), is_in_tangent_set(f, of, corner()))},
      .dropped = "turned",
      .is_false_by_definition = [of](const Model& model) {
        return in_tangent_set({direction_in(model, "e"), of}, corner_in(model)) !=
               in_tangent_set({direction_in(model, "f"), of}, corner_in(model));
      }};
}

/// Comparing the angles of k u and v, or of u and v.
Claim angles_compare(bool is_scaled, int how) {
  return executed([=](const Values& values) {
    const TermVector u = values.vector("u"), v = values.vector("v");
    return sign(Term(cyclic_order::compare_angle(is_scaled ? values.number("k") * u : u, v))) ==
           how;
  });
}

/// k u instead of u.
Query scaling(int how) {
  const std::string name = how < 0 ? "before" : how > 0 ? "after" : "equal";
  return {
      .id = "definition-2.2.7.scaling-" + name,
      .unknowns = {any_number("k"), any_vector("u"), any_vector("v")},
      .hypotheses = {{"positive",
                      {"k > 0",
                       [](const Values& values) { return is_positive(values.number("k")); }}},
                     {"order",
                      {"comparing the angles of u and v gives " + std::to_string(how),
                       angles_compare(false, how)}}},
      .conclusion = {"so does comparing those of k u and v", angles_compare(true, how)},
      .dropped = "positive",
      .of_twin = {{"k = -1 and v = (1, 1), and u is not zero", executed([](const Values& values) {
                     const TermVector u = values.vector("u"), v = values.vector("v");
                     return values.number("k") == -1 && v.x == 1 && v.y == 1 &&
                            !(u.x == 0 && u.y == 0);
                   })}},
      .is_false_by_definition = [](const Model& model) {
        const Vector u = vector_in(model, "u"), v = vector_in(model, "v");
        const Vector scaled = model.numbers.at("k") * u;
        return (compare_angle(u, v) < 0) != (compare_angle(scaled, v) < 0) ||
               (compare_angle(u, v) > 0) != (compare_angle(scaled, v) > 0);
      }};
}

const RegisteredQueries registered({tie_rule(Summand::P), tie_rule(Summand::Q), scaling(-1),
                                    scaling(0), scaling(1)});

}  // namespace

}  // namespace oplus::smt
