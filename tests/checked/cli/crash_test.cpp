// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/crash.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

namespace oplus {
namespace {

/// Throws from a noexcept function.
void lose_an_exception() noexcept { std::vector<int>().at(0); }

TEST(CrashDeathTest, becomes_a_line_and_the_exit_code_of_a_bug) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto reported = "^oplus: a bug in oplus: the program crashed; please report it[^\n]*\n$";
  EXPECT_EXIT((report_crashes(), std::abort()), testing::ExitedWithCode(3), reported);
  EXPECT_EXIT((report_crashes(), lose_an_exception()), testing::ExitedWithCode(3), reported);
}

}  // namespace
}  // namespace oplus
