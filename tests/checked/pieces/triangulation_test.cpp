// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/pieces/triangulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "reference/families/family.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus::pieces {
namespace {

struct Triangulated {
  /// Coordinates in doubles are multiplied by a unit.
  explicit Triangulated(const Region& region, double unit = 1) {
    for (const Chain& chain : chains(region)) {
      const std::size_t first = vertices.size();
      vertices.insert(vertices.end(), chain.begin(), chain.end());
      for (std::size_t i = 0; i < chain.size(); ++i)
        boundary.edges.push_back({static_cast<std::uint32_t>(first + i),
                                  static_cast<std::uint32_t>(first + next(i, chain.size()))});
    }
    std::vector<NearPoint> near;
    std::vector<Place> places;
    for (const Point& p : vertices) {
      boundary.points.push_back(&p);
      near.push_back(near_point(p));
      places.push_back({unit * p.x.get_d(), unit * p.y.get_d()});
    }
    made = triangulation(boundary, near, places);
  }

  const Point& source(std::uint32_t e) const { return vertices[made.sources[e]]; }
  const Point& target(std::uint32_t e) const { return source(Triangulation::next(e)); }
  const Point& apex(std::uint32_t e) const { return source(Triangulation::previous(e)); }

  std::vector<Point> vertices;
  SweptEdges boundary;
  Triangulation made;
};

using Edges = std::map<std::pair<Point, Point>, int>;

/// The edges of a region, cut at the points that were found in them.
Edges cut_edges(const Triangulated& of) {
  Edges result;
  auto point = of.made.points.begin();
  for (std::uint32_t e = 0; e < of.boundary.edges.size(); ++e) {
    Point from = of.vertices[of.boundary.edges[e].source];
    for (; point != of.made.points.end() && point->edge == e; ++point) {
      ++result[{from, point->point}];
      from = point->point;
    }
    ++result[{from, of.vertices[of.boundary.edges[e].target]}];
  }
  return result;
}

/// With holes, components, and chains that touch. That their areas add up and edges are those of the region means
/// that none is missing and none is there twice.
TEST(Triangulation, has_the_area_of_the_region_and_its_edges) {
  std::vector<Region> regions;
  for (const Shape& shape : shapes()) regions.push_back(shape.region);
  for (const Family& family : families()) {
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
      const auto [p, q] = generate(family, family.smallest + 2 + 7 * (seed - 1), seed);
      regions.push_back(p);
      regions.push_back(q);
    }
  }
  for (const Region& region : regions) {
    const Triangulated all(region);
    const Triangulation& made = all.made;
    Rational twice = 0;
    Edges outer;
    for (std::uint32_t e = 0; e < made.sources.size(); ++e) {
      if (e % 3 == 0) {
        const Rational of_triangle =
            cross(all.target(e) - all.source(e), all.apex(e) - all.source(e));
        EXPECT_GT(of_triangle, 0);
        twice += of_triangle;
      }
      const std::uint32_t twin = made.twins[e];
      if (twin == Triangulation::none) {
        ++outer[{all.source(e), all.target(e)}];
        continue;
      }
      EXPECT_EQ(made.twins[twin], e);
      EXPECT_EQ(all.source(twin), all.target(e));
      EXPECT_EQ(all.target(twin), all.source(e));
    }
    EXPECT_EQ(twice, 2 * area(region));
    EXPECT_EQ(outer, cut_edges(all));
  }
}

/// Positive where d is inside the circle through the others.
Rational in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Vector u = a - d, v = b - d, w = c - d;
  const auto square = [](const Vector& x) -> Rational { return x.x * x.x + x.y * x.y; };
  return square(u) * cross(v, w) + square(v) * cross(w, u) + square(w) * cross(u, v);
}

TEST(Triangulation, is_delaunay_but_for_the_edges) {
  std::size_t diagonals = 0;
  for (const char* name : {"star", "simple"}) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const Triangulated all(generate(*find_family(name), 60, seed).p);
      for (std::uint32_t e = 0; e < all.made.sources.size(); ++e) {
        const std::uint32_t twin = all.made.twins[e];
        if (twin == Triangulation::none) continue;
        EXPECT_LE(in_circle(all.source(e), all.target(e), all.apex(e), all.apex(twin)), 0) << name;
        ++diagonals;
      }
    }
  }
  EXPECT_GT(diagonals, 500U);
}

/// Places so near one another that products of four lose what would show that a flip is one.
TEST(Triangulation, what_doubles_lose_is_not_flipped) {
  std::size_t flipped = 0;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Region star = generate(*find_family("star"), 60, seed).p;
    const Triangulated none(star, 0);
    flipped += Triangulated(star).made.sources != none.made.sources;
    for (int power = -270; power <= -242; power += 4)
      EXPECT_EQ(Triangulated(star, std::ldexp(1, power)).made.sources, none.made.sources) << power;
  }
  EXPECT_EQ(flipped, 3U);
}

/// Where a fan would be made first, and flipped.
TEST(Triangulation, of_many_vertices_on_a_line) {
  Chain chain = {{0, 0}, {1000, 0}};
  for (int x = 999; x > 0; --x) chain.push_back({x, 1});
  const Triangulated all(polygon(chain));
  EXPECT_EQ(all.made.sources.size(), 3 * (chain.size() - 2));
}

/// A hole that touches the outer chain, and one that touches it with an edge's inside.
TEST(Triangulation, points_in_edges_are_in_order_along_them) {
  const Triangulated all(
      holed(box(0, 0, 8, 8), {{{6, 8}, {5, 7}, {7, 7}}, {{2, 8}, {1, 7}, {3, 7}}}));
  EXPECT_EQ(all.made.points, (std::vector<PointInEdge>{{2, {6, 8}}, {2, {2, 8}}}));
}

}  // namespace
}  // namespace oplus::pieces
