// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/rounding/rounding.hpp"

#include <gtest/gtest.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <map>
#include <regex>

#include "checked/operations/complement.hpp"
#include "checked/oplus/boost_geometry.hpp"
#include "checked/rounding/snap_rounding.hpp"
#include "checked/slide/slide.hpp"
#include "checked/verify/closeness.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/families/family.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

namespace bg = boost::geometry;
using Polygons =
    bg::model::multi_polygon<bg::model::polygon<bg::model::d2::point_xy<double>, false>>;

/// Of WKT whose rings are without their last vertex.
PlanarSet set_of(const std::string& wkt) {
  static const std::regex ring(R"(\(([^(),]+),([^(),]+),([^()]+)\))");
  return read_sum(std::regex_replace(wkt, ring, "($1,$2,$3,$1)"), "WKT").sum;
}

std::string text(const RoundedSet& rounded) {
  return wkt(rounded.set) + (rounded.changes == TopologyChanges{} ? "" : ": ") +
         describe(rounded.changes);
}

std::string nearest(const std::string& wkt, Boundary boundary = Boundary::closed) {
  return text(rounded(set_of(wkt), boundary, 1, Side::nearest));
}

TEST(Rounded, moves_vertices_to_the_grid) {
  EXPECT_EQ(nearest("POLYGON ((0.4 0.4, 3.5 0, 3 2.6))"), "POLYGON ((0 0, 4 0, 3 3, 0 0))");
  EXPECT_EQ(nearest("POLYGON ((0.5 -0.5, 3 0, 3 3))"), "POLYGON ((1 0, 3 0, 3 3, 1 0))");
}

TEST(Rounded, moves_edges_to_vertices_that_they_pass) {
  // Without the vertex (2, 1) in the long edge, the notch would be on its other side.
  EXPECT_EQ(nearest("POLYGON ((0 0, 10 0, 10 4, 5 2.3, 0 4), (4.9 2.1, 5.1 2.1, 5 2))"),
            "POLYGON ((0 0, 10 0, 10 4, 5 2, 0 4, 0 0)): 1 hole closed");
}

TEST(Rounded, says_what_happens_to_components_and_holes) {
  // A bridge narrower than the grid, and a component.
  EXPECT_EQ(
      nearest("POLYGON ((0 0, 2 0, 2 0.9, 4 0.9, 4 0, 6 0, 6 2, 4 2, 4 1.1, 2 1.1, 2 2, 0 2))"),
      "MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2, 0 0)), ((4 0, 6 0, 6 2, 4 2, 4 0)))"
      ": 1 component came apart");
  EXPECT_EQ(nearest("MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2)), ((9.1 9, 9.4 9, 9.2 9.2)))"),
            "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0)): 1 component vanished");
  EXPECT_EQ(nearest("MULTIPOLYGON (((0 0, 2 0, 2 2, 0 2)), ((2.2 0, 4 0, 4 2, 2.2 2)))"),
            "POLYGON ((0 0, 4 0, 4 2, 0 2, 0 0)): 2 components joined");
  // Walls narrower than the grid: between two holes, and between a hole and the outside.
  EXPECT_EQ(
      nearest("POLYGON ((0 0, 9 0, 9 9, 0 9), (1 1, 2.9 1, 2.9 3, 1 3), (3.1 1, 5 1, 5 3, 3.1 3))"),
      "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 1 3, 5 3, 5 1, 1 1)): 2 holes joined");
  EXPECT_EQ(
      nearest("POLYGON ((0 0, 9 0, 9 9, 0 9), (1 0.2, 3 0.2, 3 3, 1 3))"),
      "POLYGON ((0 0, 1 0, 1 3, 3 3, 3 0, 9 0, 9 9, 0 9, 0 0)): 1 hole opened to the outside");
  // A gap that leads to a bay.
  EXPECT_EQ(
      nearest("POLYGON ((0 0, 9 0, 9 4.1, 6 4.1, 6 2, 3 2, 3 6, 6 6, 6 4.4, 9 4.4, 9 9, 0 9))"),
      "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 2, 3 6, 6 6, 6 2, 3 2)): 1 hole new");
}

TEST(Rounded, keeps_thin_parts_of_an_open_sets_complement_as_edges_and_points) {
  const std::string with_slit = "POLYGON ((0 0, 9 0, 9 9, 0 9), (2.9 2, 3.1 2, 3.1 5, 2.9 5))";
  EXPECT_EQ(nearest(with_slit), "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0)): 1 hole closed");
  EXPECT_EQ(nearest(with_slit, Boundary::open),
            "GEOMETRYCOLLECTION (POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0)), LINESTRING (3 2, 3 5)): "
            "1 hole closed");
  EXPECT_EQ(nearest("POLYGON ((0 0, 9 0, 9 9, 0 9), (2.9 2, 3.1 2, 3 2.1))", Boundary::open),
            "GEOMETRYCOLLECTION (POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0)), POINT (3 2)): 1 hole closed");
}

TEST(Rounded, moves_edges_and_points_and_drops_them_where_the_complement_is) {
  const std::string square = "POLYGON ((0 0, 9 0, 9 9, 0 9))";
  EXPECT_EQ(nearest("GEOMETRYCOLLECTION (" + square +
                        ", LINESTRING (2 2.2, 5 2.4), LINESTRING (3 1, 3.2 4), POINT (7.1 7))",
                    Boundary::open),
            "GEOMETRYCOLLECTION (POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0)), LINESTRING (2 2, 5 2), "
            "LINESTRING (3 1, 3 4), POINT (7 7))");
  EXPECT_EQ(nearest("GEOMETRYCOLLECTION (" + square + ", POINT (0.2 7))", Boundary::open),
            "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0)): 1 dangling edge or isolated vertex lost");
}

TEST(Rounded, on_a_side_of_an_open_set_drops_edges_or_puts_areas_in_their_place) {
  const PlanarSet set =
      set_of("GEOMETRYCOLLECTION (POLYGON ((0 0, 9 0, 9 9, 0 9)), POINT (4.5 4.5))");
  EXPECT_EQ(text(rounded(set, Boundary::open, 1, Side::contain)),
            "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0)): 1 dangling edge or isolated vertex lost");
  EXPECT_EQ(text(rounded(set, Boundary::open, 1, Side::contained)),
            "POLYGON ((1 1, 9 1, 9 9, 1 9, 1 1), (4 4, 4 5, 5 5, 5 4, 4 4)): 1 hole new");
}

TEST(Rounded, unbounded_sets_are_rounded_as_their_complements) {
  const PlanarSet on_grid = complement(set_of("POLYGON ((0 0, 9 0, 9 9, 0 9))"));
  EXPECT_EQ(rounded(on_grid, Boundary::closed, 1, Side::nearest).set, on_grid);
  const PlanarSet off_grid = complement(set_of("POLYGON ((0 0, 9 0, 9 9.2, 0 9))"));
  EXPECT_EQ(rounded(off_grid, Boundary::open, 1, Side::nearest).set, on_grid);
}

TEST(Rounded, a_set_on_the_grid_stays_as_it_is) {
  // An edge passes the pixel of a vertex that is on the grid.
  const PlanarSet set = set_of("POLYGON ((0 0, 5 -1, 10 0, 10 1, 5 0, 0 1))");
  for (const Side side : {Side::nearest, Side::contain, Side::contained}) {
    const RoundedSet same = rounded(set, Boundary::closed, 1, side);
    EXPECT_EQ(same.set, set);
    EXPECT_EQ(same.region, region_of(set));
    EXPECT_EQ(same.bound, 0);
    EXPECT_TRUE(same.is_exact);
    EXPECT_TRUE(rounded({}, Boundary::open, 1, side).is_exact);
  }
}

TEST(Rounded, has_components_with_connected_interiors) {
  // Two holes that touch in two points cut the component in two.
  const RoundedSet same =
      rounded(set_of("POLYGON ((0 0, 9 0, 9 9, 0 9), (1 4, 4 1, 2 4, 4 7), (4 1, 7 4, 4 7, 6 4))"),
              Boundary::closed, 1, Side::nearest);
  EXPECT_TRUE(bg::is_valid(to_boost<Polygons>(ValidRegion(same.region)))) << wkt(same.region);
  EXPECT_EQ(same.region.components.size(), 2U);
  EXPECT_EQ(area(same.region), area(same.set));
}

TEST(Rounded, an_unbounded_set_is_the_complement_of_its_rounded_complement) {
  const PlanarSet hole = set_of("POLYGON ((0.2 0, 5 0, 5 5.6, 0.2 5))");
  PlanarSet outside = {
      {}, {{{Rational(1, 5), 0}, {Rational(1, 5), 5}, {5, Rational(28, 5)}, {5, 0}}}, {}, {}, true};
  for (const auto& [side, other] : std::map<Side, Side>{{Side::nearest, Side::nearest},
                                                        {Side::contain, Side::contained},
                                                        {Side::contained, Side::contain}}) {
    const RoundedSet a = rounded(outside, Boundary::closed, 1, side);
    const RoundedSet b = rounded(hole, Boundary::open, 1, other);
    EXPECT_TRUE(a.set.is_unbounded);
    ASSERT_EQ(a.region.components.size(), 1U);
    EXPECT_TRUE(a.region.components[0].outer.empty());
    EXPECT_EQ(a.region.components[0].holes, a.set.holes);
    EXPECT_EQ(edges(a.set).size(), edges(b.set).size());
    EXPECT_EQ(area(a.set), -area(b.set));
  }
}

Rational width_of(const PlanarSet& sum) {
  Rational low = sum.outer[0][0].x, high = low;
  for (const Chain& chain : sum.outer)
    for (const Point& p : chain) low = std::min(low, p.x), high = std::max(high, p.x);
  return high - low;
}

/// A power of two near a number: WKB holds its multiples.
Rational power_of_two_near(const Rational& value) {
  Rational power = 1;
  while (power > value) power /= 2;
  while (power * 2 < value) power *= 2;
  return power;
}

TEST(Rounded, an_unbounded_set_says_which_components_joined) {
  // The wall between the hole and the outside is less than half a step thick.
  const Rational wall(99, 10);
  const PlanarSet ring = {{{{1, 1}, {wall, 1}, {wall, 9}, {1, 9}}},
                          {{{0, 0}, {0, 10}, {10, 10}, {10, 0}}},
                          {},
                          {},
                          true};
  EXPECT_EQ(rounded(ring, Boundary::closed, 1, Side::nearest).changes,
            (TopologyChanges{.joined_components = 2}));
  PlanarSet thick = ring;
  for (Point& p : thick.outer[0]) p.x = std::min(p.x, Rational(89, 10));
  EXPECT_EQ(rounded(thick, Boundary::closed, 1, Side::nearest).changes, TopologyChanges{});
}

/// Valid by our reader and by Boost.Geometry, and within the bound; statement law-rounding has the other promises.
TEST(Rounded, sums_of_all_families) {
#ifdef __SANITIZE_ADDRESS__
  constexpr std::uint64_t seeds = 5;
#else
  constexpr std::uint64_t seeds = 48;
#endif
  std::map<std::string, std::size_t> seen;
  for (const Family& family : families()) {
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const auto [p, q] =
          generate(family, std::min(family.typical, family.smallest + 1 + seed % 4), seed);
      for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
        const PlanarSet sum = slide_sum(p, q, boundary).sum;
        ++seen["sums"];
        const int cells[] = {3, 7, 40, 1000};
        const Rational step = seed % 5 == 0 ? power_of_two_near(width_of(sum) / 20)
                                            : width_of(sum) / cells[seed % 4] * Rational(97, 101);
        const Side side = std::array{Side::nearest, Side::contain, Side::contained}[seed % 3];
        const std::string which = family.name + " " + std::to_string(seed);
        const RoundedSet result = rounded(sum, boundary, step, side);
        seen["changed"] += result.changes != TopologyChanges{};
        seen["exact"] += result.is_exact;

        const std::string as_text = written(result.set, result.region, Format::wkt);
        EXPECT_TRUE(read_sum(as_text, "WKT").notes.empty()) << which;
        EXPECT_TRUE(read_sum(as_text, "WKT").sum == result.set) << which;
        if (!not_a_double(result.region, result.set)) {
          ++seen["in WKB"];
          EXPECT_TRUE(read_sum(written(result.set, result.region, Format::wkb), "WKB").sum ==
                      result.set)
              << which;
        }
        // In steps all coordinates are integers, which doubles hold.
        const Region in_steps = mapped(result.region, [&](const Point& v) {
          EXPECT_TRUE(is_on_grid(v, step)) << which;
          return Point{v.x / step, v.y / step};
        });
        std::string why;
        EXPECT_TRUE(bg::is_valid(to_boost<Polygons>(ValidRegion(in_steps)), why)) << which << why;

        // verify, with the distance in which the bound is. An open set that contains the sum has no edges and points:
        // it is near the closed sum.
        PlanarSet exact = sum;
        if (side == Side::contain && !result.is_exact)
          exact.dangling_edges.clear(), exact.isolated_vertices.clear();
        const Rational distance = result.bound * Rational(141421357, 100000000);
        const Closeness close = closeness(
            exact, {result.region, result.set.dangling_edges, result.set.isolated_vertices},
            distance);
        EXPECT_TRUE(close.is_close()) << which;
        if (close.distance) {
          EXPECT_LE(close.distance->most_squared, distance * distance) << which;
        }
        seen["with thin parts lost"] += close.is_distance_of_given();
        seen["with other chains"] += !close.has_same_chains();
        if (sum != exact || result.is_exact) continue;
        if (result.region.components.size() != region_of(sum).components.size()) {
          EXPECT_NE(describe(result.changes), "") << which;
        }
      }
    }
  }
  for (const auto& [what, count] : seen) RecordProperty(what, static_cast<int>(count));
  EXPECT_GE(seen["sums"], seeds * 2 * families().size());
  EXPECT_GE(seen["changed"], seen["sums"] / 10);
  EXPECT_GE(seen["with other chains"], seen["sums"] / 20);
  EXPECT_GE(seen["with thin parts lost"], 10U);
  EXPECT_GE(seen["in WKB"], seen["sums"] / 20);
}

const Region nine{{{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {}}}};

TEST(Closeness, refuses_what_is_farther_than_rounding_goes) {
  const PlanarSet set = set_of("POLYGON ((0 0, 9 0, 9 9, 0 9), (2 2, 2 4, 4 4, 4 2))");
  const auto is_close = [&](const std::string& given, const Rational& distance) {
    return closeness(set, {region_of(set_of(given)), {}, {}}, distance).is_close();
  };
  // A square of side 2 is in the hole; its diagonal is that of a distance of √2.
  EXPECT_TRUE(is_close("POLYGON ((0 0, 9 0, 9 9, 0 9))", Rational(142, 100)));
  EXPECT_FALSE(is_close("POLYGON ((0 0, 9 0, 9 9, 0 9))", Rational(141, 100)));
  EXPECT_FALSE(is_close("POLYGON ((0 0, 9 0, 9 9, 0 9), (6 6, 6 8, 8 8, 8 6))", 2));
  const PlanarSet with_edge =
      set_of("GEOMETRYCOLLECTION (POLYGON ((0 0, 9 0, 9 9, 0 9)), LINESTRING (4 4, 5 4))");
  EXPECT_FALSE(closeness(with_edge, {nine, {}, {}}, 1).is_close());
  EXPECT_TRUE(closeness(with_edge, {nine, {{{4, 4}, {5, Rational(9, 2)}}}, {}}, 1).is_close());
}

}  // namespace
}  // namespace oplus
