// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <system_error>

#include "checked/cli/command_line/program_frame.hpp"
#include "checked/cli/usage_error.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/io/invalid_input.hpp"

namespace oplus {
namespace {

struct Ended {
  int exit_code;
  std::string err;
};

Ended ended(const std::function<int()>& work) {
  testing::internal::CaptureStderr();
  const int exit_code = exit_code_of(work);
  return {exit_code, testing::internal::GetCapturedStderr()};
}

TEST(ExitCodeOf, is_what_the_work_returns) {
  for (const int code : {0, 1, 5}) {
    const Ended o = ended([=] { return code; });
    EXPECT_EQ(o.exit_code, code);
    EXPECT_EQ(o.err, "");
  }
}

TEST(ExitCodeOf, of_bad_input_is_2) {
  EXPECT_EQ(ended([]() -> int { throw UsageError("not so"); }).err, "oplus: not so\n");
  EXPECT_EQ(ended([]() -> int { throw UsageError("not so"); }).exit_code, 2);
  EXPECT_EQ(ended([]() -> int { throw InvalidInput({"f", 1, 2}, "w", "e"); }).exit_code, 2);
  EXPECT_EQ(ended([]() -> int { throw std::bad_alloc(); }).exit_code, 2);
  EXPECT_EQ(ended([]() -> int {
              throw std::system_error(std::make_error_code(std::errc::io_error));
            }).exit_code,
            2);
}

TEST(ExitCodeOf, of_a_bug_is_3_and_asks_for_a_report_in_one_line) {
  const Ended contract = ended([]() -> int { throw ContractViolation("broken\nhere"); });
  EXPECT_EQ(contract.exit_code, 3);
  EXPECT_EQ(contract.err, "oplus: a bug in oplus: broken here; please report it with the input\n");
  EXPECT_EQ(ended([]() -> int { throw std::out_of_range("x"); }).exit_code, 3);
  EXPECT_EQ(ended([]() -> int { throw 7; }).exit_code, 3);
}

}  // namespace
}  // namespace oplus
