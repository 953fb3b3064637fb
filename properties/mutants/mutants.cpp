// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/mutants/mutants.hpp"

namespace oplus {

const std::vector<Mutant>& mutants() {
  static const std::vector<Mutant> all = {
      {"acute-vertex-is-reflex", "a vertex with an acute interior angle is taken for reflex",
       "reference/definitions/tangent_set.cpp"},
      {"candidates-need-no-hole-test", "every face with an orientable boundary is taken for a hole",
       "checked/rca/rca.cpp"},
      {"parallel-edges-do-not-collide",
       "interiors that meet along edges of equal direction only are missed",
       "reference/definitions/collision.cpp"},
      {"ray-counts-both-ends", "a ray through a vertex counts both edges that meet there",
       "reference/definitions/winding_number.cpp"},
      {"reflex-turns-clockwise", "a reflex vertex's tangent set is the smaller angle at it",
       "reference/definitions/tangent_set.cpp"},
      {"tangent-set-without-ties", "equal directions are never in a tangent set",
       "reference/definitions/tangent_set.cpp"},
      {"tie-rule-depends-on-who-asks",
       "whichever summand has the edge, its direction comes before an equal one of the vertex",
       "reference/definitions/convolution.cpp"},
      {"touching-points-are-not-tested",
       "isolated vertices are looked for on the reduced convolution only", "checked/rca/rca.cpp"},
      {"weak-intersections-never-meet",
       "boundaries that meet without a proper crossing are taken to touch only",
       "checked/collision/hierarchy_collision.cpp"},
  };
  return all;
}

}  // namespace oplus
