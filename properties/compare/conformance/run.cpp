// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/conformance/run.hpp"

#include <algorithm>
#include <mutex>

#include "checked/slide/for_each_number.hpp"

namespace oplus {

namespace {

class Run {
 public:
  Run(const Engine& implementation, const ConformanceSettings& settings,
      const ConformancePlan& plan)
      : implementation_(implementation), plan_(plan) {
    report_.engine = implementation.name;
    report_.settings = settings;
    report_.groups = plan.groups;
    report_.tallies.resize(plan.groups.size());
  }

  /// May be called by several threads.
  void try_trial(std::size_t i, const std::function<void()>& done) {
    TrialResults results = try_out(plan_.trials[i], implementation_, report_.settings.largest);
    const std::lock_guard lock(reporting_);
    ++report_.tallies[plan_.trials[i].group].pairs;
    add(i, std::move(results.closed));
    add(i, std::move(results.open));
    done();
  }

  ConformanceReport finish() {
    for (auto& [kind, counterexample] : report_.counterexamples) shrink(counterexample);
    return std::move(report_);
  }

 private:
  void add(std::size_t index, TrialResult result) {
    const Trial& trial = plan_.trials[index];
    ConformanceTally& tally = report_.tallies[trial.group];
    ++tally.rulings[result.ruling];
    if (!result.seen) return;
    const std::string kind = result.seen->failure.kind;
    ++tally.kinds[kind];
    const TrialGroup& group = plan_.groups[trial.group];
    ShrunkFailure found;
    found.found_size = size_of(result.seen->summands);
    found.seen = std::move(*result.seen);
    found.found_in = trial.name;
    found.group = group.part + ", " + group.name;
    found.index = index;
    const auto [known, is_new] = report_.counterexamples.try_emplace(kind, found);
    if (!is_new && is_better(known->second, found)) known->second = std::move(found);
  }

  /// Asks again, about another pair.
  TrialResult again(const ShrunkFailure& counterexample, const Summands& summands) const {
    const SeenFailure& seen = counterexample.seen;
    const std::size_t largest = report_.settings.largest;
    const Statement* const statement = plan_.trials[counterexample.index].statement;
    if (seen.failure.kind.starts_with("breaks "))
      return against_statement(summands, seen.boundary, implementation_, *statement, largest);
    const bool has_sum = seen.given.has_value();
    // An answer without a sum needs no oracle.
    if (!has_sum) {
      const Answer answer = ask(implementation_, summands.p, summands.q, seen.boundary);
      if (answer.sum) return {};
      return {Ruling::crashed, SeenFailure{failure_without_sum(answer), seen.boundary, summands}};
    }
    return against_oracle(summands, seen.boundary, implementation_, largest);
  }

  void shrink(ShrunkFailure& counterexample) const {
    // A pair that hangs costs all the time it is given.
    const std::size_t tries = report_.settings.shrink_tries;
    const std::size_t most = counterexample.seen.failure.kind == "hung" ? tries / 20 : tries;
    std::optional<SeenFailure> last;
    const auto fails = [&](const Summands& summands) {
      if (counterexample.tries > most) return false;
      ++counterexample.tries;
      TrialResult result = again(counterexample, summands);
      if (!result.seen || result.seen->failure.kind != counterexample.seen.failure.kind)
        return false;
      // A statement may blame one of its own pairs; only the asked one can be shrunk further.
      if (result.seen->summands != summands) return false;
      last = std::move(result.seen);
      return true;
    };
    counterexample.is_repeatable = fails(counterexample.seen.summands);
    if (!counterexample.is_repeatable) return;
    bool first = true;
    oplus::shrink(counterexample.seen.summands, [&](const Summands& summands) {
      return std::exchange(first, false) || fails(summands);
    });
    counterexample.seen = std::move(*last);
    counterexample.is_shrunk = counterexample.tries <= most;
  }

  const Engine& implementation_;
  const ConformancePlan& plan_;
  ConformanceReport report_;
  std::mutex reporting_;
};

}  // namespace

ConformanceReport run_conformance(const Engine& implementation, const ConformanceSettings& settings,
                                  const ConformancePlan& plan, unsigned threads,
                                  const std::function<void()>& done) {
  Run run(implementation, settings, plan);
  const std::vector<std::size_t> trials = settings.shard.cases_of(plan.trials.size());
  slide::for_each_number(trials.size(), threads,
                         [&](std::size_t k) { run.try_trial(trials[k], done); });
  return run.finish();
}

}  // namespace oplus
