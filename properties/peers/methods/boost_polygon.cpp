// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/peers/methods/boost_polygon_method.hpp"
#include "properties/peers/methods/returned_chains.hpp"

namespace oplus {

ReturnedChains boost_polygon(const Summands& pair) {
  return returned_chains<BoostPolygonMethod>(pair);
}

}  // namespace oplus
