// SPDX-License-Identifier: GPL-3.0-or-later
// e is an edge of one summand, the corner at a vertex of the other. A point of the edge's inside plus
// the vertex is also (p - m) + (q + m), and for small m these are inside iff m points to the right of
// e and into the corner's sector.
#include "properties/proofs/smt/built_regions.hpp"
#include "properties/proofs/smt/sectors.hpp"
#include "reference/definitions/collision.hpp"

namespace oplus::smt {

namespace {

const Vectors d = direction("d"), e = direction("e"), in = direction("in"), out = direction("out");

const Claim is_reflex_here = is_a_reflex_vertex(corner());

/// What the sector is in half planes, which does not depend on how angles are compared.
Query sector(bool is_reflex) {
  const std::vector<Claim> left_of_edges = {is_left(in, d), is_left(out, d)};
  return {.id = std::string("theorem-2.3.2.sector-of-a-") + (is_reflex ? "reflex" : "convex") +
                "-vertex",
          .unknowns = {any_direction("in"), any_direction("out"), any_direction("d")},
          .hypotheses = {{"vertex",
                          {std::string("the vertex is ") + (is_reflex ? "" : "not ") + "reflex",
                           is_reflex ? is_reflex_here : negation(is_reflex_here)}}},
          .conclusion = {std::string("d is in the sector iff it is to the left of ") +
                             (is_reflex ? "one of the edges, or both" : "both edges"),
                         same(is_in_sector(d, corner()),
                              is_reflex ? any_of(left_of_edges) : all_of(left_of_edges))},
          .is_false_by_definition = [is_reflex](const Model& model) {
            const Corner corner = corner_in(model);
            const Vector towards = direction_in(model, "d");
            const Rational little(1, 1'000'000'007);
            const Rational length = abs(towards.x) + abs(towards.y);
            const Point near = Rational(little / length) * towards;
            const bool is_inside = locate(near, region_with_corner(corner)) == Location::inside;
            const bool left_of_in = sign(cross(corner.in, towards)) > 0;
            const bool left_of_out = sign(cross(corner.out, towards)) > 0;
            return is_inside != (is_reflex ? left_of_in || left_of_out : left_of_in && left_of_out);
          }};
}

const RegisteredQueries registered({
    sector(true),
    sector(false),
    {.id = "theorem-2.3.2.reflex-vertex",
     .unknowns = {any_direction("e"), any_direction("in"), any_direction("out")},
     .hypotheses = {{"reflex",
                     {"the vertex is reflex", is_reflex_here},
                     {{"e is in the tangent set of the corner",
                       is_in_tangent_set(e, Summand::P, corner())}}}},
     .conclusion = {"e + in, e + out, an opposite of these, or a vector to the right of e points "
                    "right of e and into the sector",
                    one_is_in({sum(e, in), sum(e, out), opposite(sum(e, in)), opposite(sum(e, out)),
                               opposite(leftwards(e))},
                              [](const Vectors& m) {
                                return all_of({is_right(e, m), is_in_sector(m, corner())});
                              })},
     .is_false_by_definition =
         [](const Model& model) {
           return !interiors_meet(region_with_edge(direction_in(model, "e"), 1),
                                  reflected(region_with_corner(corner_in(model))));
         }},
});

}  // namespace

}  // namespace oplus::smt
