// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chains/near_point.hpp"

#include <gtest/gtest.h>

#include "tests/reference/chains/random_regions.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

TEST(NearPoint, order_orientation_and_sign_of_area_are_exact) {
  Random random(26);
  const Rational tiny = 1 / Rational("1" + std::string(400, '0'));
  for (int i = 0; i < 3000; ++i) {
    Chain chain;
    for (int v = uniform(random, 3, 6); v > 0; --v) {
      const Rational x = uniform(random, 0, 3);
      const Rational y = uniform(random, 0, 3);
      chain.push_back({x / 3, y / 3});
    }
    if (one_in(random, 3)) chain[0].x += tiny;
    const NearPoint a = near_point(chain[0]), b = near_point(chain[1]), c = near_point(chain[2]);
    ASSERT_EQ(compare(a, b) < 0, chain[0] < chain[1]);
    ASSERT_EQ(compare(a, b) == 0, chain[0] == chain[1]);
    ASSERT_EQ(orientation(a, b, c), orientation(chain[0], chain[1], chain[2]));
    ASSERT_EQ(sign_of_area(chain), sgn(twice_area(chain))) << testing::PrintToString(chain);
  }
}

}  // namespace
}  // namespace oplus
