// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <ostream>

#include "checked/collision/collision_test.hpp"

namespace oplus {

inline constexpr std::array<CollisionMethod, 3> collision_methods{
    CollisionMethod::hierarchy, CollisionMethod::sweep, CollisionMethod::naive};

inline const char* name_of(CollisionMethod method) {
  constexpr std::array<const char*, 3> names{"hierarchy", "sweep", "naive"};
  return names[static_cast<std::size_t>(method)];
}

// What GoogleTest writes.
inline void PrintTo(CollisionMethod method, std::ostream* out) { *out << name_of(method); }

}  // namespace oplus
