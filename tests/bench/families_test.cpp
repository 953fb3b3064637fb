// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/families.hpp"

#include <gtest/gtest.h>

namespace oplus {
namespace {

using Sizes = std::vector<std::size_t>;

TEST(GrowingFamilies, the_scale_changes_the_largest_size) {
  const SizeRange range{10, 40, 10};
  EXPECT_EQ(sizes(range, 1), Sizes({10, 20, 30, 40}));
  EXPECT_EQ(sizes(range, 0.5), Sizes({10, 20}));
  EXPECT_EQ(sizes(range, 0.99), Sizes({10, 20, 30}));
  EXPECT_EQ(sizes(range, 1.5), Sizes({10, 20, 30, 40, 50, 60}));
  EXPECT_EQ(sizes(range, 0), Sizes({10}));
  EXPECT_EQ(sizes({50, 980, 30}, 1).back(), 980U);
}

TEST(GrowingFamilies, sizes_double_without_a_step) {
  EXPECT_EQ(sizes({25, 200}, 1), Sizes({25, 50, 100, 200}));
  EXPECT_EQ(sizes({25, 200}, 0.9), Sizes({25, 50, 100}));
  EXPECT_EQ(sizes({25, 200}, 0), Sizes({25}));
}

TEST(GrowingFamilies, each_size_has_its_own_bits) {
  const auto first = [](const std::string& experiment, std::uint64_t seed, std::size_t size) {
    return random_of(experiment, seed, size)();
  };
  const std::uint64_t one = first("a", 1, 30);
  EXPECT_EQ(one, first("a", 1, 30));
  EXPECT_NE(one, first("b", 1, 30));
  EXPECT_NE(one, first("a", 2, 30));
  EXPECT_NE(one, first("a", 1 + (1ULL << 32), 30));
  EXPECT_NE(one, first("a", 1, 31));
}

}  // namespace
}  // namespace oplus
