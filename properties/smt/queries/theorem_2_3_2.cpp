// SPDX-License-Identifier: GPL-3.0-or-later
// e is an edge of one summand, the corner at a vertex of the other. A point of the edge's inside plus
// the vertex is also (p - m) + (q + m), and for small m these are inside iff m points to the right of
// e and into the corner's sector.
#include "properties/smt/built_regions.hpp"
#include "properties/smt/sectors.hpp"
#include "reference/definitions/collision.hpp"

namespace oplus::smt {

namespace {

Corners corner_of(const Values& values) {
  return {direction(values, "in"), direction(values, "out")};
}

const RegisteredQueries registered({
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
     .file = __FILE__,
     .is_false_by_definition =
         [](const Model& model) {
           const Corner corner{direction_in(model, "in"), direction_in(model, "out")};
           return !interiors_meet(region_with_edge(direction_in(model, "e"), 1),
                                  reflected(region_with_corner(corner)));
         }},
});

}  // namespace

}  // namespace oplus::smt
