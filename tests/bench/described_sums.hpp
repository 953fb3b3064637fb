// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reference/definitions/minkowski_sum.hpp"
#include "tests/bench/measurement.hpp"

namespace oplus {

/// Tells results apart: 64 bits of a text that says them.
std::string digest_of(const std::string& text);

/// Says what these sums are made of. Exact ones are in canonical form, so that equal sums have equal
/// digests; of the others the chains are counted as they are, and there is no digest.
void describe_sums(const std::vector<MinkowskiSum>& sums, bool rounded, Measurement& measurement);

}  // namespace oplus
