// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "properties/runner/statement.hpp"

namespace oplus {

/// Sources that several statements share, and the shares that these keep.
struct Mixture {
  std::vector<Source> sources;
  std::vector<Promise> promises;
};

/// All kinds of regions, degenerate ones most. Small pairs are for checks whose cost grows like that of
/// the oracle, larger ones for those that look at segments only.
Mixture small_mixture();
Mixture larger_mixture();

/// Pairs of which many just fit, for sets with edges and vertices of their own.
Mixture tight_mixture();

/// What small and larger mixtures promise, collinear vertices apart.
std::vector<Promise> usual_promises();

}  // namespace oplus
