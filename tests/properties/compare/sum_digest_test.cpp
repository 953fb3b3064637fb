// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/sum_digest.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "reference/chains/region_of.hpp"

namespace oplus {
namespace {

TEST(SumDigest, tells_pairs_and_sums_apart_and_adds_up_in_any_order) {
  const PlanarSet triangle = canonical_sum(polygon({{0, 0}, {1, 0}, {0, 1}}));
  const PlanarSet square = canonical_sum(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  const auto digest_of = [](std::uint64_t pair, const PlanarSet& closed, const PlanarSet& open) {
    SumDigest digest;
    digest.add(pair, closed, open);
    return digest;
  };
  const SumDigest one = digest_of(1, triangle, triangle);
  EXPECT_FALSE(one == digest_of(2, triangle, triangle));
  EXPECT_FALSE(one == digest_of(1, square, triangle));
  EXPECT_FALSE(one == digest_of(1, triangle, square));
  EXPECT_EQ(SumDigest(one.to_string()), one);
  SumDigest ab = one, ba = digest_of(2, square, square);
  ab.add(ba);
  ba.add(one);
  EXPECT_EQ(ab, ba);
  SumDigest high("0000000000000000ffffffffffffffff");
  high.add(SumDigest("00000000000000000000000000000001"));
  EXPECT_EQ(high.to_string(), "00000000000000010000000000000000");
  EXPECT_THROW(SumDigest("12"), std::invalid_argument);
}

}  // namespace
}  // namespace oplus
