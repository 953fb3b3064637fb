// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/stitching.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "checked/slide/number_types.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/minkowski_sum.hpp"
#include "reference/definitions/sorted_without_copies.hpp"
#include "reference/families/polygons.hpp"
#include "reference/families/rich_regions.hpp"
#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus::slide {
namespace {

using Small = IntegerVector<SmallNumbers>;

/// Stitches edges, which meet at common ends only; segment i is edge i.
class Stitched {
 public:
  explicit Stitched(const std::vector<Segment>& edges) {
    for (const Segment& e : edges) points_.insert(points_.end(), {e.source, e.target});
    points_ = sorted_without_copies(std::move(points_));
    std::vector<BoundaryPiece> pieces;
    for (std::uint32_t i = 0; i < edges.size(); ++i)
      pieces.push_back({number_of(edges[i].source), number_of(edges[i].target), i});
    std::sort(pieces.begin(), pieces.end());
    chains = stitched(
        pieces, points_.size(),
        [&](std::uint32_t segment) {
          return integer_segment<SmallNumbers>(edges[segment]).direction;
        },
        1);
  }

  /// As the sum that has these chains, which are in the canonical order already.
  MinkowskiSum sum() const {
    MinkowskiSum result;
    for (const StitchedChains::Chain& stitched : chains.chains) {
      Chain chain;
      for (const StitchedChains::Edge& edge : chains.edges_of(stitched))
        chain.push_back(points_[edge.from]);
      (stitched.is_outer ? result.outer : result.holes).push_back(chain);
    }
    return result;
  }

  StitchedChains chains;

 private:
  std::uint32_t number_of(const Point& p) const {
    return static_cast<std::uint32_t>(std::lower_bound(points_.begin(), points_.end(), p) -
                                      points_.begin());
  }

  std::vector<Point> points_;
};

/// The edges of chains, cut where another one's vertex is inside them.
std::vector<Segment> edges_of(const std::vector<Chain>& chains) {
  std::vector<Point> vertices;
  for (const Chain& chain : chains) vertices.insert(vertices.end(), chain.begin(), chain.end());
  std::vector<Segment> all;
  for (const Chain& chain : chains)
    for (const Segment& edge : edges(chain))
      for (const Segment& piece : cut(edge, vertices)) all.push_back(piece);
  return all;
}

MinkowskiSum stitched_sum(const std::vector<Chain>& chains) {
  return Stitched(edges_of(chains)).sum();
}

TEST(Stitching, joins_squares_that_touch_at_a_vertex_to_one_chain) {
  const MinkowskiSum sum = stitched_sum({box(0, 0, 1, 1), box(1, 1, 2, 2)});
  EXPECT_EQ(sum.outer,
            (std::vector<Chain>{{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}}));
  EXPECT_TRUE(sum.holes.empty());
}

TEST(Stitching, keeps_holes_apart_that_touch_at_a_vertex) {
  const Chain first = backwards(box(1, 1, 2, 2)), second = backwards(box(2, 2, 3, 3));
  const MinkowskiSum sum = stitched_sum({box(0, 0, 4, 4), first, second});
  EXPECT_EQ(sum.outer, (std::vector<Chain>{box(0, 0, 4, 4)}));
  EXPECT_EQ(sum.holes, (std::vector<Chain>{{{1, 1}, {1, 2}, {2, 2}, {2, 1}},
                                           {{2, 2}, {2, 3}, {3, 3}, {3, 2}}}));
}

TEST(Stitching, keeps_a_hole_apart_that_touches_the_outer_chain) {
  // At a vertex of the outer chain, and inside its edge.
  const Chain at_vertex = backwards({{0, 0}, {2, 1}, {1, 2}});
  const MinkowskiSum at = stitched_sum({box(0, 0, 4, 4), at_vertex});
  EXPECT_EQ(at.outer, (std::vector<Chain>{box(0, 0, 4, 4)}));
  EXPECT_EQ(at.holes, (std::vector<Chain>{{{0, 0}, {1, 2}, {2, 1}}}));
  const Chain inside_edge = backwards({{2, 0}, {3, 1}, {1, 1}});
  const MinkowskiSum inside = stitched_sum({box(0, 0, 4, 4), inside_edge});
  EXPECT_EQ(inside.outer, (std::vector<Chain>{box(0, 0, 4, 4)}));
  EXPECT_EQ(inside.holes, (std::vector<Chain>{{{1, 1}, {3, 1}, {2, 0}}}));
}

TEST(Stitching, takes_each_of_what_is_in_each_other) {
  const std::vector<Chain> nested{box(0, 0, 9, 9), backwards(box(1, 1, 8, 8)), box(2, 2, 7, 7),
                                  backwards(box(3, 3, 6, 6)), box(4, 4, 5, 5)};
  const MinkowskiSum sum = stitched_sum(nested);
  EXPECT_EQ(sum.outer, (std::vector<Chain>{nested[0], nested[2], nested[4]}));
  EXPECT_EQ(sum.holes.size(), 2u);
}

TEST(Stitching, of_an_island_that_touches_its_hole_is_one_hole) {
  const Chain hole = backwards(box(1, 1, 5, 5)), island{{1, 3}, {3, 2}, {3, 4}};
  const MinkowskiSum sum = stitched_sum({box(0, 0, 6, 6), hole, island});
  EXPECT_EQ(sum.outer, (std::vector<Chain>{box(0, 0, 6, 6)}));
  EXPECT_EQ(sum.holes,
            (std::vector<Chain>{{{1, 1}, {1, 3}, {3, 2}, {3, 4}, {1, 3}, {1, 5}, {5, 5}, {5, 1}}}));
}

TEST(Stitching, drops_collinear_vertices_and_joins_their_segments) {
  // The lower side in three pieces, the second one of two segments.
  const std::vector<Segment> edges{{{1, 0}, {2, 0}}, {{2, 0}, {3, 0}}, {{3, 0}, {0, 3}},
                                   {{0, 3}, {0, 0}}, {{0, 0}, {1, 0}}, {{1, 0}, {2, 0}}};
  const Stitched result(edges);
  EXPECT_EQ(result.sum().outer, (std::vector<Chain>{{{0, 0}, {3, 0}, {0, 3}}}));
  ASSERT_EQ(result.chains.chains.size(), 1u);
  std::vector<std::vector<std::uint32_t>> segments;
  for (const StitchedChains::Edge& edge : result.chains.edges) {
    const auto of_edge = result.chains.segments_of(edge);
    segments.emplace_back(of_edge.begin(), of_edge.end());
    std::sort(segments.back().begin(), segments.back().end());
  }
  std::sort(segments.begin(), segments.end());
  EXPECT_EQ(segments, (std::vector<std::vector<std::uint32_t>>{{0, 1, 4, 5}, {2}, {3}}));
}

TEST(Stitching, gives_the_canonical_chains_of_any_region) {
  Random random(12);
  std::size_t touching = 0, several = 0;
  for (int k = 0; k < 200; ++k) {
    const Region region = k % 3 == 0   ? plain_region(random, 8)
                          : k % 3 == 1 ? holed_region(random, 6)
                                       : scattered_region(random, 6);
    if (!touching_points(region).empty()) ++touching;
    if (chains(region).size() > 2) ++several;
    EXPECT_EQ(stitched_sum(chains(region)), canonical_sum(region));
  }
  EXPECT_GT(touching, 20u);
  EXPECT_GT(several, 50u);
}

TEST(Stitching, starts_a_chain_that_passes_its_smallest_point_twice_as_the_plane_says) {
  // Two loops at (0, 0); what follows it first is smaller in one of them.
  const Chain upper{{0, 0}, {3, 1}, {1, 3}}, lower{{0, 0}, {1, -3}, {3, -1}};
  EXPECT_EQ(stitched_sum({upper, lower}).outer,
            (std::vector<Chain>{{{0, 0}, {1, -3}, {3, -1}, {0, 0}, {3, 1}, {1, 3}}}));
}

TEST(TurnsMoreClockwise, is_the_order_from_the_way_back) {
  // All directions but the way back, as they are met counterclockwise from there.
  const std::vector<Small> met{{-5, -1}, {-2, -2}, {-1, -9}, {0, -1}, {1, -7}, {4, -1}, {3, 0},
                               {9, 1},   {1, 1},   {1, 8},   {0, 3},  {-1, 8}, {-1, 1}, {-9, 1}};
  const Small in{2, 0};
  const auto turned = [](const Small& v, int times) {
    Small result = v;
    for (; times > 0; --times) result = {-result.y, result.x};
    return result;
  };
  for (int times = 0; times < 4; ++times) {
    for (std::size_t i = 0; i < met.size(); ++i) {
      for (std::size_t j = 0; j < met.size(); ++j) {
        EXPECT_EQ(detail::turns_more_clockwise(turned(in, times), turned(met[i], times),
                                               turned(met[j], times)),
                  i < j)
            << times << ": " << i << ", " << j;
      }
    }
  }
}

std::vector<Small> directions(const Chain& chain) {
  std::vector<Small> result;
  for (const Segment& edge : edges(chain))
    result.push_back(integer_segment<SmallNumbers>(edge).direction);
  return result;
}

int turning_number(const std::vector<Small>& directions) {
  int turns = 0;
  for (std::size_t i = 0; i < directions.size(); ++i)
    turns += detail::full_turns(directions[i], directions[(i + 1) % directions.size()]);
  return turns;
}

TEST(TurningNumber, is_one_or_minus_one_of_simple_chains) {
  Random random(13);
  for (int k = 0; k < 100; ++k) {
    const Chain chain = k % 2 == 0 ? plain_region(random, 9).components[0].outer
                                   : star_polygon(random, 20).components[0].outer;
    EXPECT_EQ(turning_number(directions(chain)), 1);
    EXPECT_EQ(turning_number(directions(backwards(chain))), -1);
  }
}

TEST(TurningNumber, of_a_spiral_is_one) {
  const Chain spiral{{0, 0}, {9, 0}, {9, 9}, {2, 9}, {2, 3}, {6, 3}, {6, 6},
                     {5, 6}, {5, 4}, {3, 4}, {3, 8}, {8, 8}, {8, 1}, {0, 1}};
  for (std::size_t start = 0; start < spiral.size(); ++start) {
    Chain chain = spiral;
    std::rotate(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(start), chain.end());
    EXPECT_EQ(turning_number(directions(chain)), 1) << start;
    EXPECT_EQ(turning_number(directions(backwards(chain))), -1) << start;
  }
}

TEST(TurningNumber, of_chains_that_cross_themselves) {
  const Chain twice_around{{0, 0}, {9, 0}, {9, 9}, {1, 9}, {1, 1}, {8, 1}, {8, 8}, {0, 8}};
  EXPECT_EQ(turning_number(directions(twice_around)), 2);
  const Chain eight{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  EXPECT_EQ(turning_number(directions(eight)), 0);
}

TEST(TurningNumber, counts_straight_corners_as_none) {
  const Chain square{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  EXPECT_EQ(turning_number(directions(square)), 1);
  EXPECT_EQ(turning_number(directions(backwards(square))), -1);
}

}  // namespace
}  // namespace oplus::slide
