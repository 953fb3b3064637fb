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

/// A row's pairs in an engine's own form, ready to be computed again and again.
class PreparedPairs {
 public:
  virtual ~PreparedPairs() = default;

  /// What is measured: computes the result of each pair in the engine's own form and keeps it.
  /// Requires: nothing is kept.
  virtual void compute() = 0;

  /// Forgets what compute() kept.
  virtual void forget() = 0;

  /// Evaluates coordinates that compute() left unevaluated; returns false where there are none.
  virtual bool evaluate() = 0;

  /// Adds how long the stages of the last compute() took, by name.
  virtual void add_stages(std::map<std::string, double>& seconds) const = 0;

  /// Says what compute() kept.
  virtual void describe(Description& description) const = 0;
};

/// Pairs that a method computes one after another. Of what makes a method (method.hpp) it has Input,
/// Sum, its result whatever that is, converted() and sum(); evaluate(), where that does something; and
///   void describe(const Input& input, const Sum& sum, Description& description) const;
///   and, if it knows, void add_stages(const Input&, const Sum&, std::map<…>& seconds) const;
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

/// Throws NotTaken.
using Preparing = std::function<std::unique_ptr<PreparedPairs>(const Row& row,
                                                               const std::vector<Summands>& pairs)>;

/// `method_for` returns the method for a row.
template <typename MethodFor>
Preparing each_pair(MethodFor method_for) {
  return [=](const Row& row, const std::vector<Summands>& pairs) {
    return std::make_unique<EachPair<decltype(method_for(row))>>(method_for(row), pairs);
  };
}

/// What can be measured on rows of one subject.
struct BenchEngine {
  std::string name;
  std::string what;
  Preparing prepare;
  Subject subject = Subject::sums;
  bool rounds = false;
  bool is_ours = true;
  bool is_at_fault = false;  ///< on purpose
};

/// All engines, in the order in which they are listed.
const std::vector<BenchEngine>& bench_engines();

/// Returns nullptr for an unknown name. Rows of growth are for engines of sums.
const BenchEngine* find_bench_engine(Subject subject, const std::string& name);

// What the list is made of.

/// Engines of sums: of oplus, also slide on two threads, and of others.
std::vector<BenchEngine> own_engines();
std::vector<BenchEngine> peer_engines();

/// The convolution itself, not a sum: by cycle tracing, the same but which segments there are and not
/// where, and by all pairs (thesis, Section 3.2.1).
std::vector<BenchEngine> convolution_engines();

/// Each prepares a hole test and asks it questions about the row's pair: rca's or, as the row's word
/// `about` says, one about each edge of the arrangement.
std::vector<BenchEngine> hole_test_engines();

/// By which the benchmark itself is tested: one crashes, one never ends, one moves a vertex of the sum.
std::vector<BenchEngine> engines_at_fault();

}  // namespace oplus
