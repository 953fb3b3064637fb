// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace oplus {

/// The points that a curve is fitted to: x and y have the same size.
struct Points {
  std::vector<double> x;
  std::vector<double> y;
};

/// A polynomial fitted by least squares, as the thesis fits its measurements (Section 6.2.4).
struct Fit {
  double constant = 0;
  double linear = 0;
  double quadratic = 0;
  double r_squared = 0;  ///< 1 - residual sum of squares / total sum of squares; 1 for constant y
};

/// The line (degree 1) or parabola (degree 2). Empty unless there are more different x than
/// coefficients: with fewer, R² is always 1.
std::optional<Fit> fitted_curve(std::size_t degree, const Points& points);

/// A formula in x, for gnuplot.
std::string formula(const Fit& fit);

}  // namespace oplus
