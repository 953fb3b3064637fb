// SPDX-License-Identifier: MIT
#include "reference/definitions/tangent_set.hpp"

#include "reference/definitions/cyclic_order.hpp"

namespace oplus {

bool is_reflex(const Corner& corner) { return cyclic_order::is_reflex(corner); }

bool in_tangent_set(const Direction& d, const Corner& corner) {
  return cyclic_order::in_tangent_set(d, corner);
}

}  // namespace oplus
