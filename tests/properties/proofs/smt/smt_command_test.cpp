// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "properties/proofs/smt/query.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class SmtCommand : public Shell {
 protected:
  /// Both solvers run this script.
  Ran with_solvers(const std::string& script, const std::string& command, int exit_code) const {
    put("solver", "#!/bin/sh\n" + script + "\n");
    return run(
        "chmod +x solver && cp solver z3 && cp solver cvc5 && export PATH=$PWD:$PATH\n" + command,
        exit_code);
  }
};

TEST_F(SmtCommand, lists_queries) {
  const Ran ran = run("oplus-check smt --list --json", 0);
  EXPECT_EQ(nlohmann::json::parse(ran.out).at("queries").size(), smt::queries().size());
}

TEST_F(SmtCommand, proves_a_statement) {
  const Ran ran = run("oplus-check smt lemma-2.2.5 --json", 0);
  const nlohmann::json queries = nlohmann::json::parse(ran.out).at("queries");
  ASSERT_EQ(queries.size(), 2U);
  for (const nlohmann::json& query : queries) {
    EXPECT_EQ(query.at("answers").at("proof"),
              nlohmann::json({{"z3", "unsat"}, {"cvc5", "unsat"}}));
    EXPECT_TRUE(query.contains("counterexamples"));
  }
}

TEST_F(SmtCommand, any_other_answer_is_a_failure) {
  for (const std::string script :
       {"echo unknown", "echo sat", "echo unsat", "echo timeout", "exit 1", "kill -9 $$", "true"}) {
    const Ran ran = with_solvers(script, "oplus-check smt lemma-2.2.5.half-disks", 1);
    EXPECT_TRUE(has(ran.out, "1 query, 1 failed"));
  }
}

#ifndef OPLUS_MUTANTS
TEST_F(SmtCommand, has_no_mutants_in_this_build) {
  run("oplus-check smt --mutant slide-shifts-to-the-left", 2);
}
#endif

}  // namespace
}  // namespace oplus
