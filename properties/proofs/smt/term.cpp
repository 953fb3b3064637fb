// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/term.hpp"

#include <algorithm>

namespace oplus::smt {

namespace {

std::string numeral(const Rational& value) {
  const Rational size = abs(value);
  const std::string whole = size.get_num().get_str() + ".0";
  const std::string quotient =
      size.get_den() == 1 ? whole : "(/ " + whole + " " + size.get_den().get_str() + ".0)";
  return sign(value) < 0 ? "(- " + quotient + ")" : quotient;
}

std::string product(const Term::Monomial& names, const Rational& coefficient) {
  if (names.empty()) return numeral(coefficient);
  if (names.size() == 1 && coefficient == 1) return names.front();
  std::string text = "(*";
  if (coefficient != 1) text += " " + numeral(coefficient);
  for (const std::string& name : names) text += " " + name;
  return text + ")";
}

}  // namespace

Term::Term(const Rational& value) {
  if (sign(value) != 0) sum_[{}] = value;
}

Term Term::unknown(const std::string& name) {
  Term term;
  term.sum_[{name}] = 1;
  return term;
}

std::optional<Rational> Term::value() const {
  if (sum_.empty()) return Rational(0);
  if (degree() > 0) return std::nullopt;
  return sum_.begin()->second;
}

Rational Term::at(const std::map<std::string, Rational>& numbers) const {
  Rational value = 0;
  for (const auto& [names, coefficient] : sum_) {
    Rational product = coefficient;
    for (const std::string& name : names) product *= numbers.at(name);
    value += product;
  }
  return value;
}

std::size_t Term::degree() const {
  std::size_t most = 0;
  for (const auto& [names, coefficient] : sum_) most = std::max(most, names.size());
  return most;
}

void Term::add_names_to(std::set<std::string>& names) const {
  for (const auto& [of_monomial, coefficient] : sum_)
    names.insert(of_monomial.begin(), of_monomial.end());
}

std::string Term::to_smt() const {
  if (sum_.empty()) return "0.0";
  if (sum_.size() == 1) return product(sum_.begin()->first, sum_.begin()->second);
  std::string text = "(+";
  for (const auto& [names, coefficient] : sum_) text += " " + product(names, coefficient);
  return text + ")";
}

Rational Term::factor_to_normal_form() const {
  mpz_class numerators = 0, denominators = 1;
  for (const auto& [names, coefficient] : sum_) {
    numerators = gcd(numerators, coefficient.get_num());
    denominators = lcm(denominators, coefficient.get_den());
  }
  Rational factor(denominators, numerators);
  factor.canonicalize();
  return sign(sum_.rbegin()->second) < 0 ? Rational(-factor) : factor;
}

Term operator+(const Term& a, const Term& b) {
  Term sum = a;
  for (const auto& [names, coefficient] : b.sum_) {
    Rational& total = sum.sum_[names];
    total += coefficient;
    if (sign(total) == 0) sum.sum_.erase(names);
  }
  return sum;
}

Term operator*(const Term& a, const Term& b) {
  Term result;
  for (const auto& [names_a, coefficient_a] : a.sum_)
    for (const auto& [names_b, coefficient_b] : b.sum_) {
      Term part;
      Term::Monomial names = names_a;
      names.insert(names.end(), names_b.begin(), names_b.end());
      std::sort(names.begin(), names.end());
      part.sum_[names] = coefficient_a * coefficient_b;
      result = result + part;
    }
  return result;
}

}  // namespace oplus::smt
