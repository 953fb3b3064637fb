// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/bench/description.hpp"
#include "tests/bench/row.hpp"

namespace oplus {

/// A row's pairs in an engine's own form, to be computed repeatedly.
class PreparedPairs {
 public:
  virtual ~PreparedPairs() = default;

  /// The measured part: computes the result of each pair in the engine's own form and keeps it.
  /// Requires: no results are kept.
  virtual void compute() = 0;

  /// Discards the kept results.
  virtual void forget() = 0;

  /// Evaluates coordinates that compute() left unevaluated; returns false if the engine has none.
  virtual bool evaluate() = 0;

  /// Adds the times of the stages of the last compute(), by name.
  virtual void add_stages(std::map<std::string, double>& seconds) const = 0;

  /// Describes the kept results.
  virtual void describe(Description& description) const = 0;
};

/// Pairs that a method computes one after another. The method (method.hpp) has Input, Sum (any type of
/// result), converted() and sum(); evaluate(), if its results are lazy; and
///   void describe(const Input& input, const Sum& sum, Description& description) const;
///   optionally void add_stages(const Input&, const Sum&, std::map<…>& seconds) const;
template <typename Method>
class EachPair : public PreparedPairs {
 public:
  EachPair(Method method, const std::vector<Summands>& pairs) : method_(std::move(method)) {
    for (const Summands& pair : pairs) inputs_.push_back(method_.converted(pair));
    sums_.reserve(pairs.size());
  }

  void compute() override {
    for (const Input& input : inputs_) sums_.push_back(method_.sum(input));
  }

  void forget() override { sums_.clear(); }

  bool evaluate() override {
    constexpr bool is_lazy = requires(const Sum& sum) { Method::evaluate(sum); };
    if constexpr (is_lazy)
      for (const Sum& sum : sums_) Method::evaluate(sum);
    return is_lazy;
  }

  void add_stages(std::map<std::string, double>& seconds) const override {
    if constexpr (requires { method_.add_stages(inputs_[0], sums_[0], seconds); })
      for (std::size_t i = 0; i < sums_.size(); ++i)
        method_.add_stages(inputs_[i], sums_[i], seconds);
  }

  void describe(Description& description) const override {
    for (std::size_t i = 0; i < sums_.size(); ++i)
      method_.describe(inputs_[i], sums_[i], description);
  }

 private:
  using Input = typename Method::Input;
  using Sum = typename Method::Sum;

  Method method_;
  std::vector<Input> inputs_;
  std::vector<Sum> sums_;
};

/// Throws Unsupported.
using Preparing = std::function<std::unique_ptr<PreparedPairs>(const Row& row,
                                                               const std::vector<Summands>& pairs)>;

/// `method_for` returns the method for a row.
template <typename MethodFor>
Preparing each_pair(MethodFor method_for) {
  return [=](const Row& row, const std::vector<Summands>& pairs) {
    return std::make_unique<EachPair<decltype(method_for(row))>>(method_for(row), pairs);
  };
}

/// An engine that can be measured on the rows of its kind.
struct BenchEngine {
  std::string name;
  std::string what;
  Preparing prepare;
  std::string kind = "sums";
  bool rounds = false;
  bool is_ours = true;
  bool is_of_all_rows = true;  ///< otherwise only of those that name it
};

/// All engines, in the order in which they are listed.
const std::vector<BenchEngine>& bench_engines();

// The parts of the list.

/// Engines of sums: oplus's, also slide on two threads, and other libraries'.
std::vector<BenchEngine> own_engines();
std::vector<BenchEngine> peer_engines();

/// Engines of sums that are programs: oplus's, the proved one, CGAL's and Clipper's, from files to a file; and the
/// check of a certificate of one.
std::vector<BenchEngine> command_engines();

/// The convolution itself, not a sum: by cycle tracing, the same without coordinates, and by all pairs
/// (thesis, Section 3.2.1).
std::vector<BenchEngine> convolution_engines();

/// Each prepares a hole test and asks it questions about the row's pair: those of rca or, if the row is
/// about edges, one per edge of the arrangement.
std::vector<BenchEngine> hole_test_engines();

/// Distances, depths, and places of one pair.
std::vector<BenchEngine> distance_engines();

/// To test what measures them: one crashes, one never ends, one moves a vertex of the sum.
std::vector<BenchEngine> engines_at_fault();

}  // namespace oplus
