// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/planar_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/chains/region_of.hpp"
#include "reference/chains/validity.hpp"
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

/// Closed sums in which chains touch in every way: each other, themselves, at vertices and inside
/// edges.
std::vector<Shape> touching_shapes() {
  std::vector<Shape> all = shapes();
  const std::vector<Shape> more{
      {"two holes touching in a corner",
       holed(box(0, 0, 5, 5), {box(1, 1, 2, 2), box(2, 2, 3, 3)})},
      {"island touching its hole in a corner",
       together({holed(box(0, 0, 5, 5), {box(1, 1, 4, 4)}), polygon({{1, 1}, {3, 2}, {2, 3}})})},
      {"frame in a frame", together({holed(box(0, 0, 9, 9), {box(1, 1, 8, 8)}),
                                     holed(box(2, 2, 7, 7), {box(3, 3, 6, 6)})})},
      {"three triangles in a ring",
       together({polygon({{0, 0}, {2, 0}, {1, 2}}), polygon({{2, 0}, {4, 0}, {3, 2}}),
                 polygon({{1, 2}, {3, 2}, {2, 4}})})},
      {"two triangles on a line touching in a vertex of both",
       together({polygon({{0, 0}, {2, 0}, {0, 2}}), polygon({{2, 0}, {4, 0}, {4, 2}})})},
      {"two holes on a line touching in a vertex of both",
       holed(box(-1, -1, 5, 5), {{{0, 0}, {2, 0}, {0, 2}}, {{2, 0}, {4, 0}, {4, 2}}})},
      {"island with its tip inside an edge of its hole",
       together({holed(box(0, 0, 5, 5), {box(1, 1, 4, 4)}), polygon({{2, 1}, {3, 2}, {2, 3}})})},
      {"hole whose edges' middles touch the outer chain",
       holed({{-2, -2}, {4, 0}, {10, -2}, {6, 4}, {4, 12}, {2, 4}}, {{{8, 0}, {4, 8}, {0, 0}}})},
  };
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

TEST(PlanarSet, as_a_region_is_the_same_sum) {
  for (const Shape& shape : touching_shapes()) {
    const PlanarSet sum = canonical_sum(shape.region);
    EXPECT_EQ(canonical_sum(region_of(sum)), sum) << shape.name;
    EXPECT_EQ(area(region_of(sum)), area(shape.region)) << shape.name;
    EXPECT_EQ(area(sum), area(shape.region)) << shape.name;
  }
}

TEST(PlanarSet, as_a_region_is_valid) {
  for (const Shape& shape : touching_shapes()) {
    ASSERT_FALSE(find_defect(shape.region)) << shape.name;
    const auto defect = find_defect(region_of(canonical_sum(shape.region)));
    EXPECT_FALSE(defect) << shape.name << ": " << describe(defect->kind) << " at "
                         << testing::PrintToString(defect->where);
  }
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

}  // namespace
}  // namespace oplus
