// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/run_report.hpp"

#include <nlohmann/json.hpp>

#include "reference/io/written.hpp"

namespace oplus {

namespace {

const char* word(Outcome::Kind kind) {
  switch (kind) {
    case Outcome::Kind::holds:
      return "holds";
    case Outcome::Kind::fails:
      return "fails";
    case Outcome::Kind::discarded:
      return "does not apply";
  }
  return "";
}

}  // namespace

nlohmann::ordered_json run_report(const Statement& statement, const PropertyRun& run,
                                  const std::optional<Finding>& files) {
  nlohmann::ordered_json report = {
      {"statement", statement.id}, {"title", statement.title}, {"passed", run.passed()}};
  if (run.enumeration) report["enumerated"] = run.enumeration->cases;
  report["run"] = run.run;
  report["discarded"] = run.discarded;
  report["families"] = run.families;
  report["classes"] = run.classes;
  report["counts"] = run.counts;
  report["shares_judged"] = run.shares_judged;
  report["complaints"] = run.complaints;
  if (run.counterexample) {
    report["counterexample"] = {{"why", run.counterexample->why},
                                {"p", wkt(run.counterexample->summands.p)},
                                {"q", wkt(run.counterexample->summands.q)},
                                {"shrinks", run.counterexample->shrinks}};
    if (files) {
      report["counterexample"]["p_file"] = files->p.string();
      report["counterexample"]["q_file"] = files->q.string();
      report["counterexample"]["replay"] = replay_line(statement.id, *files);
    }
  }
  return report;
}

nlohmann::ordered_json run_report(const Statement& statement, const Outcome& outcome) {
  nlohmann::ordered_json report = {
      {"statement", statement.id}, {"title", statement.title}, {"outcome", word(outcome.kind)}};
  if (!outcome.why.empty()) report["why"] = outcome.why;
  report["counts"] = outcome.counts;
  return report;
}

}  // namespace oplus
