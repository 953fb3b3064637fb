// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "properties/runner/registry.hpp"
#include "properties/statements/chapter4/points_in_faces.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/tangent_count.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// So many of all, from beginning to end.
template <typename T>
std::vector<T> some_of(const std::vector<T>& all, std::size_t most) {
  const std::size_t n = std::min(all.size(), most);
  std::vector<T> result;
  for (std::size_t k = 0; k < n; ++k) result.push_back(all[k * all.size() / n]);
  return result;
}

/// A chain with neighbours exchanged: it may cross itself, or go round clockwise.
Chain entangled(Chain chain) {
  for (std::size_t i = 1; i + 1 < chain.size(); i += 3) std::swap(chain[i], chain[i + 1]);
  return chain;
}

Region entangled(Region region) {
  for (Component& component : region.components) {
    component.outer = entangled(component.outer);
    for (Chain& hole : component.holes) hole = entangled(hole);
  }
  return region;
}

void expect(const Summands& pair, Outcome& outcome) {
  const std::vector<Segment> all = segments(convolution(pair.p, pair.q));
  std::vector<Point> points = some_of(points_in_faces(all, {}), 12);
  for (const Segment& s : some_of(all, 6)) {
    points.push_back(s.source);
    points.push_back(midpoint(s.source, s.target));
  }
  std::vector<Vector> directions{{1, 0}, {-1, 0}, {3, -7}};
  for (const Region* const summand : {&pair.p, &pair.q})
    for (const Segment& e : some_of(edges(*summand), 2)) {
      directions.push_back(direction_of(e));
      directions.push_back(-direction_of(e));
    }
  for (const Point& x : points) {
    const int winding = winding_number(x, all);
    ++outcome.counts["points"];
    if (winding != 0) ++outcome.counts["points with a winding number other than zero"];
    for (const Vector& d : directions) {
      const int count = tangent_count(x, pair.p, pair.q, d);
      if (count == winding) continue;
      outcome.fail("the winding number is " + std::to_string(winding) + ", and " +
                       std::to_string(count) + " corners have the tangent direction " +
                       to_string(Point{d.x, d.y}),
                   x);
      return;
    }
  }
}

Outcome check(const Summands& summands) {
  Outcome outcome;
  for (const Summands& pair : {summands, Summands{entangled(summands.p), summands.q},
                               Summands{entangled(summands.p), entangled(summands.q)}})
    if (outcome.kind == Outcome::Kind::holds) expect(pair, outcome);
  return outcome;
}

const Registered registered(
    small_mixture(),
    {
        .id = "fact-tangent-count",
        .kills = {"crossings-count-with-a-sign", "tie-rule-depends-on-who-asks",
                  "tangent-set-without-ties", "reflex-turns-clockwise", "ray-counts-both-ends"},
        .cases = 100,
        .check = check,
    });

}  // namespace

}  // namespace oplus
