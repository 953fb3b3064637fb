// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/integer_summand.hpp"

#include <gtest/gtest.h>

#include "tests/checked/slide/exact_values.hpp"

namespace oplus::slide {
namespace {

TEST(EdgeDirection, turns_as_exact_numbers_do_where_doubles_err) {
  Random random(1);
  Scaling scaling;
  scaling.bits = 64;
  scaling.shift = 4;
  const auto number = [&] {
    mpz_class value = 1;
    for (int k = 0; k < 3; ++k) value = (value << 20) + uniform(random, 0, (1 << 20) - 1);
    return value;
  };
  std::size_t told = 0;
  for (int k = 0; k < 1000; ++k) {
    const mpz_class x = number(), y = number();
    const int off = uniform(random, -1, 1);
    const auto segment = [](const mpz_class& dx, const mpz_class& dy) {
      return integer_segment<WideNumbers>({{0, 0}, {dx, dy}});
    };
    const IntegerSegment<WideNumbers> a = segment(x, y), b = segment(3 * x + off, 3 * y);
    const NearSegment near_a = near(a, scaling), near_b = near(b, scaling);
    const EdgeDirection<WideNumbers> of_a{a.direction, near_a}, of_b{b.direction, near_b};
    EXPECT_EQ(turn(of_a, of_b), -off);
    EXPECT_EQ(turn(of_b, of_a), off);
    const NearSegment near_c = near(segment(number(), number()), scaling);
    told += certain_turn(near_a.dx, near_a.dy, near_c.dx, near_c.dy) != 0;
  }
  EXPECT_GT(told, 990u) << "doubles tell nearly all others";
}

}  // namespace
}  // namespace oplus::slide
