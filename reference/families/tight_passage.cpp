// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "reference/chains/validity.hpp"
#include "reference/families/lattice_polygon.hpp"
#include "reference/families/pairs.hpp"
#include "reference/families/rich_regions.hpp"

namespace oplus {

namespace {

using Cell = std::pair<int, int>;

bool is_lower(const Cell& a, const Cell& b) { return a.second < b.second; }

Cells moved(const Cells& cells, const Cell& by) {
  Cells result;
  for (const auto& [x, y] : cells) result.emplace(x + by.first, y + by.second);
  return result;
}

/// The cells of the smallest box around the given ones with a margin of one cell.
Cells block_around(const Cells& cells) {
  const auto [left, right] = std::minmax_element(cells.begin(), cells.end());
  const auto [low, high] = std::minmax_element(cells.begin(), cells.end(), is_lower);
  Cells block;
  for (int x = left->first - 1; x <= right->first + 1; ++x)
    for (int y = low->second - 1; y <= high->second + 1; ++y) block.emplace(x, y);
  return block;
}

/// A box of cells, some without one of their corners.
Cells small_shape(Random& random) {
  const int width = uniform(random, 1, 3);
  const int height = uniform(random, 1, 3);
  Cells shape;
  for (int x = 0; x < width; ++x)
    for (int y = 0; y < height; ++y) shape.emplace(x, y);
  if (width > 1 && height > 1 && one_in(random, 3)) {
    const int x = one_in(random, 2) ? 0 : width - 1;
    const int y = one_in(random, 2) ? 0 : height - 1;
    shape.erase({x, y});
  }
  return shape;
}

/// A block out of which the reflected second summand has been cut where it stands, and along up to
/// two legs to the right and up. It fits on the path only, so this is low-dimensional: a dangling
/// edge, or with no leg an isolated vertex. It stays so where the passage leads out of the block,
/// by an entrance just wide enough or narrower.
Summands passage(Random& random, std::size_t longest_leg) {
  const Cells shape = small_shape(random);
  const int legs = uniform(random, 0, 2);
  bool upwards = one_in(random, 2);
  Cell at{0, 0};
  Cells cut_out = shape;
  const auto step = [&] {
    (upwards ? at.second : at.first) += 1;
    cut_out.merge(moved(shape, at));
  };
  for (int leg = 0; leg < legs; ++leg) {
    for (std::size_t length = 1 + uniform_index(random, longest_leg); length > 0; --length) step();
    if (leg + 1 < legs) upwards = !upwards;
  }
  Cells block = block_around(cut_out);
  switch (uniform(random, 0, 2)) {
    case 0:
      break;
    case 1:  // the whole shape through the margin
      step();
      break;
    case 2: {  // one cell through the margin above the last, or beside it
      const Cells last = moved(shape, at);
      Cell door = upwards ? *std::max_element(last.begin(), last.end(), is_lower) : *last.rbegin();
      (upwards ? door.second : door.first) += 1;
      cut_out.insert(door);
      break;
    }
  }
  for (const Cell& cell : cut_out) block.erase(cell);
  return {region_of_cells(block), reflected(region_of_cells(shape))};
}

/// A box with a hole that the reflected second summand just fills: an isolated vertex.
Summands mould(Random& random) {
  const int side = uniform(random, 3, 5);
  const Region q = polygon(lattice_polygon(random, side, 6));
  const Chain filled = reflected(q).components[0].outer;
  const Chain hole(filled.rbegin(), filled.rend());
  while (true) {
    const int left = -side + 1 - uniform(random, 0, 1);
    const int low = -side + 1 - uniform(random, 0, 1);
    const int right = uniform(random, 0, 1);
    const int high = uniform(random, 0, 1);
    const Region p{{{{{left, low}, {right, low}, {right, high}, {left, high}}, {hole}}}};
    if (!find_defect(p)) return {p, q};
  }
}

/// A square whose hole touches all its sides, so that only its corners are left, with itself: where
/// they interlock, chains of both touch (docs/findings.md, on Theorem 2.3.2).
Summands interlocked() {
  const Region corners{{{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{{0, 1}, {1, 2}, {2, 1}, {1, 0}}}}}};
  return {corners, corners};
}

struct Shear {
  Rational xx, xy, yx, yy;

  Point operator()(const Point& p) const { return {xx * p.x + xy * p.y, yx * p.x + yy * p.y}; }
};

/// Small integers, determinant positive, so that it keeps orientations.
Shear random_shear(Random& random) {
  while (true) {
    const int xx = uniform(random, -2, 2);
    const int xy = uniform(random, -1, 1);
    const int yx = uniform(random, -1, 1);
    const int yy = uniform(random, -2, 2);
    if (xx * yy - xy * yx > 0) return {xx, xy, yx, yy};
  }
}

}  // namespace

Summands tight_pair(Random& random, std::size_t n) {
  Summands pair = one_in(random, 10)  ? interlocked()
                  : one_in(random, 3) ? mould(random)
                                      : passage(random, n);
  if (one_in(random, 4)) {
    // A little wider, narrower or both: what just fitted now has room to move, or does not fit.
    const Rational factors[] = {Rational(7, 8), Rational(1), Rational(9, 8)};
    const Rational& x = factors[uniform_index(random, 3)];
    const Rational& y = factors[uniform_index(random, 3)];
    pair.q = mapped(pair.q, [&](const Point& p) { return Point{x * p.x, y * p.y}; });
  }
  // The sum of the images is the image of the sum.
  if (one_in(random, 2)) {
    const Shear shear = random_shear(random);
    pair = {mapped(pair.p, shear), mapped(pair.q, shear)};
  }
  return pair;
}

}  // namespace oplus
