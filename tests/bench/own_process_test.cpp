// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/own_process.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <new>
#include <stdexcept>
#include <vector>

#include "properties/compare/peers/method.hpp"
#include "reference/definitions/rational.hpp"

namespace oplus {
namespace {

using Ending = Measurement::Ending;

/// Measures work that returns its note.
Measurement measured(const std::function<std::string()>& work, const ProcessLimits& limits = {}) {
  return measured_in_own_process([&](const auto&) { return Measurement{.note = work()}; }, limits);
}

TEST(OwnProcess, returns_the_result_of_the_work_of_any_length) {
  const std::string text(1'000'000, 'x');
  const Measurement m = measured([&] { return text; });
  EXPECT_EQ(m.outcome, Ending::done);
  EXPECT_EQ(m.note, text);
}

TEST(OwnProcess, is_another_process_and_changes_nothing_in_this_one) {
  int changed = 0;
  const Measurement m = measured([&] {
    changed = 1;
    return std::to_string(::getpid());
  });
  EXPECT_NE(m.note, std::to_string(::getpid()));
  EXPECT_EQ(changed, 0);
}

TEST(OwnProcess, work_that_is_killed_or_throws_is_reported) {
  const auto dies = []() -> std::string {
    ::kill(::getpid(), SIGKILL);
    return "alive";
  };
  EXPECT_EQ(in_words(measured(dies)), "crashed: signal 9");
  EXPECT_EQ(in_words(measured([]() -> std::string { throw std::logic_error("why, then"); })),
            "failed: why, then");
  EXPECT_EQ(measured([]() -> std::string { throw 1; }).outcome, Ending::failed);
  EXPECT_EQ(measured([]() -> std::string { ::_exit(1); }).outcome, Ending::failed);
  EXPECT_EQ(measured([]() -> std::string { throw Unsupported("no holes"); }).outcome,
            Ending::unsupported);
}

TEST(OwnProcess, each_beat_restarts_the_time_limit) {
  const ProcessLimits limits{.seconds = 0.2};
  const auto naps = [](int count) {
    return [count](const std::function<void()>& beat) {
      for (int i = 0; i < count; ++i) {
        ::usleep(80'000);
        beat();
      }
      ::usleep(count == 0 ? 10'000'000 : 0);
      return Measurement{};
    };
  };
  EXPECT_EQ(measured_in_own_process(naps(5), limits).outcome, Ending::done);
  EXPECT_EQ(in_words(measured_in_own_process(naps(0), limits)), "> 0.2 s");
}

std::string bytes(std::size_t count) {
  const std::vector<char> all(count, 'x');
  return std::to_string(all[count / 2]);
}

std::string bits(unsigned count) {
  return std::to_string(mpz_sizeinbase(mpz_class(mpz_class(1) << count).get_mpz_t(), 2));
}

TEST(OwnProcess, work_that_needs_more_than_the_limit_is_out_of_memory) {
  EXPECT_EQ(measured([] { return bytes(2'000'000'000); }, {.address_space_mb = 1000}).outcome,
            Ending::out_of_memory);
  EXPECT_EQ(measured([] { return bits(4'000'000'000); }, {.address_space_mb = 400}).outcome,
            Ending::out_of_memory);
  EXPECT_EQ(measured([] { return bytes(2'000'000); }, {.address_space_mb = 1000}).outcome,
            Ending::done);
  EXPECT_EQ(in_words(measured([]() -> std::string { throw std::bad_alloc(); })), "out of memory");
}

TEST(OwnProcess, peak_memory_is_that_of_the_work) {
  const auto peak = [](std::size_t count) {
    return measured([=] { return bytes(count); }).numbers.at("peak_mb");
  };
  const double little = peak(1);
  const double much = peak(200'000'000);
  EXPECT_GT(little, 0);
  EXPECT_GE(much, 200);
  EXPECT_GE(much - little, 190);
  // And not that of the process before it.
  EXPECT_LT(peak(1), 200);
}

}  // namespace
}  // namespace oplus
