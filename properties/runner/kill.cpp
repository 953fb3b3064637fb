// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/kill.hpp"

#include <utility>

namespace oplus {

Kill try_to_kill(const Statement& statement, const Mutant& mutant, RunOptions options) {
  options.mutant = mutant.name;
  const PropertyRun run = run_property(statement, options);
  Kill kill{.mutant = mutant.name, .statement = statement.id, .cases = run.run};
  if (run.enumeration && !run.enumeration->failure.empty()) {
    kill.by_enumeration = true;
    kill.why = run.enumeration->failure;
    kill.killed = enumerated(statement).failure.empty();
  } else if (run.counterexample) {
    kill.why = run.counterexample->why;
    kill.shrunk = run.counterexample->summands;
    kill.killed = evaluate(statement, *kill.shrunk).kind == Outcome::Kind::holds;
  }
  return kill;
}

std::string in_words(const Kill& kill) {
  const std::string where =
      kill.by_enumeration ? "the enumeration" : "case " + std::to_string(kill.cases);
  if (kill.killed) return "killed by " + where + ": " + kill.why;
  if (kill.by_enumeration || kill.shrunk)
    return "NOT KILLED: " + where + " fails without the fault too: " + kill.why;
  return "ALIVE after " + std::to_string(kill.cases) + " cases";
}

}  // namespace oplus
