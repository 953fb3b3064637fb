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
    .kills = {"disc-ends-one-step-further", "disc-edges-are-not-tested"},
    .enumerate = discs,
});

}  // namespace

}  // namespace oplus
