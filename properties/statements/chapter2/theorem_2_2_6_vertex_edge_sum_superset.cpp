// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/mixture.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter2/paths_across.hpp"
#include "properties/statements/places/open_sum.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

Outcome check(const Summands& summands) {
  Outcome outcome;
  OpenSum open_sum(summands);
  for (const std::vector<Segment>& path : paths_across(summands)) {
    for (const Segment& piece : path) {
      ++outcome.counts["pieces of paths"];
      const Point middle = midpoint(piece.source, piece.target);
      const bool is_inside = open_sum.contains(middle);
      if (is_inside) ++outcome.counts["of these in the open sum"];
      for (const Rational& at : {Rational(1, 16), Rational(1, 3), Rational(15, 16)}) {
        const Point x = piece.source + at * direction_of(piece);
        if (open_sum.contains(x) == is_inside) continue;
        return outcome.fail(
            "of " + to_string(middle) + " and " + to_string(x) +
                " one is in the open sum, and no segment of the vertex-edge sum is between them",
            x);
      }
    }
  }
  return outcome;
}

const Registered registered({
    .id = "theorem-2.2.6",
    .title = "The vertex-edge sum contains the boundary of the sum",
    .statement =
        "Every point on the boundary of the sum of the open regions, dangling edges and isolated "
        "vertices included, is on a segment of the vertex-edge sum. So along any path, whether a "
        "point is in the sum changes only where the path meets the vertex-edge sum.",
    .why =
        "A boundary point is the sum of boundary points of P and of Q (Corollary 2.2.3). If both "
        "were inside edges of different directions, it would be interior (Lemma 2.2.5); the sum "
        "of two edges of one direction is one segment, which the sums of the longer edge and the "
        "ends of the other one cover (Equation 2.1). So it is a sum of a vertex and a point of an "
        "edge.",
    .hypotheses = {"P and Q are valid regions, holes, components and collinear vertices allowed"},
    .rests_on = {"corollary-2.2.3", "lemma-2.2.5", "equation-2.1"},
    .sources = small_mixture(),
    .promises = promises_of_mixture(),
    .kills = {"vertices-of-p-are-left-out"},
    .cases = 200,
    .check = check,
});

}  // namespace

}  // namespace oplus
