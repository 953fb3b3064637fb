// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "reference/definitions/rational.hpp"

namespace oplus::smt {

/// A polynomial in named unknowns. Code that is a template over its number type can run on it; see
/// paths.hpp for its comparisons.
class Term {
 public:
  using Monomial = std::vector<std::string>;  ///< sorted; names may repeat

  Term(int value = 0) : Term(Rational(value)) {}
  Term(const Rational& value);
  static Term unknown(const std::string& name);

  /// Its value; empty if it contains an unknown.
  std::optional<Rational> value() const;

  /// Its value where the unknowns have these. Throws std::out_of_range where one is missing.
  Rational at(const std::map<std::string, Rational>& numbers) const;

  std::size_t degree() const;
  void add_names_to(std::set<std::string>& names) const;
  std::string to_smt() const;

  /// The positive factor that makes all coefficients integers without a common divisor, and the
  /// leading one positive or not: then the factor is negative. Requires: not zero.
  Rational factor_to_normal_form() const;

  friend Term operator+(const Term& a, const Term& b);
  friend Term operator*(const Term& a, const Term& b);
  friend Term operator-(const Term& a) { return Term(-1) * a; }
  friend Term operator-(const Term& a, const Term& b) { return a + -b; }

  /// An order of the polynomials, for containers.
  struct InOrder {
    bool operator()(const Term& a, const Term& b) const { return a.sum_ < b.sum_; }
  };

 private:
  std::map<Monomial, Rational> sum_;  ///< without zeros
};

}  // namespace oplus::smt
