// SPDX-License-Identifier: MIT
#pragma once

#include "checked/bindings/c/errors.hpp"
#include "checked/oplus/oplus.hpp"

/// What a handle leads to.
struct oplus_set {
  oplus::ValidSet value;
};

namespace oplus::c {

/// Returns a handle's set. Throws InvalidInput for NULL.
inline const ValidSet& set(const oplus_set* handle, const char* name) {
  return given(handle, name).value;
}

inline bool is_region(const ValidSet& set) {
  return set.dangling_edges().empty() && set.isolated_vertices().empty();
}

/// Returns a handle's region. Throws InvalidInput where it has lines or points.
inline const ValidRegion& region(const oplus_set* handle, const char* name) {
  if (!is_region(set(handle, name))) refuse(name, "it has lines or points", "a region");
  return handle->value.region();
}

inline Boundary boundary(int number) {
  return one_of(number, OPLUS_OPEN, "boundary") == OPLUS_OPEN ? Boundary::open : Boundary::closed;
}

/// Appends a number, exactly, and a blank before it.
inline void append(std::string& text, const Rational& number) {
  if (!text.empty() && text.back() != '\n') text += ' ';
  text += number.get_str();
}

inline void append(std::string& text, const Point& point) {
  append(text, point.x);
  append(text, point.y);
}

/// Puts the set that a call returns through a pointer.
template <typename Call>
oplus_code put(oplus_set** result, const Call& call) noexcept {
  return code_of([&] {
    oplus_set*& made = given(result, "the result");
    made = new oplus_set{call()};
  });
}

/// Puts the text that a call returns through a pointer.
template <typename Call>
oplus_code put(char** result, const Call& call) noexcept {
  return code_of([&] {
    char*& made = given(result, "the result");
    made = copied(call());
  });
}

}  // namespace oplus::c
