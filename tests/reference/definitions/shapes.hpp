// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

struct Shape {
  std::string name;
  Region region;
};

/// Valid regions of every kind, their coordinates integers from 0 to 8, their edges horizontal,
/// vertical or diagonal: so half-integer lines cut the plane into cells that lie inside or outside
/// as a whole (cells.hpp).
inline std::vector<Shape> shapes() {
  const Chain diamond{{4, 0}, {8, 4}, {4, 8}, {0, 4}};
  return {
      {"unit square", polygon(box(0, 0, 1, 1))},
      {"bar", polygon(box(0, 0, 3, 1))},
      {"triangle", polygon({{0, 0}, {2, 0}, {0, 2}})},
      {"diamond", polygon({{1, 0}, {2, 1}, {1, 2}, {0, 1}})},
      {"square with a collinear vertex", polygon({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}})},
      {"L", polygon({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}})},
      {"U", polygon({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}})},
      {"square with a notch", polygon({{0, 0}, {4, 0}, {4, 4}, {3, 4}, {2, 3}, {1, 4}, {0, 4}})},
      {"frame", {{{box(0, 0, 3, 3), {backwards(box(1, 1, 2, 2))}}}}},
      {"two squares apart", {{{box(0, 0, 1, 1), {}}, {box(2, 0, 3, 1), {}}}}},
      {"two squares touching in a corner", {{{box(0, 0, 1, 1), {}}, {box(1, 1, 2, 2), {}}}}},
      {"hole touching the outer chain",
       {{{box(0, 0, 4, 4), {backwards({{2, 0}, {3, 1}, {2, 2}, {1, 1}})}}}}},
      {"island in a hole",
       {{{box(0, 0, 5, 5), {backwards(box(1, 1, 4, 4))}}, {box(2, 2, 3, 3), {}}}}},
      {"island touching its hole",
       {{{box(0, 0, 4, 4), {backwards(box(1, 1, 3, 3))}}, {{{1, 2}, {2, 1}, {2, 2}}, {}}}}},
      {"square with a diamond hole that touches each side",
       {{{{{0, 0}, {4, 0}, {8, 0}, {8, 4}, {8, 8}, {4, 8}, {0, 8}, {0, 4}},
          {backwards(diamond)}}}}},
  };
}

}  // namespace oplus
