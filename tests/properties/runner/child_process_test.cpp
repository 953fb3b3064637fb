// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/child_process.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <array>
#include <filesystem>

#include <fstream>
#include <iterator>
#include <system_error>
#include <thread>

namespace oplus {
namespace {

using How = EndedProcess::How;

ProcessLimits quiet(double seconds = 100'000) {
  ProcessLimits limits;
  limits.seconds = seconds;
  limits.is_quiet = true;
  return limits;
}

EndedProcess run_in_shell(const std::string& script, const ProcessLimits& limits = quiet()) {
  return run_program({"/bin/sh", "-c", script}, limits);
}

/// Whether a process of this number is there and no zombie.
bool is_running(const std::string& process) {
  std::ifstream status("/proc/" + process + "/stat");
  const std::string text{std::istreambuf_iterator<char>(status), {}};
  return !text.empty() && text.find(") Z") == std::string::npos;
}

/// Killing takes effect in its own time.
void expect_ends(std::string process) {
  process.erase(process.find_last_not_of("\n") + 1);
  ASSERT_FALSE(process.empty());
  while (is_running(process)) std::this_thread::yield();
}

TEST(RunProgram, returns_the_output_and_the_exit_code) {
  const EndedProcess ended = run_in_shell("echo first; echo why >&2; echo second; exit 3");
  EXPECT_EQ(ended.how, How::exited);
  EXPECT_EQ(ended.code, 3);
  EXPECT_EQ(ended.output, "first\nsecond\n");
  EXPECT_EQ(ended.errors, "why\n");
  EXPECT_GT(ended.peak_mb, 0);
}

TEST(RunProgram, standard_input_is_empty) { EXPECT_EQ(run_in_shell("cat; echo $?").output, "0\n"); }

TEST(RunProgram, has_not_the_limit_of_memory_of_this_program) {
  rlimit own{};
  ASSERT_EQ(getrlimit(RLIMIT_DATA, &own), 0);
  const rlimit less{own.rlim_max / 2, own.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_DATA, &less), 0);
  EXPECT_EQ(run_in_shell("test $(ulimit -S -d) = $(ulimit -H -d)").code, 0);
  EXPECT_EQ(setrlimit(RLIMIT_DATA, &own), 0);
}

TEST(RunProgram, arguments_arrive_as_they_are) {
  const std::string argument = "two words, 'quotes', \"more\" and $HOME\n";
  EXPECT_EQ(run_program({"/bin/sh", "-c", "printf %s \"$1\"", "sh", argument}, quiet()).output,
            argument);
}

TEST(RunProgram, is_killed_at_the_time_limit_with_its_children) {
  const EndedProcess ended = run_in_shell("sleep 100000 & echo $!; exec sleep 100000", quiet(0.3));
  EXPECT_EQ(ended.how, How::over_time);
  expect_ends(ended.output);
}

TEST(RunProgram, has_ended_even_if_its_children_have_not) {
  const EndedProcess ended = run_in_shell("sleep 100000 & echo $!");
  EXPECT_EQ(ended.how, How::exited);
  EXPECT_EQ(ended.code, 0);
  expect_ends(ended.output);
}

TEST(RunProgram, only_the_end_of_many_errors_is_kept) {
  const EndedProcess ended = run_in_shell("head -c 5000000 /dev/zero >&2; echo the end >&2");
  EXPECT_LT(ended.errors.size(), 1'000'000U);
  EXPECT_TRUE(ended.errors.ends_with("the end\n"));
}

TEST(RunProgram, a_missing_program_cannot_be_started) {
  EXPECT_THROW(run_program({"/not/there"}, quiet()), std::system_error);
}

TEST(RunProgram, many_threads_run_programs_at_a_time) {
  std::vector<std::thread> threads;
  std::array<int, 4> wrong{};
  for (std::size_t t = 0; t < wrong.size(); ++t)
    threads.emplace_back([&wrong, t] {
      for (int i = 0; i < 25; ++i)
        wrong[t] += run_in_shell("echo " + std::to_string(i)).output != std::to_string(i) + "\n";
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, (std::array<int, 4>{}));
}

TEST(OwnPeak, is_at_least_the_current_size) {
  EXPECT_GT(own_peak_mb(), 0);
  const std::vector<char> resident(100'000'000, 'x');
  EXPECT_GE(own_peak_mb(), static_cast<double>(resident.size()) / 1e6);
}

TEST(ProgramBeside, is_in_the_same_folder) {
  EXPECT_TRUE(std::filesystem::is_regular_file(program_beside("oplus-check")));
  EXPECT_EQ(program_beside("").find_last_of('/'), program_beside("oplus-peer").find_last_of('/'));
}

TEST(SignalName, is_as_in_signal_h) {
  EXPECT_EQ(signal_name(SIGSEGV), "SIGSEGV");
  EXPECT_EQ(signal_name(SIGABRT), "SIGABRT");
  EXPECT_EQ(signal_name(99), "signal 99");
}

}  // namespace
}  // namespace oplus
