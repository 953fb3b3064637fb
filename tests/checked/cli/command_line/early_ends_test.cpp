// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/early_ends.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>
#include <vector>

#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class EarlyEnds : public ShellWithRegions {
 protected:
  /// A star of that many vertices.
  void put_star(const std::string& file, int vertices) const {
    run("oplus gen star --n " + std::to_string(vertices) + " --seed 1 -o " + file);
  }
};

TEST_F(EarlyEnds, by_a_limit_of_file_size_are_errors_of_writing) {
  put_star("star.wkt", 500);
  for (const std::string command :
       {"oplus sum star.wkt square.wkt -o s.wkt", "oplus draw star.wkt square.wkt -o s.svg",
        "oplus batch --parts star.wkt -o s.jsonl", "oplus gen star --n 900 -o s.wkt"})
    expect_refusal("ulimit -f 1; " + command, "File too large");
}

TEST_F(EarlyEnds, for_lack_of_memory_are_those_of_invalid_input) {
  put_star("star.wkt", 3000);
  for (const std::string command : {"oplus sum star.wkt star.wkt -o s.wkt --svg s.svg",
                                    "oplus sum star.wkt star.wkt --engine rca -o s.wkt",
                                    "oplus verify star.wkt star.wkt star.wkt"})
    expect_refusal("ulimit -v 50000; " + command, "not enough memory");
  expect_refusal("ulimit -d 50000; oplus sum star.wkt star.wkt --engine rca -o s.wkt",
                 "not enough memory");
  // Of a batch it is the error of a pair.
  const Ran batch = run("ulimit -v 50000; oplus batch --parts star.wkt -o s.jsonl", 2);
  EXPECT_EQ(batch.lines_of_err(), 1) << batch.err;
  EXPECT_TRUE(has(batch.err, "not enough memory"));
  for (const std::string& file : files()) EXPECT_FALSE(file.ends_with(".tmp")) << file;
}

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
