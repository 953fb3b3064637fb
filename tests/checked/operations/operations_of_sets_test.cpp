// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "checked/operations/complement.hpp"
#include "checked/operations/operations.hpp"
#include "checked/operations/set_sum.hpp"
#include "checked/operations/union_of.hpp"
#include "checked/slide/by_slide.hpp"
#include "properties/statements/placements/sets_meet.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/families/family.hpp"
#include "reference/families/random.hpp"
#include "reference/io/writing.hpp"

namespace oplus {
namespace {

PlanarSet union_in(const ClaimedSum& parts) {
  return union_of(parts.region, parts.dangling_edges, parts.isolated_vertices);
}

ClaimedSum minus(const ClaimedSum& set) { return reflected_to({0, 0}, set); }

PlanarSet value(const std::string& name, const ClaimedSum& p, const ClaimedSum& q) {
  return operation_called(name).compute_of_sets(union_in(p), union_in(q), by_slide);
}

/// By definition: no point of a set is outside of a region.
bool is_subset(const ClaimedSum& set, const Region& region) {
  const std::vector<Segment> boundary = edges(region);
  const auto is_in = [&](const Point& p) { return locate(p, region) != Location::outside; };
  const auto has_edge = [&](const Segment& s) {
    const std::vector<Segment> pieces = cut_where_met(s, boundary);
    return is_in(s.source) && is_in(s.target) &&
           std::all_of(pieces.begin(), pieces.end(), [&](const Segment& piece) {
             return is_in(midpoint(piece.source, piece.target));
           });
  };
  const std::vector<Segment> of_region = edges(set.region);
  return std::all_of(of_region.begin(), of_region.end(), has_edge) &&
         std::all_of(set.dangling_edges.begin(), set.dangling_edges.end(), has_edge) &&
         std::all_of(set.isolated_vertices.begin(), set.isolated_vertices.end(), is_in) &&
         !interiors_meet(complement(region), set.region);
}

Point place(Random& random, std::size_t size) {
  const auto coordinate = [&] { return Rational(static_cast<int>(uniform_index(random, size))); };
  const Rational x = coordinate();
  return {x, coordinate()};
}

/// Of the kinds 1 a region, 2 a polyline and 4 points, those whose sum this is; with edges or points always. The
/// polyline runs along edges of a region, which it may just fit, or anywhere.
ClaimedSum drawn(Random& random, const Region& region, const Region& along) {
  ClaimedSum result;
  const std::size_t kinds = 2 + uniform_index(random, 6);
  if (kinds % 2 == 1) result.region = region;
  if ((kinds & 2U) != 0 && one_in(random, 2)) {
    result.dangling_edges = edges(along.components[0].outer);
    if (one_in(random, 2)) result.dangling_edges.resize(2);
  } else if ((kinds & 2U) != 0) {
    Point from = place(random, 3);
    for (std::size_t i = uniform_index(random, 2) + 1; i > 0; --i) {
      const Point to = place(random, 3);
      if (to == from)
        result.isolated_vertices.push_back(to);
      else
        result.dangling_edges.push_back({from, to});
      from = to;
    }
  }
  for (std::size_t i = kinds & 4U; i > 2; --i) result.isolated_vertices.push_back(place(random, 3));
  return result;
}

/// Regions of a small grid, P twice as large.
Summands grid_pair(std::uint64_t seed) {
  Summands pair = generate(*find_family("grid"), 4, seed);
  pair.p = mapped(pair.p, [](const Point& p) { return Point{2 * p.x, 2 * p.y}; });
  return pair;
}

TEST(OperationsOfSets, nfp_is_that_of_the_definition_on_a_point_of_every_cell) {
  std::size_t points = 0, low_dimensional = 0;
  for (std::uint64_t seed = 0; seed < 40 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Summands regions = grid_pair(seed);
    const ClaimedSum p = drawn(random, regions.p, regions.q),
                     q = drawn(random, regions.q, regions.p);
    const PlanarSet places = value("nfp", p, q);
    low_dimensional += has_edge_or_point(places);
    for (const Point& x : points_of_cells(p, minus(q))) {
      ++points;
      const ClaimedSum placed = reflected_to(x, minus(q));
      EXPECT_EQ(interior_meets(p.region, placed) || interior_meets(placed.region, p),
                locate(x, places) == Location::inside)
          << to_string(x);
    }
  }
  EXPECT_GT(points, 3000U);
  EXPECT_GT(low_dimensional, 3U);
}

TEST(OperationsOfSets, ifp_and_what_is_made_of_it_are_those_of_the_definition) {
  std::size_t points = 0, exact_fits = 0;
  for (std::uint64_t seed = 0; seed < 150 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Summands regions = grid_pair(seed);
    const ClaimedSum p{regions.p, {}, {}}, q = drawn(random, regions.q, regions.p);
    const PlanarSet places = value("ifp", p, q);
    exact_fits += has_edge_or_point(places);
    for (const Point& x : points_of_cells(p, minus(q))) {
      ++points;
      EXPECT_EQ(is_subset(reflected_to(x, minus(q)), p.region),
                locate(x, places) != Location::outside)
          << to_string(x);
    }
    PlanarSet regular = places;
    regular.dangling_edges.clear();
    regular.isolated_vertices.clear();
    EXPECT_EQ(value("erode", p, q), regular);

    const PlanarSet opening = value("open", p, q);
    EXPECT_EQ(is_empty(opening), is_empty(places));
    for (const Point& x : points_of_cells(parts_of(places), q)) {
      ++points;
      EXPECT_EQ(meet(parts_of(places), reflected_to(x, q)), locate(x, opening) != Location::outside)
          << to_string(x);
    }
    const PlanarSet dilated = set_sum(union_in(p), union_in(q), Boundary::closed, by_slide);
    EXPECT_EQ(value("close", p, q), value("erode", parts_of(dilated), q));
  }
  EXPECT_GT(points, 3000U);
  EXPECT_GT(exact_fits, 3U);
}

TEST(OperationsOfSets, of_regions_are_those_of_regions) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Summands pair = grid_pair(seed);
    for (const Operation& operation : operations())
      EXPECT_EQ(value(operation.name, {pair.p, {}, {}}, {pair.q, {}, {}}),
                operation.compute(pair.p, pair.q, by_slide))
          << operation.name << " " << seed;
  }
}

TEST(OperationsOfSets, are_those_of_regions_by_any_name) {
  EXPECT_EQ(operation_names(),
            (std::vector<std::string>{"sum", "nfp", "ifp", "erode", "open", "close"}));
  EXPECT_THROW(operation_called("none"), std::invalid_argument);
  const auto [p, q] = generate(*find_family("star"), 8, 1);
  for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
    const Operation& sum = operation_called("sum", boundary);
    EXPECT_EQ(sum.compute(p, q, by_slide), by_slide(p, q, boundary));
    EXPECT_EQ(sum.compute_of_sets(canonical_sum(p), canonical_sum(q), by_slide),
              by_slide(p, q, boundary));
    EXPECT_EQ(sum.compute_of_sets(canonical_sum(p), {}, by_slide), PlanarSet{});
  }
}

/// A point fits where the set is; nothing unbounded fits a bounded one.
TEST(OperationsOfSets, inner_fits_of_a_point_and_of_what_is_unbounded) {
  const Chain square{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, hole{{1, 1}, {1, 2}, {2, 2}, {2, 1}};
  const PlanarSet origin{{}, {}, {}, {{0, 0}}};
  const Operation& inner_fit = operation_called("ifp");
  for (const PlanarSet& set :
       {PlanarSet{{square}, {}, {}, {}}, PlanarSet{{square}, {hole}, {}, {}}})
    EXPECT_EQ(inner_fit.compute_of_sets(set, origin, by_slide), set);
  const PlanarSet outside = complement(PlanarSet{{square}, {}, {}, {}});
  EXPECT_EQ(inner_fit.compute_of_sets(outside, origin, by_slide), outside);
  EXPECT_EQ(inner_fit.compute_of_sets({{square}, {}, {}, {}}, outside, by_slide), PlanarSet{});
}

}  // namespace
}  // namespace oplus
