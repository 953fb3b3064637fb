// SPDX-License-Identifier: MIT
// To and from polygons of Boost.Geometry, also with a point type and a number type of your own.
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/register/point.hpp>
#include <iostream>
#include <oplus/boost_geometry.hpp>
#include <oplus/oplus.hpp>

namespace bg = boost::geometry;

struct Cents {
  int value = 0;
};

struct Place {
  Cents x, y;
};

BOOST_GEOMETRY_REGISTER_POINT_2D(Place, Cents, bg::cs::cartesian, x, y)

// How your numbers become rational ones, and back.
template <>
struct oplus::NumberConversion<Cents> {
  static constexpr bool is_rational = true;
  static Rational exact(const Cents& cents) { return Number(cents.value).value() / 100; }
  static Cents nearest(const Rational& value) {
    return {oplus::NumberConversion<int>::nearest(value * 100)};
  }
};

int main() {
  using Polygon = bg::model::polygon<bg::model::d2::point_xy<double>>;
  Polygon polygon;
  bg::read_wkt("POLYGON((0 0,0 4,4 4,4 0,0 0),(1 1,3 1,3 3,1 3,1 1))", polygon);
  auto tool = oplus::polygon({{0, 0}, {0.5, 0}, {0, 0.5}});
  oplus::ValidSet sum = minkowski_sum(oplus::from_boost(polygon), tool);

  auto result = oplus::to_boost<bg::model::multi_polygon<Polygon>>(sum);
  std::cout << bg::wkt(result) << '\n' << bg::is_valid(result) << '\n';

  // Counterclockwise and not closed, as this type wants it.
  using OwnPolygons = bg::model::multi_polygon<bg::model::polygon<Place, false, false>>;
  auto in_cents = oplus::to_boost<OwnPolygons>(sum);
  for (const Place& place : in_cents[0].outer())
    std::cout << place.x.value << ' ' << place.y.value << '\n';

  // Cents cannot hold a third.
  try {
    oplus::to_boost<OwnPolygons>(oplus::polygon({{0, 0}, {"1/3", 0}, {0, 1}}));
  } catch (const std::domain_error& error) {
    std::cout << error.what() << '\n';
  }
}
