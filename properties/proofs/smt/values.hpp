// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "properties/proofs/smt/paths.hpp"
#include "reference/definitions/direction.hpp"

namespace oplus::smt {

struct TermVector {
  Term x;
  Term y;

  friend TermVector operator+(const TermVector& a, const TermVector& b) {
    return {a.x + b.x, a.y + b.y};
  }
  friend TermVector operator-(const TermVector& a, const TermVector& b) {
    return {a.x - b.x, a.y - b.y};
  }
  friend TermVector operator-(const TermVector& a) { return {-a.x, -a.y}; }
  friend TermVector operator*(const Term& factor, const TermVector& a) {
    return {factor * a.x, factor * a.y};
  }
  friend Term cross(const TermVector& u, const TermVector& v) { return u.x * v.y - u.y * v.x; }
  friend Term dot(const TermVector& u, const TermVector& v) { return u.x * v.x + u.y * v.y; }
};

struct TermDirection {
  TermVector vector;
  Summand of;
};

struct TermCorner {
  TermVector in;
  TermVector out;
};

struct Unknown {
  enum class Kind {
    number,     ///< any real number
    vector,     ///< NAME.x and NAME.y, any two
    direction,  ///< one vector of each direction; see Values::direction
  };
  std::string name;
  Kind kind;
};

inline Unknown any_number(const std::string& name) { return {name, Unknown::Kind::number}; }
inline Unknown any_vector(const std::string& name) { return {name, Unknown::Kind::vector}; }
inline Unknown any_direction(const std::string& name) { return {name, Unknown::Kind::direction}; }

std::vector<std::string> numbers_of(const Unknown& unknown);
std::vector<std::string> flags_of(const Unknown& unknown);

/// The values of unknowns: the unknowns themselves, or the values in a model.
class Values {
 public:
  Values() = default;
  explicit Values(const Model& model) : model_(&model) {}

  bool are_known() const { return model_ != nullptr; }

  Term number(const std::string& name) const;
  TermVector vector(const std::string& name) const;

  /// (NAME.t, 1), (NAME.t, -1), (1, 0) or (-1, 0), as the flags NAME.slanted and NAME.positive say: of
  /// each direction one vector, so that skew products of two are linear.
  /// Requires: inside `executed`, unless there is a model.
  TermVector direction(const std::string& name) const;

 private:
  bool flag(const std::string& name) const;

  const Model* model_ = nullptr;
};

/// The vector of a model, by the kind of its unknown.
Vector vector_in(const Model& model, const std::string& name);
Vector direction_in(const Model& model, const std::string& name);

}  // namespace oplus::smt
