// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/fit.hpp"

#include <boost/math/statistics/linear_regression.hpp>
#include <set>
#include <sstream>
#include <tuple>

namespace oplus {

namespace {

using boost::math::statistics::simple_ordinary_least_squares;
using boost::math::statistics::variance;

/// y minus its fitted line in x.
std::vector<double> residuals(const std::vector<double>& x, const std::vector<double>& y) {
  const auto [constant, linear] = simple_ordinary_least_squares(x, y);
  std::vector<double> result;
  for (std::size_t i = 0; i < x.size(); ++i) result.push_back(y[i] - constant - linear * x[i]);
  return result;
}

}  // namespace

std::optional<Fit> fitted_curve(std::size_t degree, const Points& points) {
  const auto& [x, y] = points;
  if (std::set<double>(x.begin(), x.end()).size() < degree + 2) return std::nullopt;
  Fit fit;
  std::vector<double> rest = y;  // y without its quadratic part
  if (degree == 2) {
    // With lines only (Frisch, Waugh and Lovell): the coefficient of x² is the slope of the residuals
    // of y over those of x².
    std::vector<double> squares;
    for (const double one : x) squares.push_back(one * one);
    fit.quadratic = simple_ordinary_least_squares(residuals(x, squares), residuals(x, y)).second;
    for (std::size_t i = 0; i < x.size(); ++i) rest[i] -= fit.quadratic * squares[i];
  }
  std::tie(fit.constant, fit.linear) = simple_ordinary_least_squares(x, rest);
  const double total = variance(y);
  // The mean of residuals is 0, so their variance is the mean of their squares.
  fit.r_squared = total == 0 ? 1 : 1 - variance(residuals(x, rest)) / total;
  return fit;
}

std::string formula(const Fit& fit) {
  std::ostringstream text;
  text << std::scientific << fit.constant << " + (" << fit.linear << ")*x + (" << fit.quadratic
       << ")*x**2";
  return text.str();
}

}  // namespace oplus
