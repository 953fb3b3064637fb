// SPDX-License-Identifier: GPL-3.0-or-later
// That the tie rule is what it is called, an infinitesimal turn of Q's directions; and that nothing
// depends on how long vectors are, which lets all other queries take one vector of each direction.
#include "properties/proofs/smt/sectors.hpp"
#include "reference/definitions/cyclic_order.hpp"
#include "reference/definitions/tangent_set.hpp"

namespace oplus::smt {

namespace {

Corners corner_of(const Values& values) {
  return {direction(values, "in"), direction(values, "out")};
}

/// e is turned to f, if e is an edge of Q; if it is of P, f is turned to e, as the corner of Q is past it.
bool turns_counterclockwise(Summand of) { return of == Summand::Q; }

/// f is so near that none of the edges' directions, nor their opposites, is between or equal to f.
Formula is_turned_a_little(const Values& values, Summand of) {
  const Vectors e = direction(values, "e"), f = direction(values, "f");
  const Vectors from = turns_counterclockwise(of) ? e : f, to = turns_counterclockwise(of) ? f : e;
  std::vector<Formula> parts = {is_left(from, to)};
  for (const std::string name : {"in", "out"}) {
    for (const Vectors& other : {direction(values, name), opposite(direction(values, name))}) {
      parts.push_back(negation(are_equal(f, other)));
      parts.push_back(negation(all_of({is_left(from, other), is_left(other, to)})));
    }
  }
  return all_of(parts);
}

Query tie_rule(Summand of) {
  const std::string letter = of == Summand::P ? "p" : "q";
  return {.id = "definition-2.2.7-and-2.2.8.tie-rule-" + letter,
          .statement = "definition-2.2.7-and-2.2.8",
          .unknowns = {{"e", Unknown::Kind::direction},
                       {"f", Unknown::Kind::direction},
                       {"in", Unknown::Kind::direction},
                       {"out", Unknown::Kind::direction}},
          .hypotheses = {{"turned",
                          {std::string("f is e turned a little ") +
                               (turns_counterclockwise(of) ? "counterclockwise" : "clockwise"),
                           [of](const Values& values) { return is_turned_a_little(values, of); }}},
                         {"not-straight",
                          {"in and out have different directions",
                           [](const Values& values) {
                             return negation(
                                 are_equal(direction(values, "in"), direction(values, "out")));
                           }}}},
          .conclusion = {"e is in the tangent set of the corner iff f is",
                         [of](const Values& values) {
                           const Corners corner = corner_of(values);
                           return same(is_in_tangent_set(direction(values, "e"), of, corner),
                                       is_in_tangent_set(direction(values, "f"), of, corner));
                         }},
          .dropped = "turned",
          .is_false_by_definition = [of](const Model& model) {
            const Corner corner{direction_in(model, "in"), direction_in(model, "out")};
            return in_tangent_set({direction_in(model, "e"), of}, corner) !=
                   in_tangent_set({direction_in(model, "f"), of}, corner);
          }};
}

Formula is_positive(const Values& values) {
  return Formula::sign_of(values.number("k"), {.positive = true});
}

Formula angles_compare(const TermVector& u, const TermVector& v, int how) {
  return executed([&] { return sign(Term(cyclic_order::compare_angle(u, v))) == how; });
}

/// k u instead of u.
Query scaling(int how) {
  const std::string name = how < 0 ? "before" : how > 0 ? "after" : "equal";
  return {.id = "definition-2.2.7-and-2.2.8.scaling-" + name,
          .statement = "definition-2.2.7-and-2.2.8",
          .unknowns = {{"k", Unknown::Kind::number},
                       {"u", Unknown::Kind::vector},
                       {"v", Unknown::Kind::vector}},
          .hypotheses = {{"positive", {"k > 0", is_positive}},
                         {"order",
                          {"comparing the angles of u and v gives " + std::to_string(how),
                           [how](const Values& values) {
                             return angles_compare(values.vector("u"), values.vector("v"), how);
                           }}}},
          .conclusion = {"so does comparing those of k u and v",
                         [how](const Values& values) {
                           return angles_compare(values.number("k") * values.vector("u"),
                                                 values.vector("v"), how);
                         }},
          .dropped = "positive",
          .of_twin = {{"k = -1 and v = (1, 1), and u is not zero",
                       [](const Values& values) {
                         const TermVector u = values.vector("u"), v = values.vector("v");
                         return executed([&] {
                           return values.number("k") == -1 && v.x == 1 && v.y == 1 &&
                                  !(u.x == 0 && u.y == 0);
                         });
                       }}},
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
