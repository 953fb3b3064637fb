// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/implementation.hpp"

#include "checked/rca/rca.hpp"

namespace oplus {

const std::vector<Implementation>& implementations() {
  static const std::vector<Implementation> table = {
      {"rca",
       [](const Region& p, const Region& q, Boundary boundary) { return rca(p, q, boundary).sum; }},
  };
  return table;
}

}  // namespace oplus
