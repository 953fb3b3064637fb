// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/certificates/cell_trees.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "reference/definitions/mutant.hpp"
#include "reference/io/writing.hpp"

namespace oplus::certificates {

namespace {

Point exact_centre(const Cell& cell) {
  Point sum{0, 0};
  for (const auto& corner : cell.corners) {
    sum.x += Rational(corner->exact.x) / Rational(corner->exact.w);
    sum.y += Rational(corner->exact.y) / Rational(corner->exact.w);
  }
  const Rational size(static_cast<unsigned long>(cell.corners.size()));
  return {sum.x / size, sum.y / size};
}

}  // namespace

PointOutsideSum::PointOutsideSum(const Point& x)
    : std::logic_error(to_string(x) + " is in no sum of two pieces") {}

Tree CellTrees::tree(const std::vector<Point>& corners) {
  Cell cell;
  for (const Point& p : corners)
    cell.corners.push_back(std::make_shared<const CellCorner>(homogeneous(p), doubles_));
  cell.lines.resize(corners.size());
  tree_.clear();
  solve(cell);
  return std::move(tree_);
}

void CellTrees::solve(const Cell& cell) {
  std::vector<Pair> pairs = pairs_around(cell);
  for (const Pair& pair : pairs) {
    if (!contains(pair, cell) &&
        !OPLUS_MUTANT("cells-stick-out-of-sums", "a cell is in a sum of pieces if its centre is"))
      continue;
    tree_.push_back(pair);
    return;
  }
  std::vector<std::pair<double, Pair>> by_area;
  for (const Pair& pair : pairs) by_area.emplace_back(-covered_area(pair, cell), pair);
  std::ranges::stable_sort(by_area, {}, [](const auto& entry) { return entry.first; });
  for (const auto& [area, pair] : by_area)
    if (solve_along(cell, pair)) return;
  const Pair pair = pair_exactly_around(cell);
  if (!solve_along(cell, pair))
    throw std::logic_error("a sum of pieces around a cell's inner point meets only its boundary");
}

/// Cuts off what is outside the sum of two pieces. Returns false if that is all of the cell.
bool CellTrees::solve_along(const Cell& cell, const Pair& pair) {
  sums_.sides(pair, half_planes_);
  std::vector<double> heights;
  std::vector<std::pair<double, std::size_t>> by_area;
  for (std::size_t side = 0; side < half_planes_.size(); ++side) {
    heights.clear();
    for (const auto& corner : cell.corners)
      heights.push_back(half_planes_[side].above(corner->near));
    if (std::ranges::min(heights) <= error_)
      by_area.emplace_back(-twice_area_below(cell, heights), side);
  }
  std::ranges::sort(by_area);
  for (const auto& [area, side] : by_area) {
    const Sides sides = sides_of(pair, side, cell);
    if (std::ranges::min(sides) >= 0) continue;
    if (std::ranges::max(sides) <= 0) return false;
    const IntegerLine line = sums_.exact_side(pair, side);
    HalvedCell parts = halved(cell, sides, line, doubles_);
    if (OPLUS_MUTANT("cuts-swap-their-sides", "the part to the right of a cut comes first"))
      std::swap(parts.positive, parts.negative);
    tree_.push_back(line);
    if (!solve_along(parts.positive, pair)) solve(parts.positive);
    solve(parts.negative);
    return true;
  }
  tree_.push_back(pair);
  return true;
}

std::vector<PieceSums::Pair> CellTrees::pairs_around(const Cell& cell) {
  std::vector<Pair> pairs;
  const Place x = centre(cell);
  sums_.for_each_box_around(x, error_, [&](const Pair& pair) {
    sums_.sides(pair, half_planes_);
    if (std::ranges::all_of(half_planes_,
                            [&](const HalfPlane& side) { return side.above(x) >= -error_; }))
      pairs.push_back(pair);
  });
  return pairs;
}

/// A pair whose sum certainly contains the centre.
PieceSums::Pair CellTrees::pair_exactly_around(const Cell& cell) {
  const Point x = exact_centre(cell);
  const HomogeneousPoint exact = homogeneous(x);
  std::optional<Pair> found;
  sums_.for_each_box_around(doubles_.near(x), error_, [&](const Pair& pair) {
    if (found) return;
    sums_.sides(pair, half_planes_);
    for (std::size_t side = 0; side < half_planes_.size(); ++side)
      if (side_of(sums_.exact_side(pair, side), exact) < 0) return;
    found = pair;
  });
  if (!found) throw PointOutsideSum(x);
  return *found;
}

bool CellTrees::contains(const Pair& pair, const Cell& cell) {
  sums_.sides(pair, half_planes_);
  std::vector<std::size_t> uncertain;
  for (std::size_t side = 0; side < half_planes_.size(); ++side) {
    for (const auto& corner : cell.corners) {
      const double above = half_planes_[side].above(corner->near);
      if (above < -error_) return false;
      if (above <= error_ && (uncertain.empty() || uncertain.back() != side))
        uncertain.push_back(side);
    }
  }
  return std::ranges::all_of(uncertain, [&](std::size_t side) {
    return std::ranges::min(sides_of(pair, side, cell)) >= 0;
  });
}

double CellTrees::covered_area(const Pair& pair, const Cell& cell) {
  sums_.sides(pair, half_planes_);
  std::vector<Place> part, cut;
  for (const auto& corner : cell.corners) part.push_back(corner->near);
  for (const HalfPlane& side : half_planes_) {
    cut.clear();
    for (std::size_t k = 0; k < part.size(); ++k) {
      const Place &a = part[k], &b = part[k + 1 == part.size() ? 0 : k + 1];
      const double at_a = side.above(a), at_b = side.above(b);
      if (at_a >= 0) cut.push_back(a);
      if ((at_a < 0) != (at_b < 0)) {
        const double t = at_a / (at_a - at_b);
        cut.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
      }
    }
    part.swap(cut);
  }
  double twice = 0;
  for (std::size_t k = 2; k < part.size(); ++k)
    twice += (part[k - 1].x - part[0].x) * (part[k].y - part[0].y) -
             (part[k - 1].y - part[0].y) * (part[k].x - part[0].x);
  return twice;
}

/// Doubles decide, or exact numbers where a corner is near the line.
Sides CellTrees::sides_of(const Pair& pair, std::size_t side, const Cell& cell) {
  Sides result;
  for (const auto& corner : cell.corners) {
    const double above = half_planes_[side].above(corner->near);
    result.push_back(above > error_    ? 1
                     : above < -error_ ? -1
                                       : side_of(sums_.exact_side(pair, side), corner->exact));
  }
  return result;
}

}  // namespace oplus::certificates
