// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace oplus {

/// What a curve is fitted to: as many x as y.
struct Points {
  std::vector<double> x;
  std::vector<double> y;
};

/// A polynomial fitted by least squares, as the thesis fits its measurements (Section 6.2.4).
struct Fit {
  double constant = 0;
  double linear = 0;
  double quadratic = 0;
  double r_squared = 0;  ///< 1 - residual sum of squares / total sum of squares; 1 of constant y
};

/// The line (degree 1) or parabola (degree 2); nothing unless there is a different x more than the
/// curve has coefficients: without, R² is 1 and says nothing.
std::optional<Fit> fitted_curve(std::size_t degree, const Points& points);

/// As gnuplot reads it, in x.
std::string formula(const Fit& fit);

}  // namespace oplus
