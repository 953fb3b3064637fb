// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/exact_point.hpp"

#include <gtest/gtest.h>

#include "tests/checked/slide/exact_values.hpp"

namespace oplus::slide {
namespace {

template <typename Numbers>
class CoordinateIn : public testing::Test {};
using Specialised = testing::Types<SmallNumbers, WideNumbers>;
TYPED_TEST_SUITE(CoordinateIn, Specialised);

TYPED_TEST(CoordinateIn, is_in_the_order_of_the_rationals) {
  using Numbers = TypeParam;
  Random random(3);
  struct Both {
    detail::Coordinate<Numbers> coordinate;
    Rational exact;
  };
  std::vector<Both> all;
  for (int k = 0; k < 100; ++k) {
    const int source = uniform(random, -3, 3), direction = uniform(random, -3, 3);
    Rational t(uniform(random, 0, 9), uniform(random, 9, 12));
    t.canonicalize();
    all.push_back(
        {{source, direction, fraction<Numbers>(t.get_num(), t.get_den())}, source + direction * t});
  }
  for (const Both& a : all) {
    for (const Both& b : all) {
      EXPECT_EQ(a.coordinate < b.coordinate, a.exact < b.exact) << a.exact << ' ' << b.exact;
      EXPECT_EQ(a.coordinate == b.coordinate, a.exact == b.exact) << a.exact << ' ' << b.exact;
    }
  }
}

}  // namespace
}  // namespace oplus::slide
