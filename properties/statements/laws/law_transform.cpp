// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/image.hpp"
#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "reference/arithmetic/rational_rotation.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

struct NamedMap {
  std::string name;
  AffineMap map;
};

/// Whether a rotation is by the angle, but for the error; all in degrees.
bool is_near(const RationalRotation& rotation, const Rational& degrees, const Rational& error) {
  const Rational precision = error / 1000;
  return abs(angle_in_degrees(rotation, precision) - degrees) <= error + precision;
}

AffineMap inverse(const AffineMap& map) {
  const Rational by = 1 / map.determinant();
  const AffineMap back{by * map.d, -by * map.b, -by * map.c, by * map.a};
  return back * AffineMap{.by = -map.by};
}

/// Points in all places that a region has: vertices, midpoints of edges, and what is between two vertices.
std::vector<Point> places(const Region& region) {
  std::vector<Point> points;
  const std::vector<Segment> boundary = edges(region);
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    points.push_back(boundary[i].source);
    points.push_back(midpoint(boundary[i].source, boundary[i].target));
    points.push_back(midpoint(boundary[i].source, boundary[i * 7 % boundary.size()].target));
  }
  return points;
}

std::string broken(const AffineMap& map, const Region& region) {
  const Region there = image(map, region);
  if (!oriented_and_checked(there, "the image").notes.empty()) return "a chain was not turned";
  if (area(there) != abs(map.determinant()) * area(region)) return "the area is wrong";
  for (const Point& x : places(region))
    if (locate(map(x), there) != locate(x, region))
      return "the location of " + to_string(x) + " is";
  if (image(inverse(map), there) != region) return "its inverse does not lead back";
  const PlanarSet set = canonical_sum(region);
  if (image(map, set) != canonical_sum(there)) return "the image as a set is another";
  return "";
}

Outcome law(const Summands& summands) {
  // An angle and an error that differ from case to case.
  const Rational degrees = area(summands.p) * 100 / 7 + Rational(1, 3);
  const Rational angle = degrees - 360 * mpz_class(degrees / 360);
  const Rational error = Rational(1, 10) / (1 + area(summands.q));
  const RationalRotation rotation =
      rational_rotation(angle > 180 ? Rational(angle - 360) : angle, error);
  if (!is_near(rotation, angle > 180 ? Rational(angle - 360) : angle, error))
    return unless_broken("the rotation by " + angle.get_str() + " degrees is by another angle");
  const NamedMap maps[] = {
      {"a rotation", {rotation.cos, -rotation.sin, rotation.sin, rotation.cos}},
      {"a translation", {.by = {Rational(1, 3), -5}}},
      {"a scaling", {2, 0, 0, Rational(1, 3)}},
      {"a reflection", {1, 0, 0, -1, {3, 0}}},
      {"a general map", {3, -1, 1, -2, {1, Rational(1, 7)}}}};
  for (const Region* region : {&summands.p, &summands.q})
    for (const auto& [name, map] : maps)
      if (const std::string what = broken(map, *region); !what.empty())
        return unless_broken("under " + name + ", " + what);
  return {};
}

const Registered registered({
    .id = "law-transform",
    .sources = {{"grid", 8, 4},
                {"holes", 6, 2},
                {"components", 5, 2},
                {"islands", 1, 1},
                {"convex", 8, 1},
                {"diamond-u", 1, 1}},
    .promises = {{"holes", 15}, {"several components", 5}},
    .kills = {"mirrored-chains-keep-their-order", "rotation-by-the-rest-of-a-right-angle"},
    .cases = 300,
    .check = law,
});

}  // namespace

}  // namespace oplus
