// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter2/paths_across.hpp"
#include "properties/statements/placements/open_sum.hpp"
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

const Registered registered(small_mixture(), {.id = "theorem-2.2.6",
                                              .kills = {"vertices-of-p-are-left-out"},
                                              .cases = 80,
                                              .check = check});

}  // namespace

}  // namespace oplus
