// SPDX-License-Identifier: GPL-3.0-or-later
// e is an edge of P, in and out those at a vertex q of Q. A point inside e plus q is also
// (p - m) + (q + m), and for small m these are inside P and Q iff m points to the right of e and into
// the sector at q.
#include "properties/proofs/smt/built_regions.hpp"
#include "properties/proofs/smt/sectors.hpp"
#include "reference/definitions/collision.hpp"

namespace oplus::smt {

namespace {

const Vectors e = direction("e"), in = direction("in"), out = direction("out");

const Claim slides_outwards = is_right(e, out), slides_back = is_right(e, opposite(in)),
            slides = any_of({slides_outwards, slides_back});

const Claim is_kept = is_in_tangent_set(e, Summand::P, corner());

Claim is_to_the_right_and_inside(const Vectors& m) {
  return all_of({is_right(e, m), is_in_sector(m, corner())});
}

bool interiors_meet_at_vertex(const Model& model) {
  return interiors_meet(region_with_edge(direction_in(model, "e"), 1),
                        reflected(region_with_corner(corner_in(model))));
}

bool is_in_convolution(const Model& model) {
  return in_tangent_set({direction_in(model, "e"), Summand::P}, corner_in(model));
}

const std::vector<Unknown> edge_and_corner = {any_direction("e"), any_direction("in"),
                                              any_direction("out")};

const Hypothesis turns = {
    "turns", {"the corner of in and out does not turn back", negation(turns_back(corner()))}};

const Hypothesis convex = {"convex",
                           {"the vertex is not reflex", negation(is_a_reflex_vertex(corner()))}};

const Hypothesis apart = {"apart",
                          {"e is parallel to neither edge at the vertex",
                           negation(any_of({are_parallel(e, in), are_parallel(e, out)}))}};

/// Ties included; that is what slide's own-edge rule rests on (step-interval.own-edge).
Query nothing_slides_what_is_kept(Summand of) {
  return {.id = std::string("lemma-2.2.9.nothing-slides-what-is-kept-of-") +
                (of == Summand::P ? "p" : "q"),
          .unknowns = edge_and_corner,
          .hypotheses = {convex,
                         {"kept",
                          {"e is in the tangent set of the vertex",
                           is_in_tangent_set(e, of, corner())}}},
          .conclusion = {"neither out nor the reverse of in points to the right of e",
                         negation(slides)},
          .is_false_by_definition = [](const Model& model) {
            const Corner corner = corner_in(model);
            const Vector edge = direction_in(model, "e");
            return sign(cross(edge, corner.out)) < 0 || sign(cross(edge, -corner.in)) < 0;
          }};
}

const Condition not_sliding_either = {
    "nothing slides e, and the vertex is convex",
    all_of({negation(slides), negation(is_a_reflex_vertex(corner()))})};

const RegisteredQueries registered({
    nothing_slides_what_is_kept(Summand::P),
    nothing_slides_what_is_kept(Summand::Q),
    {.id = "lemma-2.2.9.edge-that-leaves",
     .unknowns = edge_and_corner,
     .hypotheses =
         {turns,
          {"slides", {"out points to the right of e", slides_outwards}, {not_sliding_either}}},
     .conclusion = {"out + e or out - in points right of e and into the sector",
                    one_is_in({sum(out, e), sum(out, opposite(in))}, is_to_the_right_and_inside)},
     .is_false_by_definition = std::not_fn(interiors_meet_at_vertex)},
    {.id = "lemma-2.2.9.edge-that-enters",
     .unknowns = edge_and_corner,
     .hypotheses = {turns,
                    {"slides",
                     {"the reverse of in points to the right of e", slides_back},
                     {not_sliding_either}}},
     .conclusion = {"- in - e or out - in points right of e and into the sector",
                    one_is_in({opposite(sum(in, e)), sum(out, opposite(in))},
                              is_to_the_right_and_inside)},
     .is_false_by_definition = std::not_fn(interiors_meet_at_vertex)},
    {.id = "lemma-2.2.9.kept-where-nothing-slides",
     .unknowns = edge_and_corner,
     .hypotheses = {apart,
                    {"still",
                     {"neither out nor the reverse of in points to the right of e",
                      negation(slides)}}},
     .conclusion = {"e is in the tangent set of the vertex", is_kept},
     .is_false_by_definition = std::not_fn(is_in_convolution)},
    {.id = "lemma-2.2.9.not-kept-where-a-convex-vertex-slides",
     .unknowns = edge_and_corner,
     .hypotheses = {convex,
                    {"slides", {"out or the reverse of in points to the right of e", slides}}},
     .conclusion = {"e is not in the tangent set of the vertex", negation(is_kept)},
     .is_false_by_definition = is_in_convolution},
    {.id = "lemma-2.2.9.kept-by-a-convex-vertex",
     .unknowns = {any_direction("e"), any_direction("in"), any_direction("out"),
                  any_direction("m")},
     .hypotheses = {convex, {"kept", {"e is in the tangent set of the vertex", is_kept}}},
     .conclusion = {"m does not point right of e and into the sector",
                    negation(is_to_the_right_and_inside(direction("m")))},
     .is_false_by_definition = interiors_meet_at_vertex},
});

}  // namespace

}  // namespace oplus::smt
