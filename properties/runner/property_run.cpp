// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that includes RapidCheck, and the only way to it: rc::check returns a bool that is
// easily ignored, passes with no case run, and lets the environment skip all of them. Its public interface
// can neither set the seed and the number of cases (RapidCheck's issues 260 and 284) nor return the reason
// of a failure; hence checkProperty of rc::detail, its parameters and its result, and no more of rc::detail.
#include "properties/runner/property_run.hpp"

#include <rapidcheck.h>
#include <rapidcheck/detail/TestListenerAdapter.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "properties/runner/classification.hpp"
#include "properties/runner/shrinking.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/io/counted.hpp"

namespace oplus {

namespace {

/// What RapidCheck generates and shrinks.
struct Case {
  Summands summands;
  std::string family;
};

void showValue(const Case& c, std::ostream& out) { out << "a pair of family " << c.family; }

/// Switches a mutant on during its lifetime.
class SwitchedOn {
 public:
#ifdef OPLUS_MUTANTS
  explicit SwitchedOn(const std::string& mutant) { active_mutant = mutant; }
  ~SwitchedOn() { active_mutant.clear(); }
#else
  explicit SwitchedOn(const std::string&) {}
  ~SwitchedOn() = default;
#endif
  SwitchedOn(const SwitchedOn&) = delete;
  SwitchedOn& operator=(const SwitchedOn&) = delete;
};

const Source& draw_source(const Statement& statement, Random& random) {
  const int total =
      std::accumulate(statement.sources.begin(), statement.sources.end(), 0,
                      [](int sum, const Source& source) { return sum + source.weight; });
  int ticket = uniform(random, 0, total - 1);
  for (const Source& source : statement.sources) {
    if (ticket < source.weight) return source;
    ticket -= source.weight;
  }
  throw std::logic_error("weights do not add up");
}

/// size: from 0 to rc::kNominalSize, the latter for the largest pairs.
Case draw_case(const Statement& statement, std::uint64_t bits, int size) {
  Random random(bits);
  const Source& source = draw_source(statement, random);
  const Family* family = find_family(source.family);
  if (family == nullptr) throw std::logic_error("no family " + source.family);
  if (source.largest < family->smallest)
    throw std::logic_error("family " + source.family + " has no pair as small as " +
                           std::to_string(source.largest));
  const std::size_t range = source.largest - family->smallest;
  const std::size_t n =
      family->smallest + range * static_cast<std::size_t>(size) / rc::kNominalSize;
  return {generate(*family, n, random()), source.family};
}

/// Uses only the raw bits of RapidCheck's generator.
rc::Gen<Case> cases_of(const Statement& statement) {
  return [&statement](const rc::Random& random, int size) {
    Case drawn = draw_case(statement, rc::Random(random).next(), size);
    return rc::shrinkable::shrinkRecur(std::move(drawn), [](const Case& c) {
      std::vector<Case> shrinks;
      for (Summands& s : smaller(c.summands)) shrinks.push_back({std::move(s), c.family});
      return rc::seq::fromContainer(std::move(shrinks));
    });
  };
}

/// Checks cases and counts those that RapidCheck draws. After the first that fails it only tries shrinks,
/// and goes on from the first of them that fails.
class Recorder {
 public:
  Recorder(const Statement& statement, const RunOptions& options, PropertyRun& run)
      : statement_(statement), options_(options), run_(run) {}

  Outcome::Kind check(const Case& c) {
    // RapidCheck asks again about the one that it reports.
    if (failing_ && failing_->summands == c.summands) return Outcome::Kind::fails;
    Outcome outcome;
    {
      const SwitchedOn fault(options_.mutant);
      outcome = evaluate(statement_, c.summands);
    }
    if (!failing_) count(c, outcome);
    if (outcome.kind != Outcome::Kind::fails) return outcome.kind;
    if (failing_ && fails_without_fault(c)) return Outcome::Kind::holds;
    failing_ = Counterexample{
        c.summands, outcome.why, failing_ ? failing_->shrinks + 1 : 0, {}, outcome.at};
    return outcome.kind;
  }

  /// The last pair that failed.
  const std::optional<Counterexample>& failing() const { return failing_; }

  /// The first one of middle size among the cases that held, by their numbers of vertices.
  std::optional<Summands> typical() const {
    if (held_.empty()) return std::nullopt;
    std::vector<std::pair<std::size_t, std::size_t>> sizes;
    for (std::size_t i = 0; i < held_.size(); ++i)
      sizes.emplace_back(vertex_count(held_[i].p) + vertex_count(held_[i].q), i);
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return held_[middle->second];
  }

 private:
  void count(const Case& c, const Outcome& outcome) {
    if (outcome.kind == Outcome::Kind::discarded) {
      ++run_.discarded;
      return;
    }
    ++run_.run;
    if (outcome.kind == Outcome::Kind::holds) held_.push_back(c.summands);
    ++run_.families[c.family];
    for (const auto& [name, is_so] : named(classify(c.summands)))
      if (is_so) ++run_.classes[name];
    for (const auto& [name, number] : outcome.counts) run_.counts[name] += number;
  }

  /// While a mutant's counterexample is shrunk: whether this one fails without the mutant, too.
  bool fails_without_fault(const Case& c) const {
    return !options_.mutant.empty() &&
           evaluate(statement_, c.summands).kind != Outcome::Kind::holds;
  }

  const Statement& statement_;
  const RunOptions& options_;
  PropertyRun& run_;
  std::optional<Counterexample> failing_;
  std::vector<Summands> held_;
};

void judge_result(const rc::detail::TestResult& result, PropertyRun& run) {
  if (result.is<rc::detail::FailureResult>()) {
    run.complaints.push_back(run.counterexample
                                 ? run.counterexample->why
                                 : result.get<rc::detail::FailureResult>().description);
  } else if (result.is<rc::detail::GaveUpResult>()) {
    run.complaints.push_back("gave up after discarding " + counted(run.discarded, "case", "cases"));
  } else if (result.is<rc::detail::Error>()) {
    run.complaints.push_back("RapidCheck: " + result.get<rc::detail::Error>().description);
  }
}

void judge_number(const RunOptions& options, PropertyRun& run) {
  if (run.run == 0) {
    run.complaints.push_back("no case was run");
  } else if (!run.counterexample && run.run < options.cases) {
    run.complaints.push_back("only " + std::to_string(run.run) + " of " +
                             counted(options.cases, "case", "cases") + " were run");
  }
}

void judge_shares(const Statement& statement, PropertyRun& run) {
  run.shares_judged = run.run >= cases_to_judge_shares && !run.counterexample;
  if (!run.shares_judged) return;
  for (const Promise& promise : statement.promises) {
    const std::size_t seen =
        (is_of_a_count(promise) ? run.counts : run.classes)[promise.classification];
    if (100 * seen < static_cast<std::size_t>(promise.percent) * run.run)
      run.complaints.push_back("promised " + std::to_string(promise.percent) + " % " +
                               (is_of_a_count(promise) ? "" : "cases with ") +
                               promise.classification + ", saw " + std::to_string(seen) + " of " +
                               std::to_string(run.run));
  }
}

void try_on_pairs(const Statement& statement, const RunOptions& options, PropertyRun& run) {
  Recorder recorder(statement, options, run);
  const rc::Gen<Case> cases = cases_of(statement);
  const auto property = rc::detail::toProperty([&] {
    const Outcome::Kind kind = recorder.check(*cases);
    if (kind == Outcome::Kind::discarded) RC_DISCARD();
    return kind == Outcome::Kind::holds;
  });
  rc::detail::TestParams params;
  params.seed = seed_of(statement.id, options.seed);
  params.maxSuccess = static_cast<int>(options.cases);
  params.maxSize = rc::kNominalSize;
  params.disableShrinking = !options.shrink;
  rc::detail::TestListenerAdapter says_nothing;
  // An empty map of failures to reproduce: a stale one would replace the run.
  const auto result = rc::detail::checkProperty(property, {statement.id, statement.text.title},
                                                params, says_nothing, {});
  run.counterexample = recorder.failing();
  run.typical = recorder.typical();
  judge_result(result, run);
  judge_number(options, run);
  judge_shares(statement, run);
}

}  // namespace

PropertyRun run_property(const Statement& statement, const RunOptions& options) {
  if (options.cases > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw std::invalid_argument("more cases than RapidCheck can count");
#ifndef OPLUS_MUTANTS
  if (!options.mutant.empty()) throw std::invalid_argument("a build without mutants");
#endif
  PropertyRun run{.statement = statement.id, .title = statement.text.title};
  if (statement.enumerate) {
    const SwitchedOn fault(options.mutant);
    run.enumeration = enumerated(statement);
    if (!run.enumeration->failure.empty())
      run.complaints.push_back("enumeration: " + run.enumeration->failure);
  }
  // Without either a run must not pass; then no pair can be tried, which is a complaint.
  if (run.passed() && (statement.check || !statement.enumerate))
    try_on_pairs(statement, options, run);
  return run;
}

}  // namespace oplus
