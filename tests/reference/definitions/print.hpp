// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <ostream>

#include "reference/definitions/planar_set.hpp"

namespace oplus {

// What GoogleTest writes where a comparison fails.

inline void PrintTo(const Point& p, std::ostream* out) { *out << '(' << p.x << ' ' << p.y << ')'; }

inline void PrintTo(const Segment& s, std::ostream* out) {
  PrintTo(s.source, out);
  *out << "->";
  PrintTo(s.target, out);
}

inline void PrintTo(const PlanarSet& sum, std::ostream* out) {
  const auto print = [&](const char* what, const auto& all) {
    *out << what << ':';
    for (const auto& one : all) *out << ' ' << testing::PrintToString(one);
    *out << '\n';
  };
  print("outer", sum.outer);
  print("holes", sum.holes);
  print("dangling edges", sum.dangling_edges);
  print("isolated vertices", sum.isolated_vertices);
}

}  // namespace oplus
