// SPDX-License-Identifier: GPL-3.0-or-later
// e is an edge of P, in and out those at a vertex q of Q. A point inside e plus q is also
// (p - m) + (q + m), and for small m these are inside P and Q iff m points to the right of e and into
// the sector at q.
#include "properties/proofs/smt/built_regions.hpp"
#include "properties/proofs/smt/sectors.hpp"
#include "reference/definitions/collision.hpp"

namespace oplus::smt {

namespace {

Corners corner_of(const Values& values) {
  return {direction(values, "in"), direction(values, "out")};
}

Vectors edge(const Values& values) { return direction(values, "e"); }

Formula slides_outwards(const Values& values) {
  return is_right(edge(values), corner_of(values).out);
}

Formula slides_back(const Values& values) {
  return is_right(edge(values), opposite(corner_of(values).in));
}

Formula slides(const Values& values) {
  return any_of({slides_outwards(values), slides_back(values)});
}

Formula is_kept(const Values& values) {
  return is_in_tangent_set(edge(values), Summand::P, corner_of(values));
}

Formula is_to_the_right_and_inside(const Values& values, const Vectors& m) {
  return all_of({is_right(edge(values), m), is_in_sector(m, corner_of(values))});
}

Corner corner_in(const Model& model) {
  return {direction_in(model, "in"), direction_in(model, "out")};
}

bool interiors_meet_at_vertex(const Model& model) {
  return interiors_meet(region_with_edge(direction_in(model, "e"), 1),
                        reflected(region_with_corner(corner_in(model))));
}

bool is_in_convolution(const Model& model) {
  return in_tangent_set({direction_in(model, "e"), Summand::P}, corner_in(model));
}

const std::vector<Unknown> edge_and_corner = {{"e", Unknown::Kind::direction},
                                              {"in", Unknown::Kind::direction},
                                              {"out", Unknown::Kind::direction}};

const Hypothesis turns = {"turns",
                          {"the corner of in and out does not turn back", [](const Values& values) {
                             return negation(turns_back(corner_of(values)));
                           }}};

const Hypothesis convex = {"convex", {"the vertex is not reflex", [](const Values& values) {
                                        return negation(is_a_reflex_vertex(corner_of(values)));
                                      }}};

const Hypothesis apart = {"apart",
                          {"e is parallel to neither edge at the vertex", [](const Values& values) {
                             const Corners corner = corner_of(values);
                             return negation(any_of({are_parallel(edge(values), corner.in),
                                                     are_parallel(edge(values), corner.out)}));
                           }}};

/// Ties included; that is what slide's own-edge rule rests on (step-interval.own-edge).
Query nothing_slides_what_is_kept(Summand of) {
  const auto is_kept_of = [of](const Values& values) {
    return is_in_tangent_set(edge(values), of, corner_of(values));
  };
  return {.id = std::string("lemma-2.2.9.nothing-slides-what-is-kept-of-") +
                (of == Summand::P ? "p" : "q"),
          .statement = "lemma-2.2.9",
          .unknowns = edge_and_corner,
          .hypotheses = {turns,
                         convex,
                         {"kept", {"e is in the tangent set of the vertex", is_kept_of}}},
          .conclusion = {"neither out nor the reverse of in points to the right of e",
                         [](const Values& values) { return negation(slides(values)); }},
          .dropped = "convex",
          .is_false_by_definition = [of](const Model& model) {
            const Corner corner = corner_in(model);
            const Vector e = direction_in(model, "e");
            return in_tangent_set({e, of}, corner) &&
                   (sign(cross(e, corner.out)) < 0 || sign(cross(e, -corner.in)) < 0);
          }};
}

const Condition not_sliding_either = {
    "nothing slides e, and the vertex is convex", [](const Values& values) {
      return all_of({negation(slides(values)), negation(is_a_reflex_vertex(corner_of(values)))});
    }};

const RegisteredQueries registered({
    nothing_slides_what_is_kept(Summand::P),
    nothing_slides_what_is_kept(Summand::Q),
    {.id = "lemma-2.2.9.edge-that-leaves",
     .statement = "lemma-2.2.9",
     .unknowns = edge_and_corner,
     .hypotheses = {turns, {"slides", {"out points to the right of e", slides_outwards}}},
     .conclusion = {"out + e or out - in points right of e and into the sector",
                    [](const Values& values) {
                      const Corners corner = corner_of(values);
                      return one_is_in(
                          {sum(corner.out, edge(values)), sum(corner.out, opposite(corner.in))},
                          [&](const Vectors& m) { return is_to_the_right_and_inside(values, m); });
                    }},
     .dropped = "slides",
     .of_twin = {not_sliding_either},
     .is_false_by_definition = [](const Model& model) { return !interiors_meet_at_vertex(model); }},
    {.id = "lemma-2.2.9.edge-that-enters",
     .statement = "lemma-2.2.9",
     .unknowns = edge_and_corner,
     .hypotheses = {turns, {"slides", {"the reverse of in points to the right of e", slides_back}}},
     .conclusion = {"- in - e or out - in points right of e and into the sector",
                    [](const Values& values) {
                      const Corners corner = corner_of(values);
                      return one_is_in(
                          {opposite(sum(corner.in, edge(values))),
                           sum(corner.out, opposite(corner.in))},
                          [&](const Vectors& m) { return is_to_the_right_and_inside(values, m); });
                    }},
     .dropped = "slides",
     .of_twin = {not_sliding_either},
     .is_false_by_definition = [](const Model& model) { return !interiors_meet_at_vertex(model); }},
    {.id = "lemma-2.2.9.kept-where-nothing-slides",
     .statement = "lemma-2.2.9",
     .unknowns = edge_and_corner,
     .hypotheses = {apart,
                    {"still",
                     {"neither out nor the reverse of in points to the right of e",
                      [](const Values& values) { return negation(slides(values)); }}}},
     .conclusion = {"e is in the tangent set of the vertex", is_kept},
     .dropped = "still",
     .is_false_by_definition = [](const Model& model) { return !is_in_convolution(model); }},
    {.id = "lemma-2.2.9.not-kept-where-a-convex-vertex-slides",
     .statement = "lemma-2.2.9",
     .unknowns = edge_and_corner,
     .hypotheses = {apart,
                    convex,
                    {"slides", {"out or the reverse of in points to the right of e", slides}}},
     .conclusion = {"e is not in the tangent set of the vertex",
                    [](const Values& values) { return negation(is_kept(values)); }},
     .dropped = "convex",
     .is_false_by_definition = is_in_convolution},
    {.id = "lemma-2.2.9.kept-by-a-convex-vertex",
     .statement = "lemma-2.2.9",
     .unknowns = {edge_and_corner[0],
                  edge_and_corner[1],
                  edge_and_corner[2],
                  {"m", Unknown::Kind::direction}},
     .hypotheses = {turns, convex, {"kept", {"e is in the tangent set of the vertex", is_kept}}},
     .conclusion = {"m does not point right of e and into the sector",
                    [](const Values& values) {
                      return negation(is_to_the_right_and_inside(values, direction(values, "m")));
                    }},
     .dropped = "kept",
     .is_false_by_definition = interiors_meet_at_vertex},
});

}  // namespace

}  // namespace oplus::smt
