// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/stitching.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "checked/slide/number_types.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/sorted_without_copies.hpp"
#include "reference/families/rich_regions.hpp"
#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus::slide {
namespace {

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
  PlanarSet sum() const {
    PlanarSet result;
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

PlanarSet stitched_sum(const std::vector<Chain>& chains) {
  return Stitched(edges_of(chains)).sum();
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

TEST(Stitching, starts_a_chain_at_the_smallest_of_its_rotations) {
  using Points = std::vector<std::uint32_t>;
  const auto rotated = [](const Points& points) {
    std::vector<StitchedChains::Edge> chain;
    for (const std::uint32_t from : points) chain.push_back({from, 0, 0});
    detail::rotate_to_smallest(chain);
    Points result;
    for (const StitchedChains::Edge& edge : chain) result.push_back(edge.from);
    return result;
  };
  EXPECT_EQ(rotated({5, 1, 3, 1, 2}), (Points{1, 2, 5, 1, 3}));
  EXPECT_EQ(rotated({5, 1, 2, 1, 3}), (Points{1, 2, 1, 3, 5}));
  EXPECT_EQ(rotated({2, 1, 2, 1}), (Points{1, 2, 1, 2}));
}

}  // namespace
}  // namespace oplus::slide
