// SPDX-License-Identifier: GPL-3.0-or-later
// e is an edge of one summand, the corner at a vertex of the other. A point of the edge's inside plus
// the vertex is also (p - m) + (q + m), and for small m these are inside iff m points to the right of
// e and into the corner's sector.
#include "properties/proofs/smt/built_regions.hpp"
#include "properties/proofs/smt/sectors.hpp"
#include "reference/definitions/collision.hpp"

namespace oplus::smt {

namespace {

Corners corner_of(const Values& values) {
  return {direction(values, "in"), direction(values, "out")};
}

const std::vector<Unknown> corner_and_direction = {{"in", Unknown::Kind::direction},
                                                   {"out", Unknown::Kind::direction},
                                                   {"d", Unknown::Kind::direction}};

const Hypothesis turns = {"turns", {"the corner does not turn back", [](const Values& values) {
                                      return negation(turns_back(corner_of(values)));
                                    }}};

Formula is_reflex_here(const Values& values) { return is_a_reflex_vertex(corner_of(values)); }

/// Left of both edges, or of one of them.
Formula is_left_of_edges(const Values& values, bool of_both) {
  const Vectors d = direction(values, "d");
  const std::vector<Formula> sides = {is_left(corner_of(values).in, d),
                                      is_left(corner_of(values).out, d)};
  return of_both ? all_of(sides) : any_of(sides);
}

/// What the sector is in half planes, which does not depend on how angles are compared.
Query sector(bool is_reflex) {
  return {.id = std::string("theorem-2.3.2.sector-of-a-") + (is_reflex ? "reflex" : "convex") +
                "-vertex",
          .statement = "theorem-2.3.2",
          .unknowns = corner_and_direction,
          .hypotheses = {turns,
                         {"vertex",
                          {std::string("the vertex is ") + (is_reflex ? "" : "not ") + "reflex",
                           [is_reflex](const Values& values) {
                             return same(Formula(is_reflex), is_reflex_here(values));
                           }}}},
          .conclusion = {std::string("d is in the sector iff it is to the left of ") +
                             (is_reflex ? "one of the edges, or both" : "both edges"),
                         [is_reflex](const Values& values) {
                           return same(is_in_sector(direction(values, "d"), corner_of(values)),
                                       is_left_of_edges(values, !is_reflex));
                         }},
          .dropped = "vertex",
          .is_false_by_definition = [is_reflex](const Model& model) {
            const Corner corner{direction_in(model, "in"), direction_in(model, "out")};
            const Vector d = direction_in(model, "d");
            const Rational little(1, 1'000'000'007);
            const Rational length = abs(d.x) + abs(d.y);
            const Point near = Rational(little / length) * d;
            const bool is_inside = locate(near, region_with_corner(corner)) == Location::inside;
            const bool in = sign(cross(corner.in, d)) > 0, out = sign(cross(corner.out, d)) > 0;
            return is_inside != (is_reflex ? in || out : in && out);
          }};
}

const RegisteredQueries registered({
    sector(true),
    sector(false),
    {.id = "theorem-2.3.2.reflex-vertex",
     .statement = "theorem-2.3.2",
     .unknowns = {{"e", Unknown::Kind::direction},
                  {"in", Unknown::Kind::direction},
                  {"out", Unknown::Kind::direction}},
     .hypotheses = {{"turns",
                     {"the corner does not turn back",
                      [](const Values& values) {
                        return negation(turns_back(corner_of(values)));
                      }}},
                    {"reflex",
                     {"the vertex is reflex",
                      [](const Values& values) { return is_a_reflex_vertex(corner_of(values)); }}}},
     .conclusion = {"e + in, e + out, an opposite of these, or a vector to the right of e points "
                    "right of e and into the sector",
                    [](const Values& values) {
                      const Corners corner = corner_of(values);
                      const Vectors e = direction(values, "e");
                      return one_is_in(
                          {sum(e, corner.in), sum(e, corner.out), opposite(sum(e, corner.in)),
                           opposite(sum(e, corner.out)), opposite(leftwards(e))},
                          [&](const Vectors& m) {
                            return all_of({is_right(e, m), is_in_sector(m, corner)});
                          });
                    }},
     .dropped = "reflex",
     .of_twin = {{"e is in the tangent set of the corner",
                  [](const Values& values) {
                    return is_in_tangent_set(direction(values, "e"), Summand::P, corner_of(values));
                  }}},
     .is_false_by_definition =
         [](const Model& model) {
           const Corner corner{direction_in(model, "in"), direction_in(model, "out")};
           return !interiors_meet(region_with_edge(direction_in(model, "e"), 1),
                                  reflected(region_with_corner(corner)));
         }},
});

}  // namespace

}  // namespace oplus::smt
