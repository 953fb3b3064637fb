// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "reference/definitions/values.hpp"

namespace oplus {

/// Adds fractions up in pairs, and pairs in pairs: of unlike denominators, few sums are long then, where one sum that
/// all are added to would be long at each step.
class PairwiseSum {
 public:
  void add(Rational value) {
    for (std::size_t rest = count_++; rest % 2 == 1; rest /= 2) {
      value += sums_.back();
      sums_.pop_back();
    }
    sums_.push_back(std::move(value));
  }

  Rational total() const {
    Rational all = 0;
    for (auto sum = sums_.rbegin(); sum != sums_.rend(); ++sum) all += *sum;
    return all;
  }

 private:
  std::vector<Rational> sums_;  ///< of 2^k values each, the shortest last
  std::size_t count_ = 0;
};

}  // namespace oplus
