// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter4/points_in_faces.hpp"
#include "properties/statements/placements/open_sum.hpp"
#include "properties/statements/placements/overlay.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/definitions/exact_box.hpp"
#include "reference/definitions/intersection_components.hpp"
#include "reference/definitions/original_convolution.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Fails where a point is entered more or less often than it is left.
void expect_cycles(const std::vector<ConvolutionSegment>& convolution, Outcome& outcome) {
  std::map<Point, int> surplus;
  for (const ConvolutionSegment& s : convolution) {
    ++surplus[s.segment.source];
    --surplus[s.segment.target];
  }
  outcome.counts["segments"] += convolution.size();
  outcome.counts["points"] += surplus.size();
  for (const auto& [point, leaving_less_entering] : surplus) {
    if (leaving_less_entering == 0) continue;
    outcome.fail(to_string(point) + " is left " + std::to_string(leaving_less_entering) +
                     " times more often than it is entered",
                 point);
    return;
  }
}

Outcome check_flip_sets_are_cycles(const Summands& summands) {
  const auto& [p, q] = summands;
  Outcome outcome;
  for (const ReflexVertex& vertex : reflex_vertices(p, q)) {
    ++outcome.counts["reflex vertices"];
    expect_cycles(replaced_at(vertex, p, q), outcome);
    if (outcome.kind == Outcome::Kind::fails) return outcome;
  }
  expect_cycles(original_convolution(p, q), outcome);
  return outcome;
}

const Registered lemma_4_2_13(larger_mixture(),
                              {.id = "lemma-4.2.13",
                               .kills = {"flip-set-keeps-its-direction", "tangent-set-without-ties",
                                         "tie-rule-depends-on-who-asks"},
                               .cases = 1500,
                               .check = check_flip_sets_are_cycles});

bool is_simple_polygon(const Region& region) { return chains(region).size() == 1; }

Outcome check_winding_number_counts_components(const Summands& summands) {
  const auto& [p, q] = summands;
  if (!is_simple_polygon(p) || !is_simple_polygon(q))
    return {Outcome::Kind::discarded, "not two simple polygons", {}};
  Outcome outcome;
  const std::vector<Segment> original = segments(original_convolution(p, q));
  for (const Point& x : generic_placements(summands)) {
    const ComponentsAndHoles seen = intersection_components(p, q, x);
    const int winding = winding_number(x, original);
    ++outcome.counts[seen.components < 2 ? counted(seen.components, "component", "components")
                                         : "two components or more"];
    if (winding == static_cast<int>(seen.components) && seen.holes == 0) continue;
    return outcome.fail("at " + to_string(x) + " the winding number is " + std::to_string(winding) +
                            " and the intersection has " +
                            counted(seen.components, "component", "components") + " and " +
                            counted(seen.holes, "hole", "holes"),
                        x);
  }
  return outcome;
}

const Registered theorem_4_2_14({
    .id = "theorem-4.2.14",
    .sources = {{"grid", 8, 6},
                {"simple", 7, 2},
                {"star", 7, 1},
                {"convex", 7, 1},
                {"comb", 3, 1},
                {"fork", 2, 1}},
    .promises = {{"reflex vertices", 10}, {"parallel edges", 40}, {"overlapping segments", 5}},
    .kills = {"flip-set-keeps-its-direction", "reflex-vertices-of-q-are-not-replaced",
              "reflex-turns-clockwise", "tangent-set-without-ties"},
    .cases = 1000,
    .check = check_winding_number_counts_components,
});

Point point_at(const VertexIndex& v, const Region& region) {
  return chains(region)[v.chain][v.vertex];
}

Outcome check_winding_number_inside(const Summands& summands) {
  const auto& [p, q] = summands;
  const std::vector<Segment> before = segments(convolution(p, q));
  const std::vector<Point> points = generic_placements(summands);
  std::vector<int> winding;
  for (const Point& x : points) winding.push_back(winding_number(x, before));
  Outcome outcome;
  outcome.counts["points"] = points.size();
  for (const ReflexVertex& vertex : reflex_vertices(p, q)) {
    const bool of_p = vertex.of == Summand::P;
    const std::vector<Segment> after = segments(replaced_at(vertex, p, q));
    const Region swept = translated(of_p ? q : p, point_at(vertex.vertex, of_p ? p : q));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool inside = locate(points[i], swept) == Location::inside;
      const int now = winding_number(points[i], after);
      ++outcome.counts[inside ? "comparisons inside" : "comparisons outside"];
      if (now == winding[i] - (inside ? 1 : 0)) continue;
      return outcome.fail("the replacement at " + to_string(point_at(vertex.vertex, of_p ? p : q)) +
                              " of " + (of_p ? "P" : "Q") + " changes the winding number at " +
                              to_string(points[i]) + (inside ? ", inside," : ", outside,") +
                              " from " + std::to_string(winding[i]) + " to " + std::to_string(now),
                          points[i]);
    }
  }
  return outcome;
}

const Registered lemma_4_2_15(small_mixture(),
                              {.id = "lemma-4.2.15",
                               .kills = {"flip-set-keeps-its-direction", "ray-counts-both-ends"},
                               .cases = 500,
                               .check = check_winding_number_inside});

/// Points with coordinates low + k/parts (high - low), drawn with a fixed seed, so that a pair
/// always gets the same ones. With few parts many rays run through vertices.
std::vector<Point> lattice_points(const std::vector<Segment>& segments, int parts,
                                  std::size_t number) {
  if (segments.empty()) return {};
  const ExactBox box = box_around(segments);
  Random random(static_cast<std::uint64_t>(parts));
  const auto draw = [&](const Rational& from, const Rational& to) {
    return Rational(from + Rational(uniform(random, 0, parts)) / parts * (to - from));
  };
  std::vector<Point> points;
  for (std::size_t i = 0; i < number; ++i) {
    Rational x = draw(box.low.x, box.high.x);
    points.push_back({std::move(x), draw(box.low.y, box.high.y)});
  }
  return points;
}

/// The placements at which two vertices meet.
std::vector<Point> vertex_sums(const Summands& summands) {
  std::set<Point> sums;
  for (const Segment& e : edges(summands.p))
    for (const Segment& f : edges(summands.q)) sums.insert(e.source + f.source);
  return {sums.begin(), sums.end()};
}

class Comparison {
 public:
  explicit Comparison(const Summands& summands)
      : convolution_(segments(convolution(summands.p, summands.q))),
        vertex_sums_(vertex_sums(summands)),
        open_sum_(summands) {}

  Outcome run() {
    compare(points_beside(convolution_), "points beside segments");
    compare(vertex_sums_, "vertex sums");
    compare(lattice_points(convolution_, 12, 16), "points of a coarse lattice");
    compare(lattice_points(convolution_, 1009, 8), "points of a fine lattice");
    return std::move(outcome_);
  }

 private:
  void compare(const std::vector<Point>& points, const std::string& name) {
    for (const Point& x : points) {
      if (outcome_.kind == Outcome::Kind::fails) return;
      const bool on_convolution = std::any_of(convolution_.begin(), convolution_.end(),
                                              [&](const Segment& s) { return lies_on(x, s); });
      ++outcome_.counts[on_convolution ? "points skipped on the convolution" : name];
      if (!on_convolution) compare(x);
    }
  }

  void compare(const Point& x) {
    const int winding = winding_number(x, convolution_);
    const bool meet = open_sum_.contains(x);
    ++outcome_.counts[meet ? "points in the sum" : "points outside"];
    if (winding >= 0 && (winding > 0) == meet) return;
    outcome_.fail("at " + to_string(x) + " the winding number is " + std::to_string(winding) +
                      " and the interiors of P and -Q+x " + (meet ? "meet" : "do not meet"),
                  x);
  }

  std::vector<Segment> convolution_;
  std::vector<Point> vertex_sums_;
  OpenSum open_sum_;
  Outcome outcome_;
};

/// What the theorem says of a result: a point in every face of the convolution's arrangement, which
/// the result's edges cut further, is inside iff its winding number is positive.
Outcome law_of_winding_numbers(const Sum& sum, const Summands& summands) {
  const PlanarSet result = sum(summands.p, summands.q);
  const std::vector<Segment> all = segments(convolution(summands.p, summands.q));
  std::vector<Segment> overlaid = all;
  const std::vector<Segment> of_result = edges(result);
  overlaid.insert(overlaid.end(), of_result.begin(), of_result.end());
  Outcome outcome;
  for (const Point& x : points_beside(overlaid)) {
    ++outcome.counts["points beside segments"];
    const int winding = winding_number(x, all);
    const Location location = locate(x, result);
    if (location == Location::boundary || (location == Location::inside) == (winding > 0)) continue;
    return outcome.fail("at " + to_string(x) + " the winding number is " + std::to_string(winding) +
                            ", and the point is " +
                            (location == Location::inside ? "in" : "not in") + " the sum",
                        x);
  }
  return outcome;
}

const Registered theorem_4_2_1(
    small_mixture(),
    {
        .id = "theorem-4.2.1",
        .kills = {"ray-counts-both-ends", "reflex-turns-clockwise", "tangent-set-without-ties",
                  "tie-rule-depends-on-who-asks"},
        .cases = 100,
        .check = [](const Summands& summands) { return Comparison(summands).run(); },
        .of_engine = for_one_engine(law_of_winding_numbers),
    });

}  // namespace

}  // namespace oplus
