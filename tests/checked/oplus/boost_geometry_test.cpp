// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/oplus/boost_geometry.hpp"

#include <gtest/gtest.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/register/multi_polygon.hpp>
#include <boost/geometry/geometries/register/point.hpp>
#include <boost/geometry/geometries/register/ring.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <vector>

namespace bg = boost::geometry;

namespace user {

/// Types of a user, registered as Boost.Geometry wants it.
struct Vertex {
  float east = 0;
  float north = 0;
};
struct Outline : std::vector<Vertex> {
  using std::vector<Vertex>::vector;
};
struct Parcels : std::vector<bg::model::polygon<Vertex, false, false>> {};

}  // namespace user

BOOST_GEOMETRY_REGISTER_POINT_2D(user::Vertex, float, bg::cs::cartesian, east, north)
BOOST_GEOMETRY_REGISTER_RING(user::Outline)
BOOST_GEOMETRY_REGISTER_MULTI_POLYGON(user::Parcels)

namespace oplus {
namespace {

template <typename Number, bool clockwise = true, bool closed = true>
using Polygons = bg::model::multi_polygon<
    bg::model::polygon<bg::model::d2::point_xy<Number>, clockwise, closed>>;

const ValidRegion frames = read_wkt(
    "MULTIPOLYGON(((0 0,4 0,4 4,0 4,0 0),(1 1,1 3,3 3,3 1,1 1)),((6 0,9 0,9 9,6 0),(8 1,7.5 2,8.5 2,8 1)))");

template <typename Result>
class Boost : public testing::Test {};
using Results =
    testing::Types<Polygons<double>, Polygons<double, false>, Polygons<double, true, false>,
                   Polygons<double, false, false>, Polygons<float>, Polygons<mpq_class>,
                   Polygons<boost::multiprecision::cpp_rational>, user::Parcels>;
TYPED_TEST_SUITE(Boost, Results);

TYPED_TEST(Boost, is_the_same_there_and_back) {
  const auto there = to_boost<TypeParam>(frames);
  EXPECT_EQ(from_boost(there), frames);
  EXPECT_EQ(boost::size(there), 2U);
  EXPECT_EQ(from_boost(to_boost<TypeParam>(ValidRegion())), ValidRegion());
}

TYPED_TEST(Boost, is_valid_in_orientation_and_closure_of_its_type) {
  if constexpr (std::is_floating_point_v<typename bg::coordinate_type<TypeParam>::type>) {
    std::string reason;
    EXPECT_TRUE(bg::is_valid(to_boost<TypeParam>(frames), reason)) << reason;
    const ValidSet sum = minkowski_sum(frames, polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
    EXPECT_TRUE(bg::is_valid(to_boost<TypeParam>(sum), reason)) << reason;
    EXPECT_NEAR(static_cast<double>(bg::area(to_boost<TypeParam>(sum))), area(sum).get_d(), 1e-4);
  }
}

TEST(ToBoost, is_exact_where_the_coordinates_are) {
  const ValidRegion thirds = polygon({{0, 0}, {1, 0}, {"1/3", "-22/7"}});
  EXPECT_EQ(from_boost(to_boost<Polygons<mpq_class>>(thirds)), thirds);
  EXPECT_EQ(from_boost(to_boost<Polygons<boost::multiprecision::cpp_rational>>(thirds)), thirds);
  EXPECT_EQ(from_boost(to_boost<Polygons<double>>(thirds)),
            polygon({{0, 0}, {1, 0}, {1.0 / 3, -22.0 / 7}}));
}

TEST(ToBoost, refuses_fractions_where_coordinates_are_integers) {
  const ValidRegion square = polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  EXPECT_EQ(from_boost(to_boost<Polygons<int>>(square)), square);
  EXPECT_THROW(to_boost<Polygons<int>>(frames), std::domain_error);
  EXPECT_THROW(to_boost<Polygons<int>>(polygon({{0, 0}, {1e10, 0}, {0, 1}})), std::domain_error);
}

TEST(ToBoost, leaves_out_what_bounds_no_face) {
  const ValidRegion frame =
      polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}});
  const ValidSet sum =
      minkowski_sum(frame, polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}}), {.boundary = Boundary::open});
  ASSERT_EQ(sum.isolated_vertices().size(), 1U);
  const auto polygons = to_boost<Polygons<int>>(sum);
  ASSERT_EQ(polygons.size(), 1U);
  EXPECT_TRUE(polygons[0].inners().empty());
  EXPECT_EQ(from_boost(polygons), sum.region());
}

TEST(ToBoost, refuses_what_is_unbounded) {
  EXPECT_THROW(to_boost<Polygons<double>>(complement(frames)), std::invalid_argument);
}

TEST(FromBoost, takes_rings) {
  const ValidRegion expected = polygon({{0, 0}, {4, 0}, {0, 4}});
  EXPECT_EQ(from_boost(user::Outline{{0, 0}, {4, 0}, {0, 4}, {0, 0}}), expected);
  EXPECT_EQ(from_boost(user::Outline{{0, 0}, {4, 0}, {0, 4}}), expected);
  EXPECT_EQ(from_boost(user::Outline{{0, 0}, {0, 4}, {4, 0}}), expected);
  using Ring = bg::model::ring<bg::model::point<int, 2, bg::cs::cartesian>, false, false>;
  EXPECT_EQ(from_boost(Ring{{0, 0}, {4, 0}, {0, 4}}), expected);
  EXPECT_EQ(from_boost(Ring{}), ValidRegion());
}

TEST(FromBoost, takes_polygons) {
  bg::model::polygon<user::Vertex> polygon;
  EXPECT_EQ(from_boost(polygon), ValidRegion());
  bg::read_wkt("POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,3 1,3 3,1 3,1 1))", polygon);
  EXPECT_EQ(from_boost(polygon).components()[0], frames.components()[0]);
  polygon.outer().clear();
  EXPECT_THROW(from_boost(polygon), InvalidInput);
}

TEST(FromBoost, refuses_what_is_invalid) {
  for (const std::string text :
       {"MULTIPOLYGON(((0 0,2 2,2 0,0 2,0 0)))", "MULTIPOLYGON(((0 0,1 0,0 0)))",
        "MULTIPOLYGON(((0 0,2 0,2 2,2 0,0 2,0 0)))",
        "MULTIPOLYGON(((0 0,4 0,0 4,0 0)),((1 1,5 1,1 5,1 1)))"}) {
    Polygons<double> polygons;
    bg::read_wkt(text, polygons);
    EXPECT_THROW(from_boost(polygons), InvalidInput) << text;
  }
  for (const float value : {HUGE_VALF, std::nanf("")})
    EXPECT_THROW(from_boost(user::Outline{{0, 0}, {4, 0}, {0, value}}), InvalidInput);
}

TEST(FromBoost, and_to_it_agree_with_unions_of_boost) {
  // The sum with a square is the union of what moves along the L's edges.
  const ValidRegion ell = polygon({{0, 0}, {5, 0}, {5, 1}, {1, 1}, {1, 5}, {0, 5}});
  const ValidSet sum = minkowski_sum(ell, polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  Polygons<double> a, b, both;
  bg::read_wkt("MULTIPOLYGON(((0 0,6 0,6 2,0 2,0 0)))", a);
  bg::read_wkt("MULTIPOLYGON(((0 0,2 0,2 6,0 6,0 0)))", b);
  bg::correct(a);
  bg::correct(b);
  bg::union_(a, b, both);
  EXPECT_TRUE(bg::equals(to_boost<Polygons<double>>(sum), both));
}

}  // namespace
}  // namespace oplus
