// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "properties/pages/registry_with_records.hpp"

namespace oplus {

/// How a statement is backed; of several ways, the strongest.
enum class Strength : std::uint8_t {
  machine_checked,  ///< all of it is a theorem in Coq
  enumerated,  ///< it, or a finite statement that implies it, is proved case by case by this program
  machine_checked_in_part,  ///< a part of it is
  solved,                   ///< its local form is proved over all reals by two SMT solvers
  sampled,                  ///< tested on generated pairs only
};

Strength strength(const Registry& registry, const Statement& statement);

/// Returns "machine-checked", "proved by enumeration", ...
std::string to_string(Strength strength);

/// All ways in which it is backed, with numbers: "machine-checked, 2 theorems; sampled, 1500
/// pairs".
std::string backing(const Registry& registry, const Statement& statement);

/// The colour of its node in the graph of statements, for Graphviz.
std::string colour(Strength strength);

/// The colour of its node's border: whether all of it, a part of it or nothing is stated in Coq.
std::string border_colour(const Registry& registry, const Statement& statement);

/// What all colours mean, in Markdown: a list of those of nodes, and one of those of borders.
std::string legend();

}  // namespace oplus
