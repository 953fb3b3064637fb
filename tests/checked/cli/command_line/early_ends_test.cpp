// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/early_ends.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>
#include <vector>

namespace oplus {
namespace {

/// Throws from a noexcept function.
void lose_an_exception() noexcept { std::vector<int>().at(0); }

TEST(CrashDeathTest, becomes_a_line_and_the_exit_code_of_a_bug) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto reported = "^oplus: a bug in oplus: the program crashed; please report it[^\n]*\n$";
  EXPECT_EXIT((report_crashes(), std::abort()), testing::ExitedWithCode(3), reported);
  EXPECT_EXIT((report_crashes(), prepare_for_early_ends(), lose_an_exception()),
              testing::ExitedWithCode(3), reported);
}

/// The same for more memory than there is.
void lose_memory() noexcept {
  volatile std::size_t size = std::numeric_limits<std::ptrdiff_t>::max();
  ::operator delete(::operator new(size));
}

TEST(CrashDeathTest, is_none_where_memory_is_missing) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT((report_crashes(), prepare_for_early_ends(), lose_memory()),
              testing::ExitedWithCode(2), "^oplus: there is not enough memory for this input\n$");
}

#ifndef __SANITIZE_ADDRESS__
TEST(EarlyEndsDeathTest, come_before_the_machine_has_no_memory_left) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto is_limited = [] {
    rlimit limit{};
    getrlimit(RLIMIT_DATA, &limit);
    const auto pages = static_cast<rlim_t>(sysconf(_SC_PHYS_PAGES));
    return limit.rlim_cur < 2 * pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
  };
  EXPECT_EXIT((prepare_for_early_ends(), _exit(is_limited() ? 0 : 1)), testing::ExitedWithCode(0),
              "");
}
#endif

}  // namespace
}  // namespace oplus
