// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// Returns "closed" or "open", as in reports and commands.
inline std::string name(Boundary boundary) {
  return boundary == Boundary::closed ? "closed" : "open";
}

/// The inverse. Throws std::invalid_argument for another word.
inline Boundary boundary_named(const std::string& word) {
  for (const Boundary boundary : {Boundary::closed, Boundary::open})
    if (name(boundary) == word) return boundary;
  throw std::invalid_argument("neither closed nor open: " + word);
}

}  // namespace oplus
