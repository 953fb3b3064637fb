// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>
#include <utility>

#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/placements/open_sum.hpp"
#include "properties/statements/placements/points_beside.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/definitions/exact_box.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

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
Outcome law(const Sum& sum, const Summands& summands) {
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

const Registered registered(
    small_mixture(),
    {
        .id = "theorem-4.2.1",
        .kills = {"ray-counts-both-ends", "reflex-turns-clockwise", "tangent-set-without-ties",
                  "tie-rule-depends-on-who-asks"},
        .cases = 100,
        .check = [](const Summands& summands) { return Comparison(summands).run(); },
        .of_engine = for_one_engine(law),
    });

}  // namespace

}  // namespace oplus
