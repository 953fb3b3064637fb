// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/blocking_search.hpp"

#include <gtest/gtest.h>

#include "checked/slide/slide.hpp"
#include "reference/families/family.hpp"
#include "reference/families/random.hpp"
#include "tests/checked/slide/exact_values.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

double per_segment(const char* quantity_wanted, const Region& p, const Region& q) {
  const Statistics statistics = slide_sum(p, q, Boundary::closed).statistics;
  const auto count = [&](const char* name) {
    for (const auto& [quantity, value] : statistics)
      if (quantity == name) return std::get<std::size_t>(value);
    return std::size_t{0};
  };
  EXPECT_GT(count("segments slid along"), 0u);
  return static_cast<double>(count(quantity_wanted)) /
         static_cast<double>(count("segments slid along"));
}

double boxes_per_segment(const Region& p, const Region& q) {
  return per_segment("pairs of boxes", p, q);
}

const Region hexagon = polygon({{0, 0}, {3, -1}, {5, 1}, {5, 3}, {2, 4}, {0, 2}});

/// Teeth of height 10 on a triangle whose third vertex is `far` below.
Region comb_with_outlier(int teeth, const Rational& far) {
  Chain chain{{0, -far}, {2 * teeth, 0}};
  for (int i = teeth; i-- > 0;) {
    chain.push_back({2 * i + 1, 10});
    chain.push_back({2 * i, 0});
  }
  return polygon(std::move(chain));
}

TEST(BlockingSearch, sees_detail_beside_a_vertex_that_is_far_away) {
  for (const int bits : {5, 29, 30, 50, 100})
    EXPECT_LT(boxes_per_segment(comb_with_outlier(500, slide::power_of_two(bits)), hexagon), 100)
        << bits;
}

TEST(BlockingSearch, sees_detail_that_is_a_point_beside_the_other_summand) {
  const Region star = generate(*find_family("star"), 300, 1).p;
  const Rational far = slide::power_of_two(1500);
  for (const Region& large : {polygon(box(0, 0, far, far)), polygon(box(-far, -far, far, far))}) {
    EXPECT_LT(boxes_per_segment(star, large), 500);
    EXPECT_LT(boxes_per_segment(large, star), 500);
  }
}

TEST(BlockingSearch, does_not_depend_on_the_order_of_holes) {
  constexpr int k = 20;
  std::vector<Chain> holes;
  for (int i = 0; i < k * k; ++i) {
    const int x = i % k * 10, y = i / k * 10;
    holes.push_back(backwards(box(x + 3, y + 3, x + 7, y + 7)));
  }
  Random random(1);
  shuffle(random, holes);
  EXPECT_LT(boxes_per_segment({{{box(0, 0, 10 * k, 10 * k), holes}}}, polygon(box(0, 0, 1, 1))),
            100);
}

TEST(BlockingSearch, separates_long_slanted_teeth) {
  constexpr int teeth = 250, length = 1000;
  Chain chain{{-2, -2}, {4 * teeth - 2, -2}};
  for (int i = teeth; i-- > 0;) {
    chain.push_back({4 * i + 3, 0});
    chain.push_back({4 * i + 2 + length, length});
    chain.push_back({4 * i + 1 + length, length});
    chain.push_back({4 * i, 0});
  }
  EXPECT_LT(boxes_per_segment(polygon(std::move(chain)), hexagon), 200);
}

TEST(BlockingSearch, opens_few_boxes_that_are_only_touched) {
  const auto [p, q] = generate(*find_family("touching"), 60, 1);
  EXPECT_LT(boxes_per_segment(p, q), 80);
}

TEST(BlockingSearch, takes_few_rationals) {
  const auto [p, q] = generate(*find_family("fractions"), 100, 1);
  EXPECT_LT(per_segment("in rationals", p, q), 3);
}

}  // namespace
}  // namespace oplus
