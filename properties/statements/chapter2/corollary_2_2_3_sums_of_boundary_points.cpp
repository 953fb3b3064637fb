// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "properties/runner/registry.hpp"
#include "properties/statements/chapter2/paths_across.hpp"
#include "properties/statements/placements/open_sum.hpp"
#include "properties/statements/placements/overlay.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

constexpr std::size_t most_points = 8;  // per pair

/// Some points on the boundary of the closed sum: where a straight path enters or leaves the open
/// one, which is decided by collision tests.
std::vector<Point> some_boundary_points(const Summands& summands) {
  std::vector<Point> points;
  OpenSum open_sum(summands);
  for (const std::vector<Segment>& path : paths_across(summands)) {
    bool was_inside = false;
    for (const Segment& piece : path) {
      const bool is_inside = open_sum.contains(midpoint(piece.source, piece.target));
      if (is_inside != was_inside) points.push_back(piece.source);
      was_inside = is_inside;
    }
  }
  return points;
}

Outcome check(const Summands& summands) {
  Outcome outcome;
  const Region reflected_q = reflected(summands.q);
  const std::vector<Point> all = some_boundary_points(summands);
  const std::size_t looked_at = std::min(all.size(), most_points);
  for (std::size_t k = 0; k < looked_at; ++k) {
    const Point& x = all[k * all.size() / looked_at];
    std::size_t sources = 0, on_boundaries = 0;
    for (const auto& [a, in] : overlaid({summands.p, translated(reflected_q, x)})) {
      if (in[0] == Location::outside || in[1] == Location::outside) continue;
      ++sources;
      if (in[0] == Location::boundary && in[1] == Location::boundary) ++on_boundaries;
    }
    ++outcome.counts["boundary points"];
    outcome.counts["their sources"] += sources;
    if (sources > 0 && sources == on_boundaries) continue;
    return outcome.fail("the boundary point " + to_string(x) + " has " + std::to_string(sources) +
                            " sources, of which " + std::to_string(on_boundaries) +
                            " are sums of boundary points",
                        x);
  }
  return outcome;
}

const Registered registered(small_mixture(), {.id = "corollary-2.2.3",
                                              .kills = {"ends-are-not-on-their-segment"},
                                              .cases = 200,
                                              .check = check});

}  // namespace

}  // namespace oplus
