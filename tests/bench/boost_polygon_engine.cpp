// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/peers/boost_polygon_method.hpp"
#include "tests/bench/sum_engine.hpp"

namespace oplus {

std::unique_ptr<PreparedPairs> prepare_boost_polygon(const std::vector<Summands>& pairs) {
  return sums_by(BoostPolygonMethod{}, pairs);
}

}  // namespace oplus
