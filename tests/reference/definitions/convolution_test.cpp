// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/convolution.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "reference/definitions/tangent_count.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

TEST(Convolution, is_a_part_of_all_sums_of_an_edge_and_a_vertex) {
  const Region p = polygon({{0, 0}, {4, 0}, {4, 3}, {1, 1}}), q = polygon({{0, 0}, {1, 0}, {0, 1}});
  const auto segments = [](const std::vector<ConvolutionSegment>& all) {
    std::vector<Segment> result;
    for (const ConvolutionSegment& one : all) result.push_back(one.segment);
    std::sort(result.begin(), result.end());
    return result;
  };
  const std::vector<Segment> all = segments(vertex_edge_sum(p, q)),
                             kept = segments(convolution(p, q));
  EXPECT_EQ(all.size(), 4 * 3 + 3 * 4U);
  EXPECT_LT(kept.size(), all.size());
  EXPECT_TRUE(std::includes(all.begin(), all.end(), kept.begin(), kept.end()));
}

TEST(Convolution, tangents_are_as_many_in_opposite_directions) {
  const Region p = holed(box(0, 0, 4, 4), {box(1, 1, 3, 3)}), q = polygon(box(0, 0, 1, 1));
  for (const Point& x :
       {Point{Rational(1, 2), Rational(1, 3)}, Point{Rational(5, 2), Rational(7, 3)}, Point{6, 7}})
    EXPECT_EQ(tangent_count(x, p, q, {3, 1}), tangent_count(x, p, q, {-3, -1}));
}

}  // namespace
}  // namespace oplus
