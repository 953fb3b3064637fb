// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/winding_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "checked/arrangement/sum_by_winding_numbers.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

std::vector<int> sorted_numbers(const std::vector<ConvolutionSegment>& segments) {
  std::vector<int> numbers = winding_numbers(ConvolutionArrangement(segments));
  EXPECT_EQ(numbers.at(ConvolutionArrangement::unbounded), 0);
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

TEST(WindingNumbers, of_convex_polygons_are_zero_and_one) {
  const Region square = polygon(box(0, 0, 1, 1));
  EXPECT_EQ(sorted_numbers(convolution(square, square)), (std::vector<int>{0, 1}));
  EXPECT_EQ(sorted_numbers({}), (std::vector<int>{0}));
}

TEST(WindingNumbers, of_an_l_and_a_square_count_the_reflex_vertex) {
  const Region l = polygon({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}});
  const std::vector<int> numbers = sorted_numbers(convolution(l, polygon(box(0, 0, 2, 2))));
  // 2 where the square, reflected and placed, has the reflex vertex inside.
  EXPECT_EQ(numbers.front(), 0);
  EXPECT_EQ(numbers.back(), 2);
}

TEST(WindingNumbers, of_a_hole_that_the_other_summand_fits_into_are_zero) {
  const Region frame{{{box(0, 0, 9, 9), {backwards(box(1, 1, 8, 8))}}}};
  const std::vector<int> numbers = sorted_numbers(convolution(frame, polygon(box(0, 0, 1, 1))));
  EXPECT_EQ(std::count(numbers.begin(), numbers.end(), 0), 2) << "outside, and the hole";
}

TEST(SumByWindingNumbers, asks_no_hole_test_where_closed) {
  const Region frame{{{box(0, 0, 5, 5), {backwards(box(1, 1, 4, 3))}}}};
  const Region square = polygon(box(0, 0, 2, 2));
  const ComputedSum closed = sum_by_winding_numbers(frame, square, Boundary::closed);
  EXPECT_EQ(closed.statistics.count("hole tests") +
                closed.statistics.count("tests of low-dimensional features"),
            0u);
  const ComputedSum open = sum_by_winding_numbers(frame, square, Boundary::open);
  EXPECT_GT(open.statistics.count("tests of low-dimensional features"), 0u);
  EXPECT_EQ(open.sum.dangling_edges, (std::vector<Segment>{{{3, 3}, {4, 3}}}));
}

}  // namespace
}  // namespace oplus
