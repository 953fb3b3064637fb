// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/peers/clipper_method.hpp"
#include "tests/bench/sum_engine.hpp"

namespace oplus {

std::unique_ptr<PreparedPairs> prepare_clipper(const std::vector<Summands>& pairs) {
  return sums_by(ClipperMethod{}, pairs);
}

}  // namespace oplus
