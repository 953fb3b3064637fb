// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "checked/engine.hpp"
#include "checked/slide/prepared_summand.hpp"
#include "checked/slide/scaling.hpp"

namespace oplus::slide {

/// The sum, computed in these numbers, which are large enough for both regions. Neither is empty.
/// Each kind of numbers has a file of its own, sum_in_*.cpp, so that they are compiled at the same time.
template <typename Numbers>
ComputedSum sum_in(const Region& p, const Region& q, const Scaling& scaling, Boundary boundary,
                   const EngineOptions& options);
template <typename Numbers>
ComputedSum sum_in(const PreparedSummand& p, const PreparedSummand& q, const Scaling& scaling,
                   Boundary boundary, const EngineOptions& options);

/// nearest_boundary (slide.hpp), likewise.
template <typename Numbers>
std::vector<Segment> nearest_in(const Region& p, const Region& q, const Scaling& scaling);

}  // namespace oplus::slide
