// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "properties/runner/statement.hpp"

namespace oplus {

/// Sources that mix all kinds of regions, degenerate ones most. Small pairs are for checks whose
/// cost grows like that of the oracle, larger ones for those that look at segments only.
std::vector<Source> small_mixture();
std::vector<Source> larger_mixture();

/// The shares that both mixtures keep.
std::vector<Promise> promises_of_mixture();

}  // namespace oplus
