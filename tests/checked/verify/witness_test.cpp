// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/verify/witness.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "reference/definitions/squared_distance.hpp"
#include "reference/definitions/verdicts_differ.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

TEST(PointNear, is_beside_its_edge_and_nearer_to_it_than_to_others) {
  // The square's left side is touched in its middle, by a triangle's vertex.
  std::vector<Segment> all = edges(Chain(box(0, 0, Rational(1, 1000000), 8)));
  const std::vector<Segment> triangle = edges(Chain{{-3, 3}, {0, 4}, {-3, 5}});
  all.insert(all.end(), triangle.begin(), triangle.end());
  const SegmentTree tree(all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const auto& [left, attempt] :
         {std::pair(true, 0), {true, 1}, {true, 2}, {false, 0}, {false, 2}}) {
      const Point x = point_near(tree, i, left, attempt);
      EXPECT_EQ(orientation(all[i].source, all[i].target, x), left ? 1 : -1);
      const Rational near = squared_distance(x, all[i]);
      EXPECT_GT(near, 0);
      for (std::size_t j = 0; j < all.size(); ++j) {
        if (j != i) {
          EXPECT_GT(squared_distance(x, all[j]), 0);
        }
      }
    }
  }
}

TEST(PointNear, is_not_found_where_edges_overlap) {
  const SegmentTree tree({{{0, 0}, {1, 0}}, {{1, 0}, {0, 0}}});
  EXPECT_THROW(point_near(tree, 0, true), VerdictsDiffer);
}

TEST(PointLeftOf, an_edge_is_on_nothing_that_is_avoided) {
  const std::vector<Segment> square = edges(Chain(box(0, 0, 4, 4)));
  std::vector<Segment> avoided;
  for (int k = 0; k < 5; ++k) {
    const Point x = point_left_of(square[0], square, avoided);
    EXPECT_TRUE(0 < x.x && x.x < 4 && 0 < x.y && x.y < 4 && !lies_on_one(x, avoided)) << k;
    avoided.push_back({{x.x, 0}, {x.x, 4}});
    avoided.push_back({{0, x.y}, {4, x.y}});
  }
}

}  // namespace
}  // namespace oplus
