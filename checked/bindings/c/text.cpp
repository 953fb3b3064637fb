// SPDX-License-Identifier: MIT
// Sets as text.
#include <optional>
#include <string>

#include "checked/bindings/c/set.hpp"
#include "checked/version.hpp"

namespace {

using namespace oplus;

std::optional<int> rounded_to(int digits) { return digits < 0 ? std::optional<int>() : digits; }

}  // namespace

const char* oplus_version() { return version; }

oplus_code oplus_read(const char* text, oplus_set** set) {
  return c::put(set, [&] { return ValidSet(read_text(&c::given(text, "text"))); });
}

oplus_code oplus_read_set(const char* text, oplus_set** set) {
  return c::put(set, [&] { return read_set(&c::given(text, "text")); });
}

oplus_code oplus_wkt(const oplus_set* set, int digits, char** text) {
  return c::put(text, [&] { return to_wkt(c::set(set, "set"), rounded_to(digits)); });
}

oplus_code oplus_geojson(const oplus_set* set, int digits, char** text) {
  return c::put(text, [&] { return to_geojson(c::set(set, "set"), rounded_to(digits)); });
}

void oplus_free(oplus_set* set) { delete set; }
