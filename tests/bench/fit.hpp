// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace oplus {

/// A polynomial fitted by least squares, as the thesis fits its measurements (Section 6.2.4).
struct Fit {
  double constant = 0;
  double linear = 0;
  double quadratic = 0;
  double r_squared = 0;  ///< 1 - residual sum of squares / total sum of squares; 1 of constant y
};

/// Require: as many x as y. Return nothing unless there is a different x more than the curve has
/// coefficients: without, R² is 1 and says nothing.
using Fitting = std::optional<Fit>(const std::vector<double>& x, const std::vector<double>& y);
Fitting fit_line;
Fitting fit_parabola;

/// As gnuplot reads it, in x.
std::string formula(const Fit& fit);

}  // namespace oplus
