// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/judge.hpp"

#include <algorithm>
#include <cctype>
#include <exception>
#include <stdexcept>
#include <system_error>
#include <variant>

#include "checked/verify/sum_by_convex_parts.hpp"
#include "properties/runner/checked_engines.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/quoting.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

/// Digits are coordinates or addresses, which change from pair to pair.
EngineFailure of_exception(const std::string& what) {
  std::string site = one_line(what);
  std::erase_if(site, [](unsigned char c) { return std::isdigit(c) != 0; });
  return {EngineFailure::Kind::crashed, "exception: " + site.substr(0, 120),
          "it threw: " + one_line(what)};
}

/// A sum, or the reason why not.
using EngineAnswer = std::variant<PlanarSet, EngineFailure>;

EngineAnswer ask(const Engine& engine, const Summands& pair, Boundary boundary, Probes& probes) {
  try {
    ComputedSum computed = engine.compute(pair.p, pair.q, boundary, {});
    if (computed.statistics.contains("hole tests")) {
      probes.faces += computed.statistics.count("hole tests");
      probes.points += computed.statistics.count("tests of low-dimensional features");
    }
    return std::move(computed.sum);
  } catch (const EngineFailure& e) {
    return e;
  } catch (const std::system_error&) {
    throw;  // no process could be started, or it was interrupted: no fault of the engine
  } catch (const std::exception& e) {
    return of_exception(e.what());
  } catch (...) {
    return of_exception("not a std::exception");
  }
}

/// Sets the ruling on a sum; without a right one it is skipped.
void rule(JudgedSum& sum, const EngineAnswer& answer, const PlanarSet* right,
          const Summands& pair) {
  if (const EngineFailure* const none = std::get_if<EngineFailure>(&answer)) {
    sum.ruling = name(none->kind());
    if (!is_fault(none->kind()))
      sum.why = one_line(none->what());
    else
      sum.wrong = WrongSum{sum.engine, sum.boundary, failure_without_sum(*none), pair};
    return;
  }
  const PlanarSet& given = std::get<PlanarSet>(answer);
  if (right == nullptr) {
    sum.ruling = "skipped";
  } else if (std::optional<Failure> found = failure(*right, given)) {
    sum.ruling = "wrong";
    sum.wrong = WrongSum{sum.engine, sum.boundary, std::move(*found), pair, *right, given};
  }
}

std::string too_large(const Summands& pair, const Rules& rules) {
  const std::size_t size = convolution(pair.p, pair.q).size();
  if (size <= rules.largest) return "";
  return "its convolution has " + counted(size, "segment", "segments") + ", " +
         rules.judge.in_words + " takes at most " + std::to_string(rules.largest);
}

/// A sum that a statement asked for.
struct Question {
  Summands pair;
  Boundary boundary;
  EngineAnswer answer;
};

JudgedSum by_statement(const Task& task, const Engine& engine, Boundary boundary,
                       const Rules& rules, Probes& probes) {
  JudgedSum sum{engine.name, boundary};
  std::vector<Question> asked;
  // Answers that no statement could work with are thrown.
  const Engine recording =
      named_engine(engine.name, [&](const Region& p, const Region& q, Boundary of) {
        asked.push_back({{p, q}, of, ask(engine, {p, q}, of, probes)});
        const EngineAnswer& answer = asked.back().answer;
        if (const EngineFailure* const none = std::get_if<EngineFailure>(&answer))
          throw EngineFailure(*none);
        const auto& given = std::get<PlanarSet>(answer);
        if (const std::optional<Failure> found = malformed(given))
          throw std::runtime_error(found->what);
        return given;
      });
  Outcome outcome;
  try {
    outcome = task.statement->of_engine(recording, boundary, task.pair);
  } catch (const std::system_error&) {
    throw;
  } catch (const std::exception& e) {
    outcome = {Outcome::Kind::fails, one_line(e.what()), {}};
  }
  if (outcome.kind == Outcome::Kind::holds) return sum;
  if (outcome.kind == Outcome::Kind::discarded) {
    sum.ruling = "skipped";
    sum.why = task.statement->id + " does not apply";
    return sum;
  }
  for (const Question& question : asked) {
    JudgedSum blamed{engine.name, question.boundary};
    std::optional<PlanarSet> right;
    if (std::holds_alternative<PlanarSet>(question.answer) &&
        too_large(question.pair, rules).empty())
      right = rules.judge.sums(question.pair.p, question.pair.q).of(question.boundary);
    rule(blamed, question.answer, right ? &*right : nullptr, question.pair);
    if (blamed.ruling == "passed" || blamed.ruling == "skipped") continue;
    blamed.boundary = boundary;
    return blamed;
  }
  sum.ruling = "wrong";
  sum.wrong =
      WrongSum{engine.name, boundary, {"breaks " + task.statement->id, outcome.why}, task.pair};
  return sum;
}

}  // namespace

const std::vector<Judge>& judges() {
  static const std::vector<Judge> all = {{"oracle", "the oracle", 1300,
                                          [](const Region& p, const Region& q) -> RightSums {
                                            OracleSums sums = oracle_sums(p, q);
                                            return {std::move(sums.closed), std::move(sums.open)};
                                          }},
                                         {"convex-parts", "the sum of convex parts", 5000,
                                          [](const Region& p, const Region& q) -> RightSums {
                                            return {sum_by_convex_parts(p, q, Boundary::closed),
                                                    sum_by_convex_parts(p, q, Boundary::open)};
                                          }}};
  return all;
}

const Judge& judge_named(const std::string& name) {
  for (const Judge& judge : judges())
    if (judge.name == name) return judge;
  throw std::invalid_argument("unknown judge " + one_line(name));
}

const std::vector<std::string>& rulings() {
  static const std::vector<std::string> all = {
      "passed",           "wrong",   "crashed", "hung", "out of memory", "unreadable",
      "open unsupported", "refused", "skipped"};
  return all;
}

JudgedPair judged(const Task& task, const Rules& rules) {
  JudgedPair result{{}, classify(task.pair), {}, {}};
  const auto each = [&](const auto& judge) {
    for (const Engine& engine : rules.engines)
      for (const Boundary boundary : rules.boundaries)
        result.sums.push_back(judge(engine, boundary));
  };
  if (task.statement != nullptr) {
    each([&](const Engine& engine, Boundary boundary) {
      return by_statement(task, engine, boundary, rules, result.probes);
    });
    return result;
  }
  const std::string why_skipped = task.known ? "" : too_large(task.pair, rules);
  if (!why_skipped.empty() && !rules.asks_beyond) {
    each([&](const Engine& engine, Boundary boundary) {
      return JudgedSum{engine.name, boundary, "skipped", why_skipped};
    });
    return result;
  }
  std::vector<EngineAnswer> answers;
  each([&](const Engine& engine, Boundary boundary) {
    answers.push_back(ask(engine, task.pair, boundary, result.probes));
    return JudgedSum{engine.name, boundary};
  });
  const auto is_to_judge = [](const EngineAnswer& answer) {
    const EngineFailure* const none = std::get_if<EngineFailure>(&answer);
    return none == nullptr || is_fault(none->kind());
  };
  // One arrangement for both sums, and only where there is something to compare.
  if (task.known) {
    result.right = RightSums{task.known->closed, task.known->open};
  } else if (why_skipped.empty() &&
             (answers.empty() || std::any_of(answers.begin(), answers.end(), is_to_judge))) {
    try {
      result.right = rules.judge.sums(task.pair.p, task.pair.q);
    } catch (const std::exception& e) {
      JudgedSum thrown{rules.judge.name, Boundary::closed};
      rule(thrown, of_exception(e.what()), nullptr, task.pair);
      result.sums.push_back(std::move(thrown));
    }
  }
  for (std::size_t i = 0; i < result.sums.size(); ++i) {
    JudgedSum& sum = result.sums[i];
    if (sum.wrong) continue;
    const PlanarSet* const right = result.right ? &result.right->of(sum.boundary) : nullptr;
    rule(sum, answers[i], right, task.pair);
    if (sum.ruling == "skipped")
      sum.why = why_skipped.empty() ? rules.judge.in_words + " threw" : why_skipped;
  }
  return result;
}

}  // namespace oplus
