// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/rca.hpp"
#include "checked/arrangement/sum_by_winding_numbers.hpp"
#include "tests/bench/own_sum.hpp"

namespace oplus {

namespace {

struct Rca : OwnSum<ComputedSum> {
  ComputedSum sum(const Summands& s) const { return rca(s.p, s.q, Boundary::closed); }
};

struct Winding : OwnSum<ComputedSum> {
  ComputedSum sum(const Summands& s) const {
    return sum_by_winding_numbers(s.p, s.q, Boundary::closed);
  }
};

/// Like rca, but for the first vertex of the first sum.
struct Wrong : Rca {
  ReturnedChains chains(const Summands& pair, const ComputedSum& computed) const {
    ReturnedChains chains = Rca::chains(pair, computed);
    chains.at(0).at(0).x -= 1;
    return chains;
  }
};

}  // namespace

std::unique_ptr<PreparedPairs> prepare_rca(const std::vector<Summands>& pairs) {
  return sums_by(Rca{}, pairs);
}

std::unique_ptr<PreparedPairs> prepare_winding(const std::vector<Summands>& pairs) {
  return sums_by(Winding{}, pairs);
}

std::unique_ptr<PreparedPairs> prepare_wrong(const std::vector<Summands>& pairs) {
  return sums_by(Wrong{}, pairs);
}

}  // namespace oplus
