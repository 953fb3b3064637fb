// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/mutants/mutants.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "properties/runner/mutants_command.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {
namespace {

TEST(Mutants, SayWhatGoesWrong) {
  EXPECT_GE(mutants().size(), 5U);
  for (const Mutant& m : mutants()) {
    EXPECT_FALSE(m.what.empty()) << m.name;
    EXPECT_FALSE(m.file.empty()) << m.name;
  }
}

TEST(Mutants, FailWhereNoneIsRun) {
  std::ostringstream out;
  EXPECT_FALSE(run_mutants({}, {}, 5, 1, out));
  EXPECT_FALSE(run_mutants({}, {{"unnamed", "is named by no statement", ""}}, 5, 1, out));
}

/// A statement whose enumeration fails as told, with the fault and without.
Statement enumerated_with(const std::string& failure_with, const std::string& failure_without) {
  Statement s;
  s.id = "fact-of-a-test";
  s.kills = {"some-fault"};
  s.enumerate = [=] {
    return Enumeration{7, active_mutant.empty() ? failure_without : failure_with};
  };
  return s;
}

TEST(Mutants, AreKilledByAnEnumerationThatHoldsWithoutThem) {
  const std::vector<Mutant> fault = {{"some-fault", "something is wrong", ""}};
  std::ostringstream killed, survived, broken;
  EXPECT_TRUE(run_mutants({enumerated_with("case 3", "")}, fault, std::nullopt, 1, killed));
  EXPECT_NE(killed.str().find("killed by the enumeration: case 3"), std::string::npos);
  EXPECT_FALSE(run_mutants({enumerated_with("", "")}, fault, std::nullopt, 1, survived));
  EXPECT_NE(survived.str().find("SURVIVED"), std::string::npos);
  EXPECT_FALSE(run_mutants({enumerated_with("case 3", "case 4")}, fault, std::nullopt, 1, broken));
  EXPECT_NE(broken.str().find("fails without the fault too: case 3"), std::string::npos);
}

}  // namespace
}  // namespace oplus
