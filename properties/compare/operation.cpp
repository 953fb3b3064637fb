// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/operation.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "checked/operations/complement.hpp"
#include "checked/operations/operations.hpp"
#include "checked/operations/unbounded_sum.hpp"
#include "checked/operations/union_of.hpp"
#include "checked/rounding/rounding.hpp"
#include "properties/compare/grid_promises.hpp"
#include "properties/runner/fitting_pairs.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/oracle/operations_by_definition.hpp"
#include "reference/oracle/set_by_pieces.hpp"

namespace oplus {

namespace {

using Compute = std::function<PlanarSet(const Region& p, const Region& q, const SumOf& sum)>;

PlanarSet path_set(const Region& region) {
  const SetByPieces set = path_and_points(region);
  return union_of({}, set.edges, set.points);
}

/// Throws EngineFailure where a rounding breaks a promise.
void require_roundings(const PlanarSet& sum) {
  const Rational step(7, 3);
  for (const Side side : {Side::nearest, Side::contain, Side::contained})
    if (const auto broken =
            broken_promise(sum, rounded(sum, Boundary::closed, step, side), step, side))
      throw EngineFailure(EngineFailure::Kind::unreadable, broken->kind,
                          broken->kind + ": " + broken->what);
}

/// What is compared besides the operations of the programs.
struct Extra {
  std::string name;
  bool takes_sums;  ///< where not, one engine is as good as all
  Compute compute;
};

const std::vector<Extra>& extras() {
  static const std::vector<Extra> all = {
      {"complement", false,
       [](const Region& p, const Region&, const SumOf&) { return complement(canonical_sum(p)); }},
      {"union", false,
       [](Region p, const Region& q, const SumOf&) { return union_of(together(std::move(p), q)); }},
      {"closed-sum", true, operation_called("sum").compute},
      {"path-sum", false,
       [](const Region& p, const Region& q, const SumOf& sum) {
         return unbounded_sum(path_set(p), canonical_sum(q), Boundary::closed, sum);
       }},
      {"sum-of-paths", false,
       [](const Region& p, const Region& q, const SumOf& sum) {
         PlanarSet of_q = path_set(q);
         of_q.isolated_vertices.clear();
         return unbounded_sum(path_set(p), of_q, Boundary::closed, sum);
       }},
      {"rounded-sum", true, [](const Region& p, const Region& q, const SumOf& sum) {
         PlanarSet value = unbounded_sum(p, q, Boundary::closed, sum);
         require_roundings(value);
         return value;
       }}};
  return all;
}

Extra compared(const std::string& name) {
  const auto extra = std::ranges::find(extras(), name, &Extra::name);
  return extra != extras().end() ? *extra : Extra{name, true, operation_called(name).compute};
}

/// A sum that operations can be computed with, right or wrong.
PlanarSet usable(PlanarSet sum) {
  const std::optional<Failure> fault =
      sum.outer.empty() ? Failure{"no outer chain"} : malformed(sum);
  if (fault)
    throw EngineFailure(EngineFailure::Kind::unreadable, fault->kind,
                        "a sum it was asked for: " + fault->kind);
  return sum;
}

/// The engine that computes the operation with its sums.
Engine computing(const Compute& operation, const Engine& engine) {
  Engine result = engine;
  result.compute = [operation, sum_by = engine.compute](const Region& p, const Region& q, Boundary,
                                                        const EngineOptions& options) {
    std::size_t faces = 0, points = 0;
    bool has_hole_tests = false;
    ComputedSum value;
    value.sum = operation(p, q, [&](const Region& a, const Region& b, Boundary boundary) {
      ComputedSum one = sum_by(a, b, boundary, options);
      if (one.statistics.contains("hole tests")) {
        has_hole_tests = true;
        faces += one.statistics.count("hole tests");
        points += one.statistics.count("tests of low-dimensional features");
      }
      return usable(std::move(one.sum));
    });
    if (has_hole_tests)
      value.statistics = {{"hole tests", faces}, {"tests of low-dimensional features", points}};
    return value;
  };
  return result;
}

/// Segments of the convolution of P and Q; the vertex-edge sum has several times as many.
constexpr std::size_t largest = 400;

}  // namespace

std::vector<std::string> compared_operations() {
  std::vector<std::string> names;
  for (const Operation& operation : operations()) names.push_back(operation.name);
  for (const Extra& extra : extras()) names.push_back(extra.name);
  return names;
}

std::string judge_in_words(const Campaign& campaign) {
  return campaign.is_of_sums() ? judge_named(campaign.judge).in_words
                               : "the definition of " + campaign.operation;
}

Rules rules_of_operation(const std::string& name, Rules of_sums) {
  const DefinedOperation* const defined = find_defined_operation(name);
  if (defined == nullptr) throw std::invalid_argument("no definition of " + name);
  const Extra operation = compared(name);
  if (!operation.takes_sums) of_sums.engines.resize(1);
  for (Engine& engine : of_sums.engines) engine = computing(operation.compute, engine);
  of_sums.boundaries = {Boundary::closed};
  of_sums.judge = {"oracle", "the definition of " + name, largest,
                   [defined](const Region& p, const Region& q) -> RightSums {
                     const PlanarSet value = defined->compute(p, q);
                     return {value, value};
                   }};
  return of_sums;
}

std::size_t default_largest(const Campaign& campaign) {
  return campaign.is_of_sums() ? judge_named(campaign.judge).largest : largest;
}

std::vector<std::string> parts_of_value(const PlanarSet& value) {
  std::vector<std::string> parts;
  if (value.is_unbounded) parts.emplace_back("unbounded");
  if (value.is_unbounded || !value.outer.empty()) parts.emplace_back("area");
  if (!value.dangling_edges.empty()) parts.emplace_back("edges");
  if (!value.isolated_vertices.empty()) parts.emplace_back("points");
  if (parts.empty()) parts.emplace_back("empty");
  return parts;
}

TaskSource pairs_that_fit(TaskSource source, const std::string& operation) {
  // Where both are unbounded, sums are the whole plane.
  const bool is_a_sum =
      operation == "nfp" || operation == "closed-sum" || operation == "rounded-sum";
  source.task = [task = source.task, is_a_sum](std::size_t i) {
    Task made = task(i);
    FittingPair fitting = fitting_pair(made.pair, i % fitting_kinds,
                                       i / 7 % 2 == 0 && !(is_a_sum && i % fitting_kinds == 4));
    return Task{made.name + ": " + fitting.how, std::move(fitting.pair)};
  };
  return source;
}

}  // namespace oplus
