// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/properties_command.hpp"

#include <algorithm>
#include <iostream>

#include "checked/cli/command_line/progress.hpp"
#include "checked/cli/command_line/terminal.hpp"
#include "properties/commands.hpp"
#include "properties/runner/finding.hpp"
#include "properties/runner/known_name.hpp"
#include "properties/runner/recorded_pictures.hpp"
#include "properties/runner/registry.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

struct Settings {
  std::vector<std::string> ids;
  std::optional<std::size_t> cases;
  std::uint64_t seed = 1;
  std::vector<std::string> pair;
  std::string findings = "oplus-findings";
  std::string record;
  bool json = false;
};

std::vector<Statement> chosen(const std::vector<std::string>& ids) {
  std::vector<Statement> result = statements();
  std::erase_if(result, [&](const Statement& s) {
    return !ids.empty() && std::ranges::find(ids, s.id) == ids.end();
  });
  return result;
}

Summands read_pair(const std::vector<std::string>& files) {
  const auto region = [](const std::string& file) {
    const ReadRegion read = read_region_file(file);
    for (const std::string& note : read.notes) say_note(note);
    return read.region;
  };
  return {region(files.at(0)), region(files.at(1))};
}

void print_tally(std::ostream& out, const std::string& label,
                 const std::map<std::string, std::size_t>& tally) {
  if (tally.empty()) return;
  out << "  " << label << ':';
  const char* separator = " ";
  for (const auto& [name, count] : tally) {
    out << separator << name << ' ' << count;
    separator = ", ";
  }
  out << '\n';
}

void print_run(std::ostream& out, const Statement& statement, const PropertyRun& run) {
  out << statement.id << ": " << statement.text.title << '\n';
  if (run.enumeration && run.enumeration->failure.empty())
    out << "  proved by enumeration, " << counted(run.enumeration->cases, "case", "cases") << '\n';
  if (statement.check)
    out << "  " << counted(run.run, "case", "cases") << " run, " << run.discarded << " discarded\n";
  print_tally(out, "families", run.families);
  print_tally(out, "cases with", run.classes);
  print_tally(out, "looked at", run.counts);
  if (!run.shares_judged && !statement.promises.empty() && !run.counterexample)
    out << "  fewer than " << cases_to_judge_shares << " cases: promised shares not judged\n";
}

void print_last_line(std::ostream& out, std::size_t passed, std::size_t failed) {
  const std::string line =
      std::to_string(passed) + " passed, " + std::to_string(failed) + " failed";
  out << painted(failed == 0 ? Paint::good : Paint::bad, line, out) << '\n';
}

}  // namespace

bool run_statements(const std::vector<Statement>& statements, std::optional<std::size_t> cases,
                    std::uint64_t seed, const std::filesystem::path& findings, std::ostream& out,
                    std::vector<PropertyRun>* runs) {
  std::size_t passed = 0;
  for (const Statement& statement : statements) {
    PropertyRun run = [&] {
      const ShownStep step(statement.id);
      return run_property(statement, {.cases = cases.value_or(statement.cases), .seed = seed});
    }();
    if (!speech().quiet || !run.passed()) print_run(out, statement, run);
    for (const std::string& complaint : run.complaints)
      out << "  " << painted(Paint::bad, "FAILED", out) << ": " << complaint << '\n';
    if (run.counterexample) {
      run.counterexample->files =
          write_finding(findings, statement.id, run.counterexample->summands);
      out << "  shrunk in " << run.counterexample->shrinks << " steps; replay with\n    "
          << replay_line(statement.id, *run.counterexample->files) << '\n';
    }
    if (run.passed()) ++passed;
    if (runs != nullptr) runs->push_back(std::move(run));
    out << std::flush;
  }
  print_last_line(out, passed, statements.size() - passed);
  return !statements.empty() && passed == statements.size();
}

bool replay_statements(const std::vector<Statement>& statements, const Summands& summands,
                       std::ostream& out, std::vector<Outcome>* outcomes) {
  std::size_t passed = 0;
  std::size_t failed = 0;
  for (const Statement& statement : statements) {
    const Outcome outcome = evaluate(statement, summands);
    if (outcomes != nullptr) outcomes->push_back(outcome);
    out << statement.id << ": ";
    switch (outcome.kind) {
      case Outcome::Kind::holds:
        out << "holds\n";
        ++passed;
        break;
      case Outcome::Kind::fails:
        out << painted(Paint::bad, "FAILED", out) << ": " << outcome.why << '\n';
        ++failed;
        break;
      case Outcome::Kind::discarded:
        out << "does not apply: " << outcome.why << '\n';
        break;
    }
    print_tally(out, "looked at", outcome.counts);
  }
  const std::size_t not_applicable = statements.size() - passed - failed;
  if (not_applicable > 0) out << not_applicable << " do not apply to this pair\n";
  print_last_line(out, passed, failed);
  return passed > 0 && failed == 0;
}

namespace {

int properties(const Settings& settings) {
  const std::vector<Statement> to_run = chosen(settings.ids);
  std::ostream& out = text_output(settings.json);
  bool passed = false;
  std::string json;
  if (settings.pair.empty()) {
    std::vector<PropertyRun> runs;
    passed = run_statements(to_run, settings.cases, settings.seed, settings.findings, out, &runs);
    json = to_json(runs);
    if (!settings.record.empty()) draw_beside(settings.record, runs);
  } else {
    std::vector<Outcome> outcomes;
    passed = replay_statements(to_run, read_pair(settings.pair), out, &outcomes);
    json = to_json(to_run, outcomes);
  }
  if (settings.json) std::cout << json;
  if (!settings.record.empty()) write_file(settings.record, json);
  return passed ? 0 : 1;
}

}  // namespace

void add_properties_command(Program& program) {
  const std::vector<std::string> ids = texts(statements(), &Statement::id);
  const auto& [command, settings] = program.add(
      "properties", "Try the statements, theorems and laws, on generated pairs", properties);
  command
      .option("--theorem ID", settings.ids,
              "Only this statement; may be repeated; 'oplus-check theorems' lists them")
      .one_of(ids, known_name("statement", ids, "'oplus-check theorems' lists all"));
  const Option cases =
      command.option("--cases", settings.cases, "Cases per statement; default: its own number")
          .range(std::size_t{1}, std::size_t{1000000000});
  const Option seed =
      command.option("--seed", settings.seed, "Same seed, same pairs").default_shown();
  command.option("--pair P Q", settings.pair, "Try this pair instead of generated ones")
      .values(2)
      .excludes(cases)
      .excludes(seed);
  command.option("--out DIR", settings.findings, "Folder for shrunk counterexamples")
      .default_shown();
  command.option("--record FILE", settings.record,
                 "Write what --json prints to this file, and pictures/ beside it");
  command.flag("--json", settings.json, "Answer in JSON (docs/json.md)");
  command.footer(
      "Example:\n"
      "  oplus-check properties --theorem lemma-4.1.4 --cases 5000 --seed 7\n"
      "\n"
      "Exit codes:\n"
      "  0  all passed\n"
      "  1  a statement failed\n"
      "  2  invalid input or usage, or a file that cannot be read or written");
}

}  // namespace oplus
