// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace oplus {

// Each registers benchmarks named SUBJECT/WHO.

/// The engines and CGAL's reduced convolution on pairs.
void compare_sums();

/// Cycle tracing and the naive way to the convolution, on growing families.
void compare_convolutions();

}  // namespace oplus
