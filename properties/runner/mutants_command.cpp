// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/mutants_command.hpp"

#include <algorithm>
#include <iostream>

#include "checked/cli/command_line/terminal.hpp"
#include "properties/commands.hpp"
#include "properties/runner/recorded_pictures.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

struct Settings {
  std::optional<std::size_t> cases;
  std::uint64_t seed = 1;
  std::string record;
  bool json = false;
};

/// Runs the statement with the fault switched on. It kills the mutant if its enumeration fails with
/// the fault and holds without, or if it fails on a pair with the fault and holds on the same pair
/// without. A run that has too few cases or misses a promised share does not kill it.
Kill try_to_kill(const Statement& statement, const RunOptions& options) {
  const PropertyRun run = run_property(statement, options);
  Kill kill{.mutant = options.mutant, .statement = statement.id, .cases = run.run};
  if (run.enumeration && !run.enumeration->failure.empty()) {
    kill.by_enumeration = true;
    kill.why = run.enumeration->failure;
    kill.killed = enumerated(statement).failure.empty();
  } else if (run.counterexample) {
    kill.why = run.counterexample->why;
    kill.shrunk = run.counterexample->summands;
    kill.at = run.counterexample->at;
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
  return "SURVIVED " + counted(kill.cases, "case", "cases");
}

}  // namespace

bool run_mutants(const std::vector<Statement>& statements, const std::vector<Mutant>& mutants,
                 std::optional<std::size_t> cases, std::uint64_t seed, std::ostream& out,
                 std::vector<Kill>* kills) {
  std::size_t killed = 0, survived = 0;
  for (const Mutant& mutant : mutants) {
    if (!speech().quiet) out << mutant.name << ": " << mutant.what << '\n';
    for (const Statement& statement : statements) {
      if (std::ranges::find(statement.kills, mutant.name) == statement.kills.end()) continue;
      const Kill kill = try_to_kill(
          statement,
          {.cases = cases.value_or(statement.cases), .seed = seed, .mutant = mutant.name});
      if (!speech().quiet || !kill.killed) {
        if (speech().quiet) out << mutant.name << ": " << mutant.what << '\n';
        out << "  " << statement.id << ": "
            << painted(kill.killed ? Paint::good : Paint::bad, in_words(kill), out) << '\n'
            << std::flush;
      }
      ++(kill.killed ? killed : survived);
      if (kills != nullptr) kills->push_back(kill);
    }
  }
  out << killed << " killed, " << survived << " not killed\n";
  return survived == 0 && killed > 0;
}

namespace {

int run_all(const Settings& settings) {
#ifdef OPLUS_MUTANTS
  std::vector<Kill> kills;
  const bool all_killed = run_mutants(statements(), mutants(), settings.cases, settings.seed,
                                      text_output(settings.json), &kills);
  const std::string json = to_json(kills);
  if (settings.json) std::cout << json;
  if (!settings.record.empty()) {
    write_file(settings.record, json);
    draw_beside(settings.record, kills);
  }
  return all_killed ? 0 : 1;
#else
  static_cast<void>(settings);
  say_error(
      "this build contains no mutants; use the preset check: "
      "build/check/bin/oplus-maintain mutants");
  return 2;
#endif
}

}  // namespace

void add_mutants_command(Program& program) {
  const auto& [command, settings] = program.add(
      "mutants", "Switch on faults one by one and check that the statements fail", run_all);
  command
      .option("--cases", settings.cases,
              "Cases that a mutant must survive to fail; default: the statement's number")
      .range(std::size_t{1}, std::size_t{1000000000});
  command.option("--seed", settings.seed, "Same seed, same pairs").default_shown();
  command.option("--record FILE", settings.record,
                 "Write what --json prints to this file, and pictures/ beside it");
  command.flag("--json", settings.json, "Answer in JSON (docs/json.md)");
  command.footer(
      "Needs a build that contains the faults: the preset check.\n"
      "\n"
      "Example:\n"
      "  build/check/bin/oplus-maintain mutants\n"
      "\n"
      "Exit codes:\n"
      "  0  every statement killed its mutants\n"
      "  1  a mutant survives\n"
      "  2  this build contains no mutants; or invalid usage");
}

}  // namespace oplus
