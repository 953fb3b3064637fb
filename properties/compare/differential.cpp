// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/differential.hpp"

#include <algorithm>
#include <exception>
#include <mutex>

#include "checked/slide/for_each_number.hpp"
#include "properties/runner/classification.hpp"
#include "properties/runner/shrinking.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

Disagreement without_sum(const std::string& implementation, Boundary boundary,
                         const MinkowskiSum& expected, const std::string& what,
                         std::optional<NoSum> no_sum = std::nullopt) {
  return {.implementation = implementation,
          .boundary = boundary,
          .by_oracle = expected,
          .by_implementation = std::nullopt,
          .no_sum = std::move(no_sum),
          .what = what,
          .witness = std::nullopt};
}

/// Throws NoSum for what is not taken.
std::optional<Disagreement> disagreement(const Summands& summands, const Engine& implementation,
                                         Boundary boundary, const MinkowskiSum& expected,
                                         Probes& probes) {
  try {
    auto [sum, origins, statistics] = implementation.compute(summands.p, summands.q, boundary, {});
    probes += statistics;
    const std::optional<Difference> found = difference(expected, sum);
    if (!found) return std::nullopt;
    return Disagreement{.implementation = implementation.name,
                        .boundary = boundary,
                        .by_oracle = expected,
                        .by_implementation = std::move(sum),
                        .no_sum = std::nullopt,
                        .what = found->what,
                        .witness = found->witness};
  } catch (const NoSum& e) {
    if (e.kind() == NoSum::Kind::not_taken) throw;
    return without_sum(implementation.name, boundary, expected, e.what(), e);
  } catch (const std::exception& e) {
    return without_sum(implementation.name, boundary, expected,
                       std::string("it threw: ") + e.what());
  }
}

bool same_failure(const Disagreement& a, const Disagreement& b) {
  if (a.implementation != b.implementation || a.boundary != b.boundary ||
      a.no_sum.has_value() != b.no_sum.has_value())
    return false;
  return !a.no_sum ||
         (a.no_sum->kind() == b.no_sum->kind() && a.no_sum->site() == b.no_sum->site());
}

std::string reasons(const std::vector<NotTakenSum>& not_taken) {
  std::string text;
  for (const NotTakenSum& sum : not_taken) {
    const std::string reason = sum.implementation + ": " + sum.why;
    if (text.find(reason) == std::string::npos) text += (text.empty() ? "" : "; ") + reason;
  }
  return text;
}

}  // namespace

Probes& Probes::operator+=(const Statistics& run) {
  if (!run.contains("hole tests")) return *this;
  return *this += Probes{run.count("hole tests"), run.count("tests of low-dimensional features")};
}

Probes& Probes::operator+=(const Probes& more) {
  faces += more.faces;
  points += more.points;
  return *this;
}

DifferentialResult differential(const Summands& summands,
                                const std::vector<Engine>& implementations, std::size_t largest) {
  DifferentialResult result;
  const std::size_t size = convolution(summands.p, summands.q).size();
  if (size > largest) {
    result.kind = DifferentialResult::Kind::skipped;
    result.why = "its convolution has " + std::to_string(size) +
                 " segments, the oracle takes at most " + std::to_string(largest);
    return result;
  }
  const Classification classes = classify(summands);
  result.holes_in_summand = classes.holes;
  result.overlapping_segments = classes.overlapping_segments;
  result.several_components = classes.several_components;
  OracleSums sums;
  try {
    sums = oracle_sums(summands.p, summands.q);
  } catch (const std::exception& e) {
    result.kind = DifferentialResult::Kind::disagreed;
    result.disagreement =
        without_sum("oracle", Boundary::closed, {}, std::string("the oracle threw: ") + e.what());
    return result;
  }
  result.by_oracle = sums;
  result.holes_in_sum = !sums.closed.holes.empty();
  result.low_dimensional_features =
      !sums.open.dangling_edges.empty() || !sums.open.isolated_vertices.empty();
  for (const Engine& implementation : implementations) {
    for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
      const MinkowskiSum& expected = boundary == Boundary::closed ? sums.closed : sums.open;
      try {
        result.disagreement =
            disagreement(summands, implementation, boundary, expected, result.probes);
      } catch (const NoSum& e) {
        result.not_taken.push_back({implementation.name, boundary, e.what()});
        continue;
      }
      if (!result.disagreement) continue;
      result.kind = DifferentialResult::Kind::disagreed;
      return result;
    }
  }
  if (!implementations.empty() && result.not_taken.size() == 2 * implementations.size()) {
    result.kind = DifferentialResult::Kind::skipped;
    result.why = reasons(result.not_taken);
  }
  return result;
}

ShrunkDisagreement shrink(const Summands& summands, const Disagreement& found,
                          const std::vector<Engine>& implementations, std::size_t most_tries) {
  std::vector<Engine> tried = implementations;
  // Where the oracle threw, it is none of them.
  if (found.implementation != "oracle")
    std::erase_if(tried, [&](const Engine& i) { return i.name != found.implementation; });
  const auto again = [&](const Summands& candidate) -> std::optional<Disagreement> {
    std::optional<Disagreement> seen =
        differential(candidate, tried, static_cast<std::size_t>(-1)).disagreement;
    return seen && same_failure(*seen, found) ? seen : std::nullopt;
  };
  std::size_t tries = 0;
  const Summands smallest = shrink(summands, [&](const Summands& candidate) {
    return tries++ <= most_tries && again(candidate).has_value();
  });
  return {smallest, again(smallest).value_or(found)};
}

void run_differential(
    const std::vector<DifferentialCase>& cases, const std::vector<Engine>& implementations,
    std::size_t largest, unsigned threads,
    const std::function<void(std::size_t index, const DifferentialResult& result)>& done) {
  std::mutex reporting;
  slide::for_each_number(cases.size(), threads, [&](std::size_t i) {
    const DifferentialResult result = differential(cases[i].make(), implementations, largest);
    const std::lock_guard lock(reporting);
    done(i, result);
  });
}

}  // namespace oplus
