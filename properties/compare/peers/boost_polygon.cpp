// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/peers/boost_polygon_method.hpp"
#include "properties/compare/peers/returned_chains.hpp"

namespace oplus {

ReturnedChains boost_polygon(const Summands& pair) {
  return returned_chains<BoostPolygonMethod>(pair);
}

}  // namespace oplus
