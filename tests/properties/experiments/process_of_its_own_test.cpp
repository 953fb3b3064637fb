// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/experiments/process_of_its_own.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <new>
#include <stdexcept>
#include <vector>

#include "reference/definitions/rational.hpp"

namespace oplus {
namespace {

using Kind = ProcessReport::Kind;

TEST(ProcessOfItsOwn, returns_what_the_work_returns_however_long) {
  const std::string text(1'000'000, 'x');
  const ProcessReport report = in_process_of_its_own([&] { return text; }, 0);
  EXPECT_EQ(report.kind, Kind::done);
  EXPECT_EQ(report.text, text);
}

TEST(ProcessOfItsOwn, is_another_process_that_changes_nothing_here) {
  int changed = 0;
  const ProcessReport report = in_process_of_its_own(
      [&] {
        changed = 1;
        return std::to_string(::getpid());
      },
      0);
  EXPECT_NE(report.text, std::to_string(::getpid()));
  EXPECT_EQ(changed, 0);
}

TEST(ProcessOfItsOwn, work_that_is_killed_is_reported) {
  const auto dies = []() -> std::string {
    ::kill(::getpid(), SIGKILL);
    return "alive";
  };
  const ProcessReport report = in_process_of_its_own(dies, 0);
  EXPECT_EQ(report.kind, Kind::failed);
  EXPECT_EQ(report.text, "killed by signal 9, Killed");
}

TEST(ProcessOfItsOwn, work_that_throws_is_reported_with_what_it_says) {
  const ProcessReport report =
      in_process_of_its_own([]() -> std::string { throw std::logic_error("why, then"); }, 0);
  EXPECT_EQ(report.kind, Kind::failed);
  EXPECT_EQ(report.text, "threw: why, then");
  EXPECT_EQ(in_process_of_its_own([]() -> std::string { throw 1; }, 0).kind, Kind::failed);
}

TEST(ProcessOfItsOwn, a_bad_alloc_is_out_of_memory) {
  const ProcessReport report =
      in_process_of_its_own([]() -> std::string { throw std::bad_alloc(); }, 0);
  EXPECT_EQ(report.kind, Kind::out_of_memory);
  EXPECT_EQ(report.text, "out of memory");
}

std::string bytes(std::size_t count) {
  const std::vector<char> all(count, 'x');
  return std::to_string(all[count / 2]);
}

std::string bits(unsigned count) {
  return std::to_string(mpz_sizeinbase(mpz_class(mpz_class(1) << count).get_mpz_t(), 2));
}

TEST(ProcessOfItsOwn, work_that_needs_more_than_the_limit_is_out_of_memory) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer needs terabytes, so there is no limit";
#endif
  EXPECT_EQ(in_process_of_its_own([] { return bytes(2'000'000'000); }, 1000).kind,
            Kind::out_of_memory);
  EXPECT_EQ(in_process_of_its_own([] { return bits(4'000'000'000); }, 400).kind,
            Kind::out_of_memory);
  EXPECT_EQ(in_process_of_its_own([] { return bytes(2'000'000); }, 1000).kind, Kind::done);
}

TEST(ProcessOfItsOwn, peak_memory_is_that_of_the_work) {
  const double little = in_process_of_its_own([] { return bytes(1); }, 0).peak_mb;
  const double much = in_process_of_its_own([] { return bytes(200'000'000); }, 0).peak_mb;
  EXPECT_GT(little, 0);
  EXPECT_GE(much, 200);
  EXPECT_GE(much - little, 190);
  // And not that of the process before it.
  EXPECT_LT(in_process_of_its_own([] { return bytes(1); }, 0).peak_mb, 200);
}

}  // namespace
}  // namespace oplus
