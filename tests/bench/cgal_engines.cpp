// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/peers/cgal_methods.hpp"
#include "tests/bench/sum_engine.hpp"

namespace oplus {

std::unique_ptr<PreparedPairs> prepare_cgal_reduced(const std::vector<Summands>& pairs) {
  return sums_by(CgalReduced{}, pairs);
}

std::unique_ptr<PreparedPairs> prepare_cgal_full(const std::vector<Summands>& pairs) {
  return sums_by(CgalFull{}, pairs);
}

std::unique_ptr<PreparedPairs> prepare_cgal_vertical(const std::vector<Summands>& pairs) {
  return sums_by(CgalVertical{}, pairs);
}

}  // namespace oplus
