// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <sstream>
#include <string>

#include "reference/io/reading.hpp"

namespace oplus {

inline ReadRegion region_from(const std::string& text) {
  std::istringstream in(text);
  return read_region(in, "file");
}

inline ReadSum sum_from(const std::string& text) {
  std::istringstream in(text);
  return read_sum(in, "file");
}

/// The whole message with which `read` refuses, or "accepted".
template <typename Read>
std::string refusal(Read read) {
  try {
    read();
  } catch (const InvalidInput& refused) {
    return refused.what();
  }
  return "accepted";
}

/// An input that must be refused, and the whole line that must say why.
struct Refused {
  std::string test;
  std::string text;
  std::string message;

  friend void PrintTo(const Refused& refused, std::ostream* out) {
    *out << refused.text.substr(0, 60);
  }
};

inline std::string test_name(const testing::TestParamInfo<Refused>& info) {
  return info.param.test;
}

inline Chain rectangle(const Rational& x0, const Rational& y0, const Rational& x1,
                       const Rational& y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

inline Chain turned(const Chain& chain) { return {chain.rbegin(), chain.rend()}; }

}  // namespace oplus
