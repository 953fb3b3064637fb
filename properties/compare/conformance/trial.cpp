// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/conformance/trial.hpp"

#include <exception>
#include <system_error>

#include "properties/runner/checked_engines.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/io/quoting.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

Ruling ruling_of(NoSum::Kind kind) {
  switch (kind) {
    case NoSum::Kind::crashed:
      return Ruling::crashed;
    case NoSum::Kind::hung:
      return Ruling::hung;
    case NoSum::Kind::out_of_memory:
      return Ruling::out_of_memory;
    case NoSum::Kind::unreadable:
      return Ruling::unreadable;
    case NoSum::Kind::not_taken:
      break;
  }
  return Ruling::not_taken;
}

bool is_too_large(const Summands& summands, std::size_t largest) {
  return convolution(summands.p, summands.q).size() > largest;
}

TrialResult without_sum(const Answer& answer, Boundary boundary, const Summands& summands) {
  TrialResult result{ruling_of(answer.no_sum)};
  if (result.ruling != Ruling::not_taken)
    result.seen = SeenFailure{failure_without_sum(answer), boundary, summands};
  return result;
}

TrialResult judged(const Answer& answer, const MinkowskiSum& right, Boundary boundary,
                   const Summands& summands) {
  if (!answer.sum) return without_sum(answer, boundary, summands);
  std::optional<Failure> found = failure(right, answer);
  if (!found) return {};
  return {Ruling::wrong, SeenFailure{std::move(*found), boundary, summands, right, *answer.sum}};
}

/// A question that a statement asked.
struct Asked {
  Summands summands;
  Boundary boundary;
  Answer answer;
};

/// The implementation, what it is asked kept. Answers that no statement could work with are thrown.
Engine recording(const Engine& implementation, std::vector<Asked>& asked) {
  return named_engine(implementation.name,
                      [&](const Region& p, const Region& q, Boundary boundary) {
                        asked.push_back({{p, q}, boundary, ask(implementation, p, q, boundary)});
                        const Answer& answer = asked.back().answer;
                        if (!answer.sum) throw NoSum(answer.no_sum, answer.site, answer.what);
                        if (const std::optional<Failure> found = malformed(*answer.sum))
                          throw std::runtime_error(found->what);
                        return *answer.sum;
                      });
}

}  // namespace

TrialResult against_oracle(const Summands& summands, Boundary boundary,
                           const Engine& implementation, std::size_t largest) {
  const Answer answer = ask(implementation, summands.p, summands.q, boundary);
  if (!answer.sum) return without_sum(answer, boundary, summands);
  if (is_too_large(summands, largest)) return {Ruling::skipped};
  return judged(answer, oracle_sum(summands.p, summands.q, boundary), boundary, summands);
}

TrialResult against_statement(const Summands& summands, Boundary boundary,
                              const Engine& implementation, const Statement& statement,
                              std::size_t largest) {
  std::vector<Asked> asked;
  Outcome outcome;
  try {
    outcome = statement.of_implementation(recording(implementation, asked), boundary, summands);
  } catch (const std::system_error&) {
    throw;
  } catch (const std::exception& e) {
    outcome.kind = Outcome::Kind::fails;
    outcome.why = one_line(e.what());
  }
  if (outcome.kind == Outcome::Kind::discarded) return {Ruling::skipped};
  if (outcome.kind == Outcome::Kind::holds) return {};
  for (const Asked& question : asked) {
    if (!question.answer.sum)
      return without_sum(question.answer, question.boundary, question.summands);
    if (is_too_large(question.summands, largest)) continue;
    TrialResult result = judged(
        question.answer, oracle_sum(question.summands.p, question.summands.q, question.boundary),
        question.boundary, question.summands);
    if (result.ruling != Ruling::passed) return result;
  }
  SeenFailure broken{{"breaks " + statement.id, outcome.why, {}, {}}, boundary, summands};
  return {Ruling::wrong, std::move(broken)};
}

TrialResults try_out(const Trial& trial, const Engine& implementation, std::size_t largest) {
  const Summands summands = trial.make();
  if (trial.statement != nullptr) {
    const auto against = [&](Boundary boundary) {
      return against_statement(summands, boundary, implementation, *trial.statement, largest);
    };
    return {against(Boundary::closed), against(Boundary::open)};
  }
  const Answer closed = ask(implementation, summands.p, summands.q, Boundary::closed);
  const Answer open = ask(implementation, summands.p, summands.q, Boundary::open);
  // One arrangement for both, and none where there is nothing to compare.
  std::optional<OracleSums> right;
  if (trial.row)
    right = OracleSums{trial.row->closed, trial.row->open, {}};
  else if ((closed.sum || open.sum) && !is_too_large(summands, largest))
    right = oracle_sums(summands.p, summands.q);
  const auto result = [&](const Answer& answer, Boundary boundary) -> TrialResult {
    if (!answer.sum) return without_sum(answer, boundary, summands);
    if (!right) return {Ruling::skipped};
    return judged(answer, boundary == Boundary::closed ? right->closed : right->open, boundary,
                  summands);
  };
  return {result(closed, Boundary::closed), result(open, Boundary::open)};
}

}  // namespace oplus
