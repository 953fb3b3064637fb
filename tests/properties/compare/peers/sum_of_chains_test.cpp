// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/peers/sum_of_chains.hpp"

#include <gtest/gtest.h>

namespace oplus {
namespace {

const Chain square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

std::string defect_of(const ReturnedChains& chains) {
  try {
    sum_of_chains(chains);
  } catch (const EngineFailure& e) {
    return e.site();
  }
  return "none";
}

TEST(SumOfChains, is_the_region_in_canonical_form) {
  const PlanarSet sum =
      sum_of_chains({{{4, 0}, {4, 4}, {0, 4}, {0, 0}, {2, 0}}, {{1, 1}, {1, 2}, {2, 2}}});
  EXPECT_EQ(sum.outer, std::vector<Chain>{square});
  EXPECT_EQ(sum.holes, (std::vector<Chain>{{{1, 1}, {1, 2}, {2, 2}}}));
  EXPECT_EQ(sum_of_chains({}), PlanarSet());
}

TEST(SumOfChains, may_touch_themselves_and_each_other_in_points) {
  // A chain that is two triangles, a hole that touches the outer chain inside an edge, and two holes.
  EXPECT_EQ(sum_of_chains({{{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}}}),
            sum_of_chains({{{0, 0}, {2, 0}, {1, 1}}, {{1, 1}, {2, 2}, {0, 2}}}));
  EXPECT_EQ(defect_of({square, {{2, 0}, {1, 1}, {2, 2}, {3, 1}}, {{2, 2}, {1, 3}, {3, 3}}}),
            "none");
  // An outer chain that goes round a hole on its way.
  EXPECT_EQ(
      sum_of_chains({{{0, 0}, {2, 0}, {1, 1}, {2, 2}, {3, 1}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}}),
      sum_of_chains({square, {{2, 0}, {1, 1}, {2, 2}, {3, 1}}}));
}

TEST(SumOfChains, of_too_few_vertices_are_unreadable) {
  EXPECT_EQ(defect_of({{}}), "a chain of 0 vertices");
  EXPECT_EQ(defect_of({square, {{1, 1}, {2, 2}}}), "a chain of 2 vertices");
  EXPECT_EQ(defect_of({{{0, 0}, {4, 0}, {4, 0}, {0, 4}}}), "an edge of length zero");
  EXPECT_EQ(defect_of({{{0, 0}, {4, 0}, {0, 4}, {0, 0}}}), "an edge of length zero");
}

TEST(SumOfChains, that_overlap_are_unreadable) {
  EXPECT_EQ(defect_of({{{0, 0}, {4, 0}, {4, 4}, {4, 6}, {4, 4}, {0, 4}}}),
            "an edge goes back along another");
  EXPECT_EQ(defect_of({{{0, 0}, {1, 1}, {2, 2}}}), "an edge goes back along another");
  EXPECT_EQ(defect_of({square, square}), "edges overlap");
  EXPECT_EQ(defect_of({square, {{4, 1}, {6, 1}, {6, 2}, {4, 2}}}),
            "an edge goes back along another");
}

TEST(SumOfChains, that_cross_are_unreadable) {
  EXPECT_EQ(defect_of({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}), "edges cross");
  // Through vertices only.
  EXPECT_EQ(defect_of({square, {{0, 0}, {6, -2}, {6, 6}}}),
            "winding number 2 to the left of an edge");
}

TEST(SumOfChains, with_the_sum_on_the_wrong_side_are_unreadable) {
  const Chain hole{{1, 1}, {1, 2}, {2, 2}};
  const Chain island{{1, 1}, {2, 2}, {1, 2}};
  EXPECT_EQ(defect_of({square, hole}), "none");
  EXPECT_EQ(defect_of({square, island}), "winding number 2 to the left of an edge");
  EXPECT_EQ(defect_of({hole}), "winding number 0 to the left of an edge");
}

}  // namespace
}  // namespace oplus
