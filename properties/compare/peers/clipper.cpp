// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/peers/clipper_method.hpp"
#include "properties/compare/peers/returned_chains.hpp"

namespace oplus {

ReturnedChains clipper(const Summands& pair) { return returned_chains<ClipperMethod>(pair); }

}  // namespace oplus
