// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "reference/definitions/region.hpp"

namespace oplus {

inline Chain box(const Rational& x0, const Rational& y0, const Rational& x1, const Rational& y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

/// The same chain the other way round: an outer chain as a hole.
inline Chain backwards(const Chain& chain) { return {chain.rbegin(), chain.rend()}; }

/// One component; its holes are given counterclockwise.
inline Region holed(const Chain& outer, const std::vector<Chain>& holes) {
  Region region = polygon(outer);
  for (const Chain& hole : holes) region.components[0].holes.push_back(backwards(hole));
  return region;
}

/// The components of all.
inline Region together(const std::vector<Region>& regions) {
  Region all;
  for (const Region& region : regions) all = together(std::move(all), region);
  return all;
}

struct Shape {
  std::string name;
  Region region;
};

/// Valid regions of every kind, their coordinates integers from 0 to 8, their edges horizontal,
/// vertical or diagonal.
inline std::vector<Shape> shapes() {
  return {
      {"unit square", polygon(box(0, 0, 1, 1))},
      {"bar", polygon(box(0, 0, 3, 1))},
      {"triangle", polygon({{0, 0}, {2, 0}, {0, 2}})},
      {"diamond", polygon({{1, 0}, {2, 1}, {1, 2}, {0, 1}})},
      {"square with a collinear vertex", polygon({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}})},
      {"L", polygon({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}})},
      {"U", polygon({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}})},
      {"square with a notch", polygon({{0, 0}, {4, 0}, {4, 4}, {3, 4}, {2, 3}, {1, 4}, {0, 4}})},
      {"frame", holed(box(0, 0, 3, 3), {box(1, 1, 2, 2)})},
      {"two squares apart", together({polygon(box(0, 0, 1, 1)), polygon(box(2, 0, 3, 1))})},
      {"two squares touching in a corner",
       together({polygon(box(0, 0, 1, 1)), polygon(box(1, 1, 2, 2))})},
      {"hole touching the outer chain", holed(box(0, 0, 4, 4), {{{2, 0}, {3, 1}, {2, 2}, {1, 1}}})},
      {"island in a hole",
       together({holed(box(0, 0, 5, 5), {box(1, 1, 4, 4)}), polygon(box(2, 2, 3, 3))})},
      {"island touching its hole",
       together({holed(box(0, 0, 4, 4), {box(1, 1, 3, 3)}), polygon({{1, 2}, {2, 1}, {2, 2}})})},
      {"square with a diamond hole that touches each side",
       holed({{0, 0}, {4, 0}, {8, 0}, {8, 4}, {8, 8}, {4, 8}, {0, 8}, {0, 4}},
             {{{4, 0}, {8, 4}, {4, 8}, {0, 4}}})},
  };
}

inline Region shape(const std::string& name) {
  for (const Shape& one : shapes())
    if (one.name == name) return one.region;
  throw std::invalid_argument("no shape " + name);
}

}  // namespace oplus
