// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "checked/operations/disc.hpp"
#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/definitions/squared_distance.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Whether it is mapped onto itself by a quarter turn and by a reflection.
bool is_symmetric(const Chain& chain) {
  const std::set<Point> points(chain.begin(), chain.end());
  return std::all_of(points.begin(), points.end(), [&](const Point& p) {
    return points.contains({-p.y, p.x}) && points.contains({p.x, -p.y});
  });
}

/// What is wrong with a polygon that is to contain the disc of radius `inner` and to be inside that of radius
/// `outer`; empty if nothing is.
std::string defect(const Region& region, const Rational& inner, const Rational& outer) {
  if (!oriented_and_checked(region, "disc").notes.empty()) return "it is clockwise";
  const Chain& chain = region.components[0].outer;
  if (locate({0, 0}, region) != Location::inside) return "the origin is not inside";
  for (const Segment& edge : edges(chain))
    if (squared_distance({0, 0}, edge) < inner * inner)
      return "the edge from " + to_string(edge.source) + " to " + to_string(edge.target) +
             " is too near";
  for (const Point& p : chain)
    if (squared_length(p) > outer * outer) return to_string(p) + " is too far away";
  for (std::size_t i = 0; i < chain.size(); ++i)
    if (orientation(chain[previous(i, chain.size())], chain[i], chain[next(i, chain.size())]) <= 0)
      return "it does not turn left at " + to_string(chain[i]);
  return is_symmetric(chain) ? "" : "it is not symmetric";
}

Enumeration discs() {
  Enumeration result;
  for (const Rational& radius : {Rational(1), Rational(22, 7), Rational(1000)}) {
    for (int parts = 1; parts <= 1000; parts += 1 + parts / 20) {
      const Rational error = 2 * radius / parts;
      const Rational smaller = error < radius ? Rational(radius - error) : Rational(0);
      for (const DiscSide side : {DiscSide::inside, DiscSide::outside}) {
        const bool is_inside = side == DiscSide::inside;
        const std::string what =
            defect(disc_polygon(radius, side, error), is_inside ? smaller : radius,
                   is_inside ? radius : Rational(radius + error));
        ++result.cases;
        if (what.empty()) continue;
        result.failure = "radius " + radius.get_str() + ", error " + error.get_str() +
                         (is_inside ? ", inside: " : ", outside: ") + what;
        return result;
      }
    }
  }
  return result;
}

const Registered law_disc({
    .id = "law-disc",
    .kills = {"disc-ends-one-step-further", "disc-edges-are-not-tested"},
    .enumerate = discs,
});

const Rational radius = 2;
const Rational error(1, 2);

/// The square of the distance of a point from a region.
Rational squared_distance(const Point& x, const Region& region) {
  if (locate(x, region) != Location::outside) return 0;
  const std::vector<Segment> boundary = edges(region);
  Rational least = squared_distance(x, boundary[0]);
  for (const Segment& edge : boundary) least = std::min(least, squared_distance(x, edge));
  return least;
}

/// Points where a mistake would show: those of the boundaries of both offsets, and points around each vertex
/// of P at the distances that matter.
std::vector<Point> tested_points(const Region& p, const PlanarSet& inner, const PlanarSet& outer) {
  std::vector<Point> points;
  for (const PlanarSet* sum : {&inner, &outer})
    for (const Segment& edge : edges(*sum)) {
      points.push_back(edge.source);
      points.push_back(midpoint(edge.source, edge.target));
    }
  const Vector directions[] = {{1, 0},
                               {Rational(-3, 5), Rational(4, 5)},
                               {Rational(-20, 29), Rational(-21, 29)},
                               {Rational(12, 13), Rational(-5, 13)}};
  for (const Chain& chain : chains(p))
    for (const Point& vertex : chain)
      for (const Vector& direction : directions)
        for (const Rational& distance : {Rational(radius - error), radius})
          points.push_back(vertex + distance * direction);
  return points;
}

/// What an offset by a polygon must be at a point: it is in it if it is nearer than `near`, and it is not if it is
/// farther than `far`; at these distances themselves as the sum is closed or open.
std::string defect(const Point& x, const Region& p, const Sum& sum, const PlanarSet& offset,
                   const Rational& near, const Rational& far) {
  const Rational distance = squared_distance(x, p);
  const Location location = locate(x, offset);
  const bool is_in =
      location == Location::inside || (location == Location::boundary && !sum.is_open());
  const auto is_below = [&](const Rational& limit) {
    return sum.is_open() ? distance < limit * limit : distance <= limit * limit;
  };
  if (is_below(near) && !is_in) return to_string(x) + " is missing";
  if (is_in && !is_below(far)) return to_string(x) + " is too far away";
  return "";
}

Outcome law_of_offset(const Sum& sum, const Summands& summands) {
  const Region& p = summands.p;
  const PlanarSet inner = sum(p, disc_polygon(radius, DiscSide::inside, error));
  const PlanarSet outer = sum(p, disc_polygon(radius, DiscSide::outside, error));
  Outcome outcome;
  for (const Point& x : tested_points(p, inner, outer)) {
    std::string what = defect(x, p, sum, inner, radius - error, radius);
    if (!what.empty()) return outcome.fail("by the inner polygon: " + what, x);
    what = defect(x, p, sum, outer, radius, radius + error);
    if (!what.empty()) return outcome.fail("by the outer polygon: " + what, x);
    ++outcome.counts["points"];
  }
  return outcome;
}

const Registered law_offset({
    .id = "law-offset",
    .sources =
        {{"grid", 6, 4}, {"holes", 4, 2}, {"components", 4, 2}, {"tight", 3, 1}, {"islands", 1, 1}},
    .promises = {{"holes", 10}, {"several components", 5}},
    .kills = {"arrangements-cut-fractions-off", "disc-ends-one-step-further"},
    .cases = 60,
    .check = of_each_engine(law_of_offset),
});

}  // namespace

}  // namespace oplus
