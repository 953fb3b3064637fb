// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "checked/oplus/oplus.hpp"

/// @file
/// The other exact algorithms, for comparison: link `oplus::engines`, which is under the GPL, since CGAL's
/// arrangements are.
namespace oplus {

/// Returns the names of all engines, the default first: slide, rca, loops, winding.
std::vector<std::string> engine_names();

/// Returns the engine of that name, for SumOptions::engine. Throws std::invalid_argument, which
/// names all, for another name.
///
/// Example: minkowski_sum(p, q, {.engine = oplus::engine("rca")}).
const Engine* engine(std::string_view name);

}  // namespace oplus
