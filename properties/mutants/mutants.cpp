// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/mutants/mutants.hpp"

namespace oplus {

const std::vector<Mutant>& mutants() {
  static const std::vector<Mutant> all = {
      {"acute-vertex-is-reflex", "a vertex with an acute interior angle is taken for reflex",
       "reference/definitions/tangent_set.cpp"},
      {"candidates-need-no-hole-test", "every face with an orientable boundary is taken for a hole",
       "checked/rca/rca.cpp"},
      {"fallen-loops-have-an-inside",
       "a hole loop that is not on the boundary counts as a hole for the loops inside it",
       "checked/loops/nesting.cpp"},
      {"flip-set-keeps-its-direction",
       "the segments that replace those of a reflex vertex run along their edges",
       "reference/definitions/original_convolution.cpp"},
      {"holes-of-an-intersection-are-not-seen", "an intersection is taken for one without holes",
       "reference/definitions/intersection_components.cpp"},
      {"loops-turn-counterclockwise-most",
       "where loops meet, tracing takes the wrong way out of the vertex",
       "checked/loops/orientable_loops.cpp"},
      {"overlapping-segments-count-once",
       "crossing an edge of several segments changes the winding number by one",
       "checked/winding/winding_numbers.cpp"},
      {"parallel-edges-do-not-collide",
       "interiors that meet along edges of equal direction only are missed",
       "reference/definitions/collision.cpp"},
      {"ray-counts-both-ends", "a ray through a vertex counts both edges that meet there",
       "reference/definitions/winding_number.cpp"},
      {"rays-shift-down",
       "a ray at the height of a vertex passes below it, though it starts above",
       "checked/winding/ray_shooting.cpp"},
      {"rays-start-left-of-their-edge",
       "a ray from an edge starts in the face to its left",
       "checked/winding/ray_shooting.cpp"},
      {"reflex-turns-clockwise", "a reflex vertex's tangent set is the smaller angle at it",
       "reference/definitions/tangent_set.cpp"},
      {"reflex-vertices-of-q-are-not-replaced", "flip sets are taken at the reflex vertices of P only",
       "reference/definitions/original_convolution.cpp"},
      {"sweep-forgets-overlap-direction",
       "edges that overlap in opposite directions are taken for common interior",
       "checked/collision/sweep_collision.cpp"},
      {"sweep-ignores-weak-intersections",
       "boundaries that meet without a proper crossing are taken to touch only, by the sweep",
       "checked/collision/sweep_collision.cpp"},
      {"tangent-set-without-ties", "equal directions are never in a tangent set",
       "reference/definitions/tangent_set.cpp"},
      {"tie-rule-depends-on-who-asks",
       "whichever summand has the edge, its direction comes before an equal one of the vertex",
       "reference/definitions/convolution.cpp"},
      {"touching-points-are-not-tested",
       "isolated vertices are looked for on the reduced convolution only", "checked/arrangement/sum_boundary.cpp"},
      {"weak-intersections-never-meet",
       "boundaries that meet without a proper crossing are taken to touch only",
       "checked/collision/pairwise_collision.cpp"},
  };
  return all;
}

}  // namespace oplus
