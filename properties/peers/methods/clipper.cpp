// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/peers/methods/clipper_method.hpp"
#include "properties/peers/methods/returned_chains.hpp"

namespace oplus {

ReturnedChains clipper(const Summands& pair) { return returned_chains<ClipperMethod>(pair); }

}  // namespace oplus
