// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/process.hpp"

#include <gtest/gtest.h>

#include <system_error>

namespace oplus {
namespace {

/// Longer than any of these takes.
constexpr double long_limit = 100'000;

EndedProcess run_in_shell(const std::string& script, double limit = long_limit) {
  return run_process({"/bin/sh", "-c", script}, limit);
}

TEST(Process, what_it_writes_and_its_exit_code_come_back) {
  const EndedProcess ended = run_in_shell("echo first; echo second; exit 3");
  EXPECT_EQ(ended.how, EndedProcess::How::exited);
  EXPECT_EQ(ended.code, 3);
  EXPECT_EQ(ended.output, "first\nsecond\n");
  EXPECT_GT(ended.peak_mb, 0);
}

TEST(Process, a_signal_is_told_from_an_exit_code) {
  const EndedProcess ended = run_in_shell("kill -SEGV $$");
  EXPECT_EQ(ended.how, EndedProcess::How::killed_by_signal);
  EXPECT_EQ(ended.code, 11);
}

TEST(Process, is_ended_where_it_takes_too_long) {
  const EndedProcess ended = run_in_shell("echo begun; exec sleep 100000", 0.2);
  EXPECT_EQ(ended.how, EndedProcess::How::over_limit);
}

TEST(Process, one_that_is_not_there_cannot_be_started) {
  EXPECT_THROW(run_process({"/not/there"}, long_limit), std::system_error);
}

TEST(Process, its_own_peak_is_at_least_what_it_has) {
  const double before = own_peak_mb();
  EXPECT_GT(before, 0);
  const std::vector<char> resident(100'000'000, 'x');
  EXPECT_GE(own_peak_mb(), static_cast<double>(resident.size()) / 1e6);
}

TEST(Process, knows_its_path) { EXPECT_TRUE(own_path().ends_with("oplus-bench-tests")); }

}  // namespace
}  // namespace oplus
