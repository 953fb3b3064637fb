// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/oplus/cgal.hpp"
#include "tests/reference/io/refusal.hpp"

#include <CGAL/CORE_Expr.h>
#include <CGAL/Cartesian.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Homogeneous.h>
#include <CGAL/Quotient.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Sqrt_extension.h>
#include <CGAL/boost_mp.h>
#include <CGAL/gmpxx.h>
#include <CGAL/minkowski_sum_2.h>
#include <gtest/gtest.h>

#include <cmath>
#include <list>
#include <random>

namespace oplus {
namespace {

static_assert(!NumberConversion<CORE::Expr>::is_rational);
static_assert(!NumberConversion<CGAL::Lazy_exact_nt<CORE::Expr>>::is_rational);
static_assert(!NumberConversion<CGAL::Sqrt_extension<CGAL::Gmpq, CGAL::Gmpq>>::is_rational);
static_assert(!NumberConversion<CGAL::Interval_nt<>>::is_rational);

ValidRegion two_components() {
  return read_wkt(
      "MULTIPOLYGON(((0 0,4 0,4 4,0 4,0 0),(1 1,1 3,3 3,3 1,1 1),(3.5 3.5,3.5 3.75,3.75 3.5,3.5 3.5)),"
      "((4 4,5 4,5 5.25,4 4)))");
}

ValidRegion thirds() { return polygon({{0, 0}, {"1/3", "-22/7"}, {1, 0}}); }

template <typename K>
class Cgal : public testing::Test {};
template <typename K>
class ExactCgal : public testing::Test {};
using ExactKernels =
    testing::Types<CGAL::Epeck, CGAL::Simple_cartesian<mpq_class>, CGAL::Cartesian<CGAL::Gmpq>,
                   CGAL::Simple_cartesian<CGAL::Quotient<CGAL::MP_Float>>,
                   CGAL::Simple_cartesian<boost::multiprecision::cpp_rational>,
                   CGAL::Homogeneous<CGAL::Gmpz>>;
using FloatingKernels = testing::Types<CGAL::Epick, CGAL::Simple_cartesian<double>>;
TYPED_TEST_SUITE(ExactCgal, ExactKernels);
TYPED_TEST_SUITE(Cgal, FloatingKernels);

template <typename K>
void expect_round_trips(const ValidRegion& region) {
  const std::vector<CGAL::Polygon_with_holes_2<K>> polygons = to_cgal<K>(region);
  EXPECT_EQ(polygons.size(), region.components().size());
  for (const auto& polygon : polygons) {
    EXPECT_TRUE(polygon.outer_boundary().is_counterclockwise_oriented());
    for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
      EXPECT_TRUE(hole->is_clockwise_oriented());
  }
  EXPECT_EQ(from_cgal(polygons), region);
}

TYPED_TEST(ExactCgal, is_the_same_there_and_back) {
  expect_round_trips<TypeParam>(two_components());
  expect_round_trips<TypeParam>(thirds());
  expect_round_trips<TypeParam>(minkowski_sum(two_components(), thirds()).region());
  expect_round_trips<TypeParam>(ValidRegion());
}

TYPED_TEST(Cgal, is_the_same_there_and_back) {
  expect_round_trips<TypeParam>(two_components());
  const auto rounded = to_cgal<TypeParam>(thirds());
  EXPECT_EQ(rounded.at(0).outer_boundary()[1], (typename TypeParam::Point_2(1.0 / 3, -22.0 / 7)));
  EXPECT_EQ(from_cgal(rounded), polygon({{0, 0}, {1.0 / 3, -22.0 / 7}, {1, 0}}));
}

TYPED_TEST(Cgal, is_refused_if_not_finite) {
  for (const double value : {HUGE_VAL, std::nan("")}) {
    CGAL::Polygon_2<TypeParam> polygon;
    for (const auto& [x, y] : {std::pair(0.0, 0.0), {1.0, 0.0}, {0.0, value}})
      polygon.push_back(typename TypeParam::Point_2(x, y));
    EXPECT_THROW(from_cgal(polygon), InvalidInput);
  }
}

using Kernel = CGAL::Simple_cartesian<mpq_class>;
using Polygon = CGAL::Polygon_2<Kernel>;

Polygon polygon_of(const std::vector<std::array<int, 2>>& points) {
  Polygon polygon;
  for (const auto& [x, y] : points) polygon.push_back({x, y});
  return polygon;
}

std::string message_of(const auto& polygons) {
  return refusal([&] { from_cgal(polygons); });
}

TEST(FromCgal, takes_polygons_and_ranges_of_them) {
  const Polygon triangle = polygon_of({{0, 0}, {1, 0}, {0, 1}});
  const Polygon other = polygon_of({{5, 0}, {6, 0}, {5, 1}});
  const ValidRegion expected = polygon({{0, 0}, {1, 0}, {0, 1}});
  EXPECT_EQ(from_cgal(triangle), expected);
  EXPECT_EQ(from_cgal(CGAL::Polygon_with_holes_2<Kernel>(triangle)), expected);
  EXPECT_EQ(from_cgal(std::list{triangle, other}).components().size(), 2U);
  EXPECT_EQ(from_cgal(std::vector<Polygon>()), ValidRegion());
  using InList = CGAL::Polygon_2<Kernel, std::list<Kernel::Point_2>>;
  EXPECT_EQ(from_cgal(InList(triangle.vertices_begin(), triangle.vertices_end())), expected);
}

TEST(FromCgal, turns_polygons_and_holes) {
  const Polygon outer = polygon_of({{0, 0}, {0, 4}, {4, 4}, {4, 0}});
  EXPECT_EQ(from_cgal(outer), polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  CGAL::Polygon_with_holes_2<Kernel> holed(outer);
  holed.add_hole(polygon_of({{1, 1}, {2, 1}, {1, 2}}));
  EXPECT_EQ(from_cgal(holed).components()[0].holes[0], (Chain{{1, 1}, {1, 2}, {2, 1}}));
}

TEST(FromCgal, takes_infinite_precision_of_lazy_numbers) {
  CGAL::Polygon_2<CGAL::Epeck> polygon;
  const CGAL::Epeck::FT third = CGAL::Epeck::FT(1) / 3;
  for (int i = 0; i < 3; ++i) polygon.push_back({third * (i % 2), third * third * (i / 2)});
  EXPECT_EQ(from_cgal(polygon).components()[0].outer,
            (Chain{{0, 0}, {Rational(1, 3), 0}, {0, Rational(1, 9)}}));
}

TEST(FromCgal, takes_floating_point_numbers_of_any_precision) {
  using Conversion = NumberConversion<CGAL::MP_Float>;
  EXPECT_EQ(Conversion::exact(CGAL::MP_Float(-0.625)), Rational(-5, 8));
  EXPECT_EQ(Conversion::exact(Conversion::nearest(-12345678)), -12345678);
  EXPECT_THROW(Conversion::nearest(Rational(1, 2)), std::domain_error);
}

TEST(FromCgal, a_missing_outer_boundary_is_that_of_the_plane) {
  CGAL::Polygon_with_holes_2<Kernel> unbounded;
  unbounded.add_hole(polygon_of({{0, 0}, {0, 1}, {1, 0}}));
  const ValidRegion region = from_cgal(unbounded);
  EXPECT_EQ(region, complement(from_cgal(polygon_of({{0, 0}, {1, 0}, {0, 1}}))));
  const auto back = to_cgal<Kernel>(region);
  ASSERT_EQ(back.size(), 1U);
  EXPECT_TRUE(back[0].is_unbounded());
  EXPECT_EQ(back[0].number_of_holes(), 1U);
}

TEST(FromCgal, refuses_what_is_invalid) {
  EXPECT_EQ(message_of(Polygon()),
            "polygon 1: it has no outer boundary; expected a bounded polygon");
  CGAL::Polygon_with_holes_2<Kernel> unbounded;
  unbounded.add_hole(polygon_of({{0, 0}, {0, 1}, {1, 0}}));
  const CGAL::Polygon_with_holes_2<Kernel> triangle(polygon_of({{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_EQ(message_of(std::vector{triangle, unbounded}),
            "polygon 2: it has no outer boundary; expected a bounded polygon");
  // Crossing; weakly simple: an edge there and back, and a vertex that is met twice; overlapping.
  for (const Polygon& polygon : {polygon_of({{0, 0}, {2, 2}, {2, 0}, {0, 2}}),
                                 polygon_of({{0, 0}, {2, 0}, {2, 2}, {2, 0}, {0, 2}}),
                                 polygon_of({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}})})
    EXPECT_EQ(message_of(polygon).find("region: "), 0U) << message_of(polygon);
  EXPECT_EQ(message_of(std::vector{triangle, triangle}).find("region: "), 0U);
}

TEST(ToCgal, rounds_to_the_nearest_double_also_if_that_is_no_polygon) {
  const ValidRegion thin = polygon({{0, 0}, {1, 0}, {1, "1e-400"}});
  const auto rounded = to_cgal<CGAL::Epick>(thin);
  EXPECT_FALSE(rounded.at(0).outer_boundary().is_simple());
  EXPECT_THROW(from_cgal(rounded), InvalidInput);
}

TEST(ToCgal, leaves_out_what_bounds_no_face) {
  const ValidRegion frame =
      polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}});
  const ValidSet sum =
      minkowski_sum(frame, polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}}), {.boundary = Boundary::open});
  ASSERT_EQ(sum.isolated_vertices().size(), 1U);
  const auto polygons = to_cgal<Kernel>(sum);
  ASSERT_EQ(polygons.size(), 1U);
  EXPECT_EQ(polygons[0].number_of_holes(), 0U);
  EXPECT_EQ(from_cgal(polygons), sum.region());
}

/// A polygon that is star-shaped around the origin, about 30 wide.
Polygon star(std::mt19937& random) {
  const std::size_t n = 4 + random() % 8;
  Polygon polygon;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * static_cast<double>(i) / static_cast<double>(n);
    const double radius = 1000 + static_cast<double>(random() % 900);
    polygon.push_back(
        {std::round(radius * std::cos(angle)) / 128, std::round(radius * std::sin(angle)) / 128});
  }
  return polygon;
}

/// A bottle, 100 wide, its neck narrower than a star.
Polygon bottle(std::mt19937& random) {
  Polygon polygon;
  for (const auto& [x, y] : {std::pair(0, 0),
                             {100, 0},
                             {99, 100},
                             {55, 98},
                             {54, 90},
                             {85, 88},
                             {87, 15},
                             {12, 13},
                             {14, 86},
                             {46, 91},
                             {43, 99},
                             {1, 97}})
    polygon.push_back({x + static_cast<double>(random() % 512) / 512,
                       y + static_cast<double>(random() % 512) / 512});
  return polygon;
}

TEST(ToCgal, agrees_with_minkowski_sums_of_cgal) {
  std::mt19937 random(1);
  std::size_t with_holes = 0;
  for (int i = 0; i < 60; ++i) {
    Polygon p = i % 3 == 0 ? star(random) : bottle(random);
    const Polygon q = star(random);
    const CGAL::Polygon_with_holes_2<Kernel> expected = CGAL::minkowski_sum_2(p, q);
    if (i % 2 == 0) p.reverse_orientation();
    const ValidSet sum = minkowski_sum(from_cgal(p), from_cgal(q));
    EXPECT_TRUE(verify(from_cgal(p), from_cgal(q), ClaimedSum{from_cgal(expected).region(), {}, {}})
                    .is_sum());
    ASSERT_EQ(to_cgal<Kernel>(sum).size(), 1U);
    const CGAL::Polygon_with_holes_2<Kernel> found = to_cgal<Kernel>(sum)[0];
    EXPECT_EQ(found.number_of_holes(), expected.number_of_holes());
    EXPECT_EQ(area(sum), area(from_cgal(expected)));
    if (found.number_of_holes() > 0) ++with_holes;
  }
  EXPECT_GT(with_holes, 20U);
}

}  // namespace
}  // namespace oplus
