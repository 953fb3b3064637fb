// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "checked/operations/disc.hpp"
#include "properties/runner/registry.hpp"
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

const Registered registered({
    .id = "law-disc",
    .title = "The polygon for a disc is inside or around it, and at most the error away",
    .statement =
        "Let D(r) be the disc of radius r about the origin. disc(R, inside, E) contains D(R - E) and is "
        "contained in D(R); disc(R, outside, E) contains D(R) and is contained in D(R + E). Both are convex, "
        "counterclockwise, and symmetric under quarter turns and reflections in the axes. This is decided for "
        "R = 1, 22/7 and 1000, each with 91 errors E from 2 R down to R / 496.",
    .why =
        "A chain that has the origin on the left of each edge, each edge at least a away from it, and goes "
        "around once, contains D(a); with all vertices in D(b), which is convex, it is in D(b). So each "
        "point of D(b) is at most b - a away from the polygon, and each point of the polygon at most b - a "
        "from D(a). Squares of distances are rational, so this is decided exactly. For other R and E the "
        "function decides it itself, in integers, of each polygon before it returns one.",
    .hypotheses = {"R and E are among those"},
    .rests_on = {},
    .sources = {},
    .promises = {},
    .kills = {"disc-ends-one-step-further", "disc-edges-are-not-tested"},
    .enumerate = discs,
});

}  // namespace

}  // namespace oplus
