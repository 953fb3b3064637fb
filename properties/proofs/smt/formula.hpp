// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "properties/proofs/smt/term.hpp"

namespace oplus::smt {

/// Exact values of the unknowns.
struct Model {
  std::map<std::string, Rational> numbers;
  std::map<std::string, bool> flags;

  friend bool operator==(const Model&, const Model&) = default;
};

/// Which signs a number may have.
struct Signs {
  bool negative = false;
  bool zero = false;
  bool positive = false;

  bool has(int sign) const { return sign < 0 ? negative : sign > 0 ? positive : zero; }
  bool none() const { return !negative && !zero && !positive; }
  Signs mirrored() const { return {positive, zero, negative}; }

  friend bool operator==(const Signs&, const Signs&) = default;
  friend Signs operator&(const Signs& a, const Signs& b) {
    return {a.negative && b.negative, a.zero && b.zero, a.positive && b.positive};
  }
  friend Signs without(const Signs& a, const Signs& b) {
    return {a.negative && !b.negative, a.zero && !b.zero, a.positive && !b.positive};
  }
};

/// Signs of numbers, and flags, joined by "and", "or", "not" and "if"; simplified where a part is
/// known; so a formula without unknowns becomes true or false.
class Formula {
 public:
  Formula(bool value);
  static Formula sign_of(const Term& term, const Signs& signs);
  static Formula flag(const std::string& name);
  /// By a word of SMT-LIB: "and", "or", "not" or "ite". Requires: no part is known.
  static Formula join(const std::string& word, const std::vector<Formula>& parts);

  std::optional<bool> value() const;

  /// Whether it holds where the unknowns are these. Throws std::out_of_range where one is missing.
  bool holds_in(const Model& model) const;

  struct Names {
    std::set<std::string> numbers;
    std::set<std::string> flags;
  };
  void add_names_to(Names& names) const;
  std::size_t degree() const;
  std::string to_smt() const;

 private:
  struct Node;
  explicit Formula(std::shared_ptr<const Node> node);
  std::shared_ptr<const Node> node_;
};

Formula all_of(const std::vector<Formula>& parts);
Formula any_of(const std::vector<Formula>& parts);
Formula negation(const Formula& formula);
Formula if_then_else(const Formula& condition, const Formula& then, const Formula& otherwise);
Formula same(const Formula& a, const Formula& b);

inline Formula is_positive(const Term& term) { return Formula::sign_of(term, {.positive = true}); }
inline Formula is_zero(const Term& term) { return Formula::sign_of(term, {.zero = true}); }

}  // namespace oplus::smt
