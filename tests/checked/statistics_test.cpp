// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/statistics.hpp"
#include "checked/timed.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace oplus {
namespace {

const Statistics some = {
    {"probes", std::size_t{7}}, {"seconds for cycles", Seconds(0.5)}, {"area", Rational(1, 3)}};

TEST(Statistics, are_found_by_name) {
  EXPECT_EQ(some.count("probes"), 7u);
  EXPECT_EQ(some.seconds("seconds for cycles"), Seconds(0.5));
  EXPECT_TRUE(some.contains("area"));
}

TEST(Statistics, say_what_they_do_not_have) {
  EXPECT_FALSE(some.contains("probe"));
  EXPECT_THROW(some.count("probe"), std::out_of_range);
  EXPECT_THROW(some.count("area"), std::bad_variant_access);
  EXPECT_THROW(some.seconds("probes"), std::bad_variant_access);
}

TEST(Statistics, keep_their_order) {
  std::string names;
  for (const Statistic& one : some) names += std::string(one.name) + ";";
  EXPECT_EQ(names, "probes;seconds for cycles;area;");
}

TEST(Timed, adds_to_the_total_and_returns_the_result) {
  Seconds total(1);
  EXPECT_EQ(timed(total, [] { return 3; }), 3);
  EXPECT_GE(total, Seconds(1));
}

}  // namespace
}  // namespace oplus
