// SPDX-License-Identifier: MIT
#include "reference/definitions/direction.hpp"

#include "reference/definitions/contract.hpp"
#include "reference/definitions/cyclic_order.hpp"

namespace oplus {

int compare_angle(const Vector& u, const Vector& v) {
  OPLUS_REQUIRES(u != (Vector{0, 0}) && v != (Vector{0, 0}), "Definition 2.1.7");
  return cyclic_order::compare_angle(u, v);
}

int compare(const Direction& a, const Direction& b) { return cyclic_order::compare(a, b); }

bool counterclockwise_between(const Direction& d, const Direction& from, const Direction& to) {
  return cyclic_order::counterclockwise_between(d, from, to);
}

}  // namespace oplus
