// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/values.hpp"

namespace oplus::smt {

std::vector<std::string> numbers_of(const Unknown& unknown) {
  switch (unknown.kind) {
    case Unknown::Kind::vector:
      return {unknown.name + ".x", unknown.name + ".y"};
    case Unknown::Kind::direction:
      return {unknown.name + ".t"};
    case Unknown::Kind::number:
      break;
  }
  return {unknown.name};
}

std::vector<std::string> flags_of(const Unknown& unknown) {
  if (unknown.kind != Unknown::Kind::direction) return {};
  return {unknown.name + ".slanted", unknown.name + ".positive"};
}

Term Values::number(const std::string& name) const {
  return model_ != nullptr ? Term(model_->numbers.at(name)) : Term::unknown(name);
}

TermVector Values::vector(const std::string& name) const {
  return {number(name + ".x"), number(name + ".y")};
}

TermVector Values::direction(const std::string& name) const {
  const Term one = flag(name + ".positive") ? 1 : -1;
  if (flag(name + ".slanted")) return {number(name + ".t"), one};
  return {one, 0};
}

bool Values::flag(const std::string& name) const {
  return model_ != nullptr ? model_->flags.at(name) : is_set(name);
}

namespace {

Vector known(const TermVector& v) { return {v.x.value().value(), v.y.value().value()}; }

}  // namespace

Vector vector_in(const Model& model, const std::string& name) {
  return known(Values(model).vector(name));
}

Vector direction_in(const Model& model, const std::string& name) {
  return known(Values(model).direction(name));
}

}  // namespace oplus::smt
