// SPDX-License-Identifier: MIT
#include "checked/certificates/cell_trees.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "reference/definitions/mutant.hpp"
#include "reference/definitions/region.hpp"

namespace oplus::certificates {

namespace {

/// Where many long thin pieces cross, all would be as many as the square of their number for each cell.
constexpr std::size_t enough_pairs = 1024;

Point exact_centre(const Cell& cell) {
  Point sum{0, 0};
  for (const auto& corner : cell.corners) sum = sum + point_of(corner->exact);
  const Rational size(static_cast<unsigned long>(cell.corners.size()));
  return {sum.x / size, sum.y / size};
}

/// Where it is 0, given how high two places are above and below.
Place between(const Place& a, double at_a, const Place& b, double at_b) {
  const double t = at_a / (at_a - at_b);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

}  // namespace

PieceSums::Pair first_leaf(const Tree& tree) {
  const auto leaf = std::ranges::find_if(
      tree, [](const Step& step) { return std::holds_alternative<PieceSums::Pair>(step); });
  return std::get<PieceSums::Pair>(*leaf);
}

Tree CellTrees::tree(const std::vector<Point>& corners) {
  Cell whole;
  for (const Point& p : corners)
    whole.corners.push_back(std::make_shared<const CellCorner>(homogeneous(p), doubles_));
  whole.lines.resize(corners.size());
  tree_.clear();
  ends_.clear();
  open_.push_back({std::move(whole), std::nullopt});
  while (!open_.empty()) {
    const auto [cell, pair] = std::move(open_.back());
    open_.pop_back();
    if (!pair || !add_step(cell, *pair)) add_step(cell);
  }
  if (seams_ != nullptr) add_seams();
  return std::move(tree_);
}

void CellTrees::add_seams() {
  std::vector<Pair> first_leaves;  // of the trees behind a step, the next one last
  for (auto step = tree_.rbegin(); step != tree_.rend(); ++step) {
    if (const auto* pair = std::get_if<Pair>(&*step)) {
      first_leaves.push_back(*pair);
      continue;
    }
    auto& [line, seam] = std::get<Cut>(*step);
    const Pair of_positive = first_leaves.back();
    first_leaves.pop_back();
    seam = seams_->seam(ends_.back().from, ends_.back().to, line, first_leaves.back());
    first_leaves.back() = of_positive;
    ends_.pop_back();
  }
}

void CellTrees::add_step(const Cell& cell) {
  std::vector<Pair> pairs = sums_.pairs_around(centre(cell), enough_pairs);
  for (const Pair& pair : pairs) {
    if (!contains(pair, cell) &&
        !OPLUS_MUTANT("cells-stick-out-of-sums", "a cell is in a sum of pieces if its centre is"))
      continue;
    tree_.push_back(pair);
    return;
  }
  // Those along its sides may cover more, and leave what is as simple as before.
  constexpr std::size_t enough_sides = 8;
  const std::size_t size = cell.corners.size();
  for (std::size_t k = 0; k < size; k += 1 + size / enough_sides) {
    const Place &a = cell.corners[k]->near, &b = cell.corners[next(k, size)]->near;
    const std::vector<Pair> more =
        sums_.pairs_around({(a.x + b.x) / 2, (a.y + b.y) / 2}, enough_pairs);
    pairs.insert(pairs.end(), more.begin(), more.end());
  }
  std::vector<std::pair<double, Pair>> by_worth;
  for (const Pair& pair : pairs) by_worth.emplace_back(-worth(pair, cell), pair);
  std::ranges::stable_sort(by_worth, {}, [](const auto& entry) { return entry.first; });
  for (const auto& [worth, pair] : by_worth)
    if (add_step(cell, pair)) return;
  if (!add_step(cell, pair_exactly_around(cell)))
    throw std::logic_error("a sum of pieces around a cell's inner point meets only its boundary");
}

bool CellTrees::add_step(const Cell& cell, const Pair& pair) {
  sums_.sides(pair, half_planes_);
  std::vector<std::pair<double, std::size_t>> by_share;
  for (std::size_t side = 0; side < half_planes_.size(); ++side)
    if (std::ranges::any_of(cell.corners, [&](const auto& corner) {
          return half_planes_[side].above(corner->near) <= error_;
        }))
      by_share.emplace_back(-share_on_boundary(side, cell), side);
  std::ranges::sort(by_share);
  for (const auto& [share, side] : by_share) {
    const Sides sides = sides_of(pair, side, cell);
    if (std::ranges::min(sides) >= 0) continue;
    if (std::ranges::max(sides) <= 0) return false;
    const IntegerLine& line = sums_.exact_side(pair, side);
    HalvedCell parts = halved(cell, sides, line, doubles_);
    if (OPLUS_MUTANT("cuts-swap-their-sides", "the part to the right of a cut comes first"))
      std::swap(parts.positive, parts.negative);
    tree_.push_back(Cut{line, {}});
    ends_.push_back({std::move(parts.from), std::move(parts.to)});
    open_.push_back({std::move(parts.negative), std::nullopt});
    open_.push_back({std::move(parts.positive), pair});
    return true;
  }
  tree_.push_back(pair);
  return true;
}

/// A pair whose sum certainly contains the centre.
PieceSums::Pair CellTrees::pair_exactly_around(const Cell& cell) {
  const Point x = exact_centre(cell);
  const CellCorner centre(homogeneous(x), doubles_);
  std::optional<Pair> found;
  sums_.for_each_box_around(centre.near, error_, [&](const Pair& pair) {
    if (!sums_.is_near(pair, centre.near)) return true;
    sums_.sides(pair, half_planes_);
    for (std::size_t side = 0; side < half_planes_.size(); ++side)
      if (sums_.side_of(pair, side, half_planes_[side], centre) < 0) return true;
    found = pair;
    return false;
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

double CellTrees::share_on_boundary(std::size_t side, const Cell& cell) const {
  std::vector<Place> ends;
  const std::size_t size = cell.corners.size();
  for (std::size_t k = 0; k < size; ++k) {
    const Place &a = cell.corners[k]->near, &b = cell.corners[next(k, size)]->near;
    const double at_a = half_planes_[side].above(a), at_b = half_planes_[side].above(b);
    if ((at_a < 0) != (at_b < 0)) ends.push_back(between(a, at_a, b, at_b));
  }
  if (ends.size() != 2) return 0;
  double from = 0, to = 1;
  for (std::size_t other = 0; other < half_planes_.size(); ++other) {
    if (other == side) continue;
    const double at_from = half_planes_[other].above(ends[0]);
    const double at_to = half_planes_[other].above(ends[1]);
    if (at_from < -error_ && at_to < -error_) return 0;
    if (at_from < -error_) from = std::max(from, at_from / (at_from - at_to));
    if (at_to < -error_) to = std::min(to, at_from / (at_from - at_to));
  }
  return std::max(0.0, to - from);
}

/// The area that it covers; much less where each cut would go on far beyond it and cut up what others cover.
double CellTrees::worth(const Pair& pair, const Cell& cell) {
  sums_.sides(pair, half_planes_);
  double share = 0;
  for (std::size_t side = 0; side < half_planes_.size(); ++side)
    share = std::max(share, share_on_boundary(side, cell));
  return covered_area(cell) * (std::pow(share, 64) + 0.2);
}

double CellTrees::covered_area(const Cell& cell) const {
  std::vector<Place> part, cut;
  for (const auto& corner : cell.corners) part.push_back(corner->near);
  for (const HalfPlane& side : half_planes_) {
    cut.clear();
    for (std::size_t k = 0; k < part.size(); ++k) {
      const Place &a = part[k], &b = part[next(k, part.size())];
      const double at_a = side.above(a), at_b = side.above(b);
      if (at_a >= 0) cut.push_back(a);
      if ((at_a < 0) != (at_b < 0)) cut.push_back(between(a, at_a, b, at_b));
    }
    part.swap(cut);
  }
  double twice = 0;
  for (std::size_t k = 2; k < part.size(); ++k)
    twice += (part[k - 1].x - part[0].x) * (part[k].y - part[0].y) -
             (part[k - 1].y - part[0].y) * (part[k].x - part[0].x);
  return twice;
}

Sides CellTrees::sides_of(const Pair& pair, std::size_t side, const Cell& cell) {
  Sides result;
  for (const auto& corner : cell.corners)
    result.push_back(sums_.side_of(pair, side, half_planes_[side], *corner));
  return result;
}

}  // namespace oplus::certificates
