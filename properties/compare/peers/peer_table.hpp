// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "properties/compare/peers/method.hpp"

namespace oplus {

/// A method of somebody's library that oplus has an adapter for. All compute closed sums only.
struct Peer {
  std::string name;
  std::string what;
  Arithmetic arithmetic;
};

/// All of them, in the order in which they are listed.
const std::vector<Peer>& peers();

/// Returns nullptr for an unknown name.
const Peer* find_peer(const std::string& name);

/// How `oplus-peer` and programs of others say by their exit code why they return no sum. For
/// 77 see the manual of GNU Automake, for 65 sysexits.h.
inline constexpr int exit_not_taken = 77;  ///< the pair is none that it takes
inline constexpr int exit_no_region = 65;  ///< its result bounds no region

}  // namespace oplus
