// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/mutants/mutants.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "properties/runner/mutants_command.hpp"

namespace oplus {
namespace {

TEST(Mutants, SayWhatGoesWrong) {
  EXPECT_GE(mutants().size(), 5U);
  for (const Mutant& m : mutants()) {
    EXPECT_FALSE(m.what.empty()) << m.name;
    EXPECT_FALSE(m.file.empty()) << m.name;
  }
}

/// A build without the faults cannot run this on real ones; whether the list is complete it can.
TEST(Mutants, NoneRunIsNoSuccess) {
  std::ostringstream out;
  EXPECT_FALSE(run_mutants({}, {}, 5, 1, out));
  EXPECT_FALSE(run_mutants({}, {{"unnamed", "is named by no statement", ""}}, 5, 1, out));
  EXPECT_NE(out.str().find("unnamed: no statement names this mutant"), std::string::npos);
}

}  // namespace
}  // namespace oplus
