// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/fit.hpp"

#include <algorithm>
#include <boost/math/statistics/linear_regression.hpp>
#include <numeric>
#include <set>
#include <sstream>
#include <tuple>

namespace oplus {

namespace {

using boost::math::statistics::simple_ordinary_least_squares;

std::size_t different(const std::vector<double>& x) {
  return std::set<double>(x.begin(), x.end()).size();
}

/// What is left of y where a line in x is taken away.
std::vector<double> residuals(const std::vector<double>& x, const std::vector<double>& y) {
  const auto [constant, linear] = simple_ordinary_least_squares(x, y);
  std::vector<double> result;
  for (std::size_t i = 0; i < x.size(); ++i) result.push_back(y[i] - constant - linear * x[i]);
  return result;
}

double r_squared(const Fit& fit, const std::vector<double>& x, const std::vector<double>& y) {
  const double mean = std::accumulate(y.begin(), y.end(), 0.0) / static_cast<double>(y.size());
  double residual = 0;
  double total = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double off = y[i] - fit.constant - fit.linear * x[i] - fit.quadratic * x[i] * x[i];
    residual += off * off;
    total += (y[i] - mean) * (y[i] - mean);
  }
  return total == 0 ? 1 : 1 - residual / total;
}

}  // namespace

std::optional<Fit> fit_line(const std::vector<double>& x, const std::vector<double>& y) {
  if (different(x) < 3) return std::nullopt;
  const auto [constant, linear] = simple_ordinary_least_squares(x, y);
  Fit fit{constant, linear, 0, 0};
  fit.r_squared = r_squared(fit, x, y);
  return fit;
}

std::optional<Fit> fit_parabola(const std::vector<double>& x, const std::vector<double>& y) {
  if (different(x) < 4) return std::nullopt;
  // By lines alone (Frisch, Waugh and Lovell): the coefficient of x² is the slope of what y has
  // left over a line in x, on what x² has left over one.
  std::vector<double> squares;
  for (const double one : x) squares.push_back(one * one);
  Fit fit;
  fit.quadratic = simple_ordinary_least_squares(residuals(x, squares), residuals(x, y)).second;
  std::vector<double> rest;
  for (std::size_t i = 0; i < x.size(); ++i) rest.push_back(y[i] - fit.quadratic * squares[i]);
  std::tie(fit.constant, fit.linear) = simple_ordinary_least_squares(x, rest);
  fit.r_squared = r_squared(fit, x, y);
  return fit;
}

std::string formula(const Fit& fit) {
  std::ostringstream text;
  text << std::scientific << fit.constant << " + (" << fit.linear << ")*x + (" << fit.quadratic
       << ")*x**2";
  return text.str();
}

}  // namespace oplus
