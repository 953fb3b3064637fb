// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include "properties/runner/registry.hpp"
#include "properties/statements/placements/open_sum.hpp"
#include "properties/statements/placements/overlay.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/exact_box.hpp"
#include "reference/definitions/segment.hpp"
#include "reference/families/family.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Straight paths that cross the whole sum, each cut wherever it meets the vertex-edge sum. Some
/// run through ends of its segments and along segments: those are the difficult ones.
std::vector<std::vector<Segment>> paths_across(const Summands& summands) {
  const std::vector<Segment> all = segments(vertex_edge_sum(summands.p, summands.q));
  const auto [low, high] = box_around(all).enlarged(1);
  // Horizontal and vertical lines through sums of vertices, and two slanted ones, which hardly ever
  // pass through one.
  std::vector<Segment> paths = {{low, high}, {{low.x, high.y}, {high.x + Rational(1, 7), low.y}}};
  for (const std::size_t k : {all.size() / 3, 2 * all.size() / 3}) {
    const Point& through = all[k].source;
    paths.push_back({{low.x, through.y}, {high.x, through.y}});
    paths.push_back({{through.x, low.y}, {through.x, high.y}});
  }
  std::vector<std::vector<Segment>> result;
  for (const Segment& path : paths) result.push_back(cut_where_met(path, all));
  return result;
}

/// Whether a is in the interior of one region and in the other region, boundary included.
bool is_interior_source(const OverlaidPoint& a) {
  return (a.is_in(0, true) && a.is_in(1, false)) || (a.is_in(1, true) && a.is_in(0, false));
}

Outcome check_boundary_sources(const Summands& summands) {
  Outcome outcome;
  OpenSum open_sum(summands);
  const Region reflected_q = reflected(summands.q);
  bool meets_the_sum = false;
  for (const std::vector<Segment>& path : paths_across(summands)) {
    // In turn, a point where a path meets the vertex-edge sum, and one where it does not.
    const Segment& piece = path[path.size() / 2];
    meets_the_sum = !meets_the_sum;
    const Point x = meets_the_sum ? piece.source : midpoint(piece.source, piece.target);
    const bool is_in_sum = open_sum.contains(x);
    ++outcome.counts[is_in_sum ? "points of the open sum" : "other points"];
    for (const OverlaidPoint& a : overlaid({summands.p, translated(reflected_q, x)})) {
      if (a.in[0] == Location::boundary && a.in[1] == Location::boundary)
        ++outcome.counts["sources on both boundaries"];
      if (is_in_sum || !is_interior_source(a)) continue;
      return outcome.fail("the collision test says that " + to_string(x) +
                              " is not in the open sum, but it is the sum of " +
                              to_string(a.point) + " of P and " + to_string(x - a.point) +
                              " of Q, one of them an interior point",
                          x);
    }
  }
  return outcome;
}

const Registered lemma_2_2_2(small_mixture(), {.id = "lemma-2.2.2",
                                               .kills = {"containment-is-no-collision"},
                                               .cases = 200,
                                               .check = check_boundary_sources});

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

Outcome check_sums_of_boundary_points(const Summands& summands) {
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

const Registered corollary_2_2_3(small_mixture(), {.id = "corollary-2.2.3",
                                                   .kills = {"ends-are-not-on-their-segment"},
                                                   .cases = 200,
                                                   .check = check_sums_of_boundary_points});

Outcome check_vertex_edge_sum_superset(const Summands& summands) {
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

const Registered theorem_2_2_6(small_mixture(), {.id = "theorem-2.2.6",
                                                 .kills = {"vertices-of-p-are-left-out"},
                                                 .cases = 80,
                                                 .check = check_vertex_edge_sum_superset});

}  // namespace

}  // namespace oplus
