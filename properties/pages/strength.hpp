// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "properties/pages/registry_with_records.hpp"

namespace oplus {

/// How strongly a statement is backed, the strongest way that there is.
enum class Strength : std::uint8_t {
  machine_checked,          ///< all of it is a theorem in Coq
  enumerated,               ///< proved, or what it comes down to, case by case, by this program
  machine_checked_in_part,  ///< a part of it is
  solved,                   ///< its local form is proved over all reals by two SMT solvers
  sampled,                  ///< tried on generated pairs only
};

Strength strength(const Registry& registry, const Statement& statement);

/// Returns "machine-checked", "proved by enumeration", ...
std::string to_string(Strength strength);

/// Every way in which it is backed, with numbers: "machine-checked, 2 theorems; sampled, 1500 pairs".
std::string backing(const Registry& registry, const Statement& statement);

/// How the graph of statements is coloured, as Graphviz has it.
std::string colour(Strength strength);

/// The colours of all strengths in words, for below the graph.
std::string legend();

}  // namespace oplus
