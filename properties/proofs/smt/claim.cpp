// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/claim.hpp"

namespace oplus::smt {

namespace {

std::vector<Formula> formulas(const std::vector<Claim>& claims, const Values& values) {
  std::vector<Formula> all;
  for (const Claim& claim : claims) all.push_back(claim(values));
  return all;
}

}  // namespace

Claim all_of(const std::vector<Claim>& parts) {
  return [parts](const Values& values) { return all_of(formulas(parts, values)); };
}

Claim any_of(const std::vector<Claim>& parts) {
  return [parts](const Values& values) { return any_of(formulas(parts, values)); };
}

Claim negation(const Claim& claim) {
  return [claim](const Values& values) { return negation(claim(values)); };
}

Claim same(const Claim& a, const Claim& b) {
  return [a, b](const Values& values) { return same(a(values), b(values)); };
}

Claim if_then_else(const Claim& condition, const Claim& then, const Claim& otherwise) {
  return [=](const Values& values) {
    return if_then_else(condition(values), then(values), otherwise(values));
  };
}

Claim fact(bool holds) {
  return [holds](const Values&) { return holds; };
}

Claim executed(const std::function<bool(const Values&)>& code) {
  return [code](const Values& values) { return executed([&] { return code(values); }); };
}

}  // namespace oplus::smt
