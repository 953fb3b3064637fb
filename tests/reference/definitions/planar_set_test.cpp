// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/planar_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/chains/region_of.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

using Chains = std::vector<Chain>;
using Segments = std::vector<Segment>;

const Chain square = box(0, 0, 4, 4);

TEST(PlanarSet, two_squares_touching_in_a_corner_are_one_outer_chain) {
  const Region region = shape("two squares touching in a corner");
  // Both bound the same face of the complement: clockwise most, so from one into the other.
  EXPECT_EQ(canonical_sum(region).outer,
            (Chains{{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}}));
}

TEST(PlanarSet, chain_that_starts_where_it_touches_itself_is_the_smaller_rotation) {
  const Region region{{{{{0, 0}, {2, 0}, {2, 1}}, {}}, {{{0, 0}, {1, 2}, {0, 2}}, {}}}};
  EXPECT_EQ(canonical_sum(region).outer,
            (Chains{{{0, 0}, {1, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 1}}}));
}

TEST(PlanarSet, hole_that_starts_where_it_touches_itself_is_no_outer_chain) {
  const Chain hole{{0, 0}, {4, 4}, {4, -4}}, island{{0, 0}, {2, -1}, {2, 1}};
  const Region region{{{box(-9, -9, 9, 9), {hole}}, {island, {}}}};
  const PlanarSet sum = canonical_sum(region);
  EXPECT_EQ(sum.outer, Chains{box(-9, -9, 9, 9)});
  EXPECT_EQ(sum.holes, (Chains{{{0, 0}, {2, -1}, {2, 1}, {0, 0}, {4, 4}, {4, -4}}}));
}

/// Each edge times one unlike denominator or another.
Chain long_chain(std::size_t n) {
  Chain chain;
  for (long i = 0; i < static_cast<long>(n); ++i) {
    const Rational size = Rational(i * i % 101 + 7) / (3 * i % 97 + 1);
    chain.push_back({size * (i * 37 % 61 - 30) / 7, size * 5});
  }
  return chain;
}

TEST(Area, of_chains_of_any_length_is_that_of_their_edges_one_by_one) {
  for (std::size_t n = 0; n < 200; ++n) {
    const Chain chain = long_chain(n);
    Rational twice = 0;
    for (const Segment& e : edges(chain)) twice += cross(e.source, e.target);
    EXPECT_EQ(twice_area(chain), twice) << n;
    PlanarSet chains;
    twice = 0;
    for (std::size_t k = 0; k < n % 20; ++k) {
      chains.holes.push_back(long_chain(n + k));
      twice += twice_area(chains.holes.back());
    }
    EXPECT_EQ(area(chains), twice / 2) << n;
  }
}

TEST(PlanarSet, hole_touching_the_outer_chain_stays_a_chain_of_its_own) {
  const PlanarSet sum = canonical_sum(shape("hole touching the outer chain"));
  EXPECT_EQ(sum.outer, Chains{square});
  EXPECT_EQ(sum.holes, (Chains{{{1, 1}, {2, 2}, {3, 1}, {2, 0}}}));
}

TEST(PlanarSet, does_not_depend_on_the_order_of_the_edges) {
  const Region region{{{box(0, 0, 1, 1), {}}, {{{1, 1}, {2, 1}, {1, 2}}, {}}}};
  const PlanarSet expected = canonical_sum(region);
  Segments boundary = edges(region);
  std::sort(boundary.begin(), boundary.end());
  do {
    ASSERT_EQ(canonical_sum(BoundaryFeatures{boundary, {}, {}}), expected);
  } while (std::next_permutation(boundary.begin(), boundary.end()));
}

TEST(PlanarSet, dangling_edges_are_maximal_directed_and_sorted) {
  const PlanarSet sum = canonical_sum(
      BoundaryFeatures{edges(square), {{{3, 1}, {2, 1}}, {{1, 1}, {2, 1}}, {{1, 3}, {1, 2}}}, {}});
  EXPECT_EQ(sum.dangling_edges, (Segments{{{1, 1}, {3, 1}}, {{1, 2}, {1, 3}}}));
}

TEST(PlanarSet, nothing_at_all_is_the_empty_sum) {
  EXPECT_EQ(canonical_sum(BoundaryFeatures{}), PlanarSet{});
  EXPECT_EQ(canonical_sum(Region{}), PlanarSet{});
  EXPECT_EQ(region_of(PlanarSet{}), Region{});
  EXPECT_EQ(area(PlanarSet{}), 0);
}

/// The named reduced convolution segments, their corners left out: origins do not look at them.
ConvolutionSegment named(const Segment& segment, std::size_t name) {
  return {segment, {Summand::P, {0, name}, {0, 0}}, {}};
}

std::vector<std::vector<std::size_t>> names(const Origins& origins) {
  std::vector<std::vector<std::size_t>> result;
  for (const auto& of_edge : origins) {
    result.emplace_back();
    for (const Origin& origin : of_edge) result.back().push_back(origin.edge.vertex);
  }
  return result;
}

TEST(PlanarSet, origins_run_along_an_edge_in_its_direction) {
  const PlanarSet sum{{box(0, 0, 4, 4)}, {}, {}, {}};
  const std::vector<ConvolutionSegment> reduced{
      named({{2, 0}, {4, 0}}, 5),   // a part
      named({{-1, 0}, {2, 0}}, 3),  // another, longer than the edge
      named({{4, 0}, {0, 0}}, 1),   // against it
      named({{4, 0}, {6, 0}}, 2),   // only an end in common
      named({{0, 1}, {4, 1}}, 4),   // beside it
      named({{1, 0}, {1, 3}}, 6),   // across
      named({{4, 0}, {4, 4}}, 7),   // the next edge
  };
  EXPECT_EQ(names(origins(sum, reduced)),
            (std::vector<std::vector<std::size_t>>{{3, 5}, {7}, {}, {}}));
}

TEST(PlanarSet, origins_of_a_dangling_edge_run_either_way) {
  const PlanarSet sum{{}, {}, {{{0, 0}, {4, 0}}}, {}};
  EXPECT_EQ(names(origins(sum, {named({{4, 0}, {1, 0}}, 2), named({{0, 0}, {2, 0}}, 1),
                                named({{0, 0}, {0, 1}}, 3)})),
            (std::vector<std::vector<std::size_t>>{{1, 2}}));
}

TEST(PlanarSet, smallest_rotation_of_a_chain_that_repeats_itself) {
  EXPECT_EQ(start_of_smallest_rotation({{1, 0}, {0, 0}, {1, 0}, {0, 0}}), 1U);
}

}  // namespace
}  // namespace oplus
