// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/paths.hpp"

#include <gtest/gtest.h>

namespace oplus::smt {
namespace {

const Term x = Term::unknown("x"), y = Term::unknown("y");

TEST(Executed, IsTheCodeAsAFormula) {
  const Formula larger_is_positive = executed([] { return (x < y ? y : x) > 0; });
  for (int a = -2; a <= 2; ++a)
    for (int b = -2; b <= 2; ++b)
      EXPECT_EQ(larger_is_positive.holds_in({{{"x", a}, {"y", b}}, {}}), std::max(a, b) > 0);
}

TEST(Executed, SkipsPathsThatEarlierAnswersExclude) {
  EXPECT_EQ(executed([] { return x < y && y < x; }).value(), false);
  EXPECT_EQ(executed([] { return x <= y || x - y > 0; }).value(), true);
  EXPECT_EQ(executed([] { return (x < y) == (Term(2) * x - Term(2) * y < 0); }).value(), true);
  EXPECT_EQ(executed([] { return is_set("f") == is_set("f"); }).value(), true);
}

TEST(Executed, HasFlags) {
  const Formula chosen = executed([] { return is_set("f") ? x > 0 : x < 0; });
  EXPECT_TRUE(chosen.holds_in({{{"x", 1}}, {{"f", true}}}));
  EXPECT_FALSE(chosen.holds_in({{{"x", 1}}, {{"f", false}}}));
}

TEST(Executed, PassesExceptionsOfTheCodeOn) {
  EXPECT_THROW(executed([]() -> bool {
                 if (x < 0) throw std::runtime_error("from the code");
                 return true;
               }),
               std::runtime_error);
  EXPECT_EQ(executed([] { return true; }).value(), true);
}

TEST(Executed, UnknownsCannotBeComparedElsewhere) {
  EXPECT_THROW(static_cast<void>(x < y), std::logic_error);
  EXPECT_TRUE(x - x == 0);
  EXPECT_THROW(executed([] { return executed([] { return x < y; }).value().has_value(); }),
               std::logic_error);
}

}  // namespace
}  // namespace oplus::smt
