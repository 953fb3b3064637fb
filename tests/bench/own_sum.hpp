// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/sum_engine.hpp"

namespace oplus {

/// What is the same for all engines of ours, whose results hold a MinkowskiSum `sum`.
template <typename Result>
struct OwnSum {
  using Input = Summands;
  using Sum = Result;
  static constexpr Arithmetic arithmetic = Arithmetic::exact;

  Summands converted(const Summands& pair) const { return pair; }

  ReturnedChains chains(const Summands&, const Result& result) const {
    ReturnedChains chains = result.sum.outer;
    chains.insert(chains.end(), result.sum.holes.begin(), result.sum.holes.end());
    return chains;
  }
};

}  // namespace oplus
