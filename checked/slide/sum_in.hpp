// SPDX-License-Identifier: MIT
#pragma once

#include "checked/engine.hpp"
#include "checked/slide/scaling.hpp"

namespace oplus::slide {

/// The sum, computed in these numbers, which are large enough for both regions. Neither is empty.
/// Each kind of numbers has a file of its own, sum_in_*.cpp: one file with all four takes four times
/// as long to compile, and GCC inlines less in it, which costs a fifth of the speed.
template <typename Numbers>
ComputedSum sum_in(const Region& p, const Region& q, const Scaling& scaling, Boundary boundary,
                   const EngineOptions& options);

}  // namespace oplus::slide
