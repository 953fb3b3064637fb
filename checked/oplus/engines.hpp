// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "checked/oplus/oplus.hpp"

/// @file
/// The other exact algorithms, for comparison, and certificates: link `oplus::engines`, which is under the
/// GPL, since CGAL's arrangements and triangulations are.
namespace oplus {

/// Returns the names of all engines, the default first: slide, rca, loops, winding.
std::vector<std::string> engine_names();

/// Returns the engine of that name, for SumOptions::engine. Throws std::invalid_argument, which
/// names all, for another name.
///
/// Example: minkowski_sum(p, q, {.engine = oplus::engine("rca")}).
const Engine* engine(std::string_view name);

/// Returns the text of a certificate that a given set is the closed sum of P and Q, which the program
/// oplus-certified checks (docs/certificates.md). Its vertices are numbered in the order of the regions, so the
/// three are to be written with their chains and vertices in this order, as to_wkt does. Throws InvalidInput,
/// with the first reason of verify, where it is not the sum; where a vertex of it equals the next one;
/// and as verify does. Cost: that of verify, and of triangulations.
///
/// Example: certify(p, q, {sum.region().region(), {}, {}}).
std::string certify(const ValidRegion& p, const ValidRegion& q, const GivenSum& given);

}  // namespace oplus
