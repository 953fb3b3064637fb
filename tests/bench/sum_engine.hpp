// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "tests/bench/engine.hpp"

namespace oplus {

/// Says what these sums are made of. Exact ones are brought into canonical form first, so that equal
/// sums have equal digests; of the others the chains are counted as they are.
void describe_sums(const std::vector<ReturnedChains>& sums, Arithmetic arithmetic,
                   Measurement& measurement);

/// An engine of sums from what it does with a pair. What a `Method` has: method.hpp.
template <typename Method>
class SumsBy : public PreparedPairs {
 public:
  SumsBy(Method method, const std::vector<Summands>& pairs) : method_(std::move(method)) {
    inputs_.reserve(pairs.size());
    for (const Summands& pair : pairs) inputs_.push_back(method_.converted(pair));
    sums_.reserve(pairs.size());
  }

  void compute() override {
    for (const Input& input : inputs_) sums_.push_back(method_.sum(input));
  }

  void forget() override { sums_.clear(); }

  bool is_lazy() const override {
    return requires(const Sum& sum) { Method::evaluate(sum); };
  }

  void evaluate() override {
    if constexpr (requires(const Sum& sum) { Method::evaluate(sum); })
      for (const Sum& sum : sums_) Method::evaluate(sum);
  }

  void describe(Measurement& measurement) const override {
    std::vector<ReturnedChains> returned;
    returned.reserve(sums_.size());
    for (std::size_t i = 0; i < sums_.size(); ++i)
      returned.push_back(method_.chains(inputs_[i], sums_[i]));
    describe_sums(returned, Method::arithmetic, measurement);
    if constexpr (requires(const Sum& sum) { Method::segments(sum); }) {
      measurement.segments = 0;
      for (const Sum& sum : sums_) *measurement.segments += Method::segments(sum);
    }
  }

 private:
  using Input = typename Method::Input;
  using Sum = typename Method::Sum;

  Method method_;
  std::vector<Input> inputs_;
  std::vector<Sum> sums_;
};

template <typename Method>
std::unique_ptr<PreparedPairs> sums_by(Method method, const std::vector<Summands>& pairs) {
  return std::make_unique<SumsBy<Method>>(std::move(method), pairs);
}

}  // namespace oplus
