// SPDX-License-Identifier: MIT
// What is asked of a set.
#include <string_view>

#include "checked/bindings/c/set.hpp"
#include "checked/verify/verdict_text.hpp"

using namespace oplus;

oplus_code oplus_area(const oplus_set* p, double* nearest, char** exact) {
  return c::code_of([&] {
    const Rational result = area(c::set(p, "p"));
    if (exact != nullptr) *exact = c::copied(result.get_str());
    if (nearest != nullptr) *nearest = to_double(result);
  });
}

oplus_code oplus_contains(const oplus_set* p, double x, double y, int* is) {
  return c::code_of(
      [&] { c::given(is, "contains") = contains(c::set(p, "p"), Coordinates(x, y)) ? 1 : 0; });
}

oplus_code oplus_locate(const oplus_set* p, const char* x, const char* y, int* location) {
  return c::code_of([&] {
    const Coordinates point(&c::given(x, "x"), &c::given(y, "y"));
    const Location found = locate(point, c::set(p, "p"));
    c::given(location, "location") = found == Location::inside     ? OPLUS_INSIDE
                                     : found == Location::boundary ? OPLUS_ON_BOUNDARY
                                                                   : OPLUS_OUTSIDE;
  });
}

oplus_code oplus_equal(const oplus_set* a, const oplus_set* b, int* equal) {
  return c::code_of([&] { c::given(equal, "equal") = c::set(a, "a") == c::set(b, "b") ? 1 : 0; });
}

oplus_code oplus_verify(const oplus_set* p, const oplus_set* q, const char* claimed, int boundary,
                        int* is_sum, char** reason) {
  return c::code_of([&] {
    int& is = c::given(is_sum, "is_sum");
    const Verdict verdict =
        verify(c::region(p, "p"), c::region(q, "q"),
               read_claimed_sum(&c::given(claimed, "claimed")), c::boundary(boundary));
    constexpr std::string_view no = "no: ";
    const std::string why = verdict.is_sum() ? "" : text_of(verdict).substr(no.size());
    if (reason != nullptr) *reason = c::copied(why);
    is = verdict.is_sum() ? 1 : 0;
  });
}

oplus_code oplus_certify(const oplus_set* p, const oplus_set* q, const char* claimed, int boundary,
                         char** certificate) {
  return c::put(certificate, [&] {
    return certify(c::region(p, "p"), c::region(q, "q"),
                   read_claimed_sum(&c::given(claimed, "claimed")), c::boundary(boundary));
  });
}
