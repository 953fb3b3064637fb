// SPDX-License-Identifier: MIT
#include "checked/verify/summand_parts.hpp"

#include <numeric>
#include <utility>

#include "checked/verify/trapezoids.hpp"

namespace oplus::convex_parts {

namespace {

Near near(const Interval& a) {
  if (is_exact(a)) return {a.low, 0};
  const double error = (a.high - a.low) * (1 + rounding);
  return error <= DBL_MAX ? Near{a.low, error} : Near{0, std::numeric_limits<double>::infinity()};
}

NearPoint near(const IntervalPoint& p) { return {near(p.x), near(p.y)}; }

bool is_small(const Point& p, const IntervalPoint& near) {
  const auto small = [](const Rational& exact, const Interval& x) {
    return std::abs(x.low) < 0x1p23 && exact.get_den() == 1;
  };
  return small(p.x, near.x) && small(p.y, near.y);
}

}  // namespace

SummandParts::SummandParts(const Region& region) : edges(oplus::edges(region)) {
  std::vector<std::size_t> lengths;
  for (const Chain& chain : chains(region)) lengths.push_back(chain.size());
  before.resize(edges.size());
  after.resize(edges.size());
  std::size_t first = 0;
  for (const std::size_t length : lengths) {
    for (std::size_t i = 0; i < length; ++i) {
      before[first + i] = first + previous(i, length);
      after[first + i] = first + next(i, length);
    }
    first += length;
  }
  for (const Segment& e : edges) {
    const Vector along = direction_of(e);
    const IntervalPoint source = interval(e.source);
    lines.push_back({&e.source, along, near(source), near(interval(along))});
    walls.push_back({&e.source, {0, 1}, near(source), {{0, 0}, {1, 0}}});
    corners.push_back({e.source, near(source), is_small(e.source, source)});
  }
  const std::vector<Trapezoid> parts = trapezoids(region);
  cut_corners.reserve(4 * parts.size());
  for (const Trapezoid& t : parts) {
    pieces.push_back({&lines[t.below],
                      &lines[t.above],
                      &walls[t.left],
                      &walls[t.right],
                      &corners[t.left],
                      &corners[t.right],
                      {at(t.below, t.left), at(t.below, t.right)},
                      {at(t.above, t.left), at(t.above, t.right)}});
  }
  std::vector<std::uint32_t> order(pieces.size());
  std::iota(order.begin(), order.end(), 0U);
  for (const Piece& piece : pieces) {
    Box box;
    for (const auto* side : {&piece.lower, &piece.upper})
      for (const Corner* corner : *side) box.add(*corner);
    boxes.push_back(box);
  }
  nodes.reserve(2 * pieces.size());
  if (!pieces.empty()) build(order.begin(), order.end());
}

/// Where an edge is on the vertical line through a vertex.
const Corner* SummandParts::at(std::size_t edge, std::size_t vertex) {
  const Segment& e = edges[edge];
  const Rational& x = edges[vertex].source.x;
  if (e.source.x == x) return &corners[edge];
  if (e.target.x == x) return &corners[after[edge]];
  const Vector& along = lines[edge].along;
  Point cut{x, e.source.y + (x - e.source.x) / along.x * along.y};
  const IntervalPoint near_cut = interval(cut);
  const bool small = is_small(cut, near_cut);
  cut_corners.push_back({std::move(cut), near(near_cut), small});
  return &cut_corners.back();
}

void SummandParts::build(std::vector<std::uint32_t>::iterator begin,
                         std::vector<std::uint32_t>::iterator end) {
  const std::size_t self = nodes.size();
  Box around;
  const auto middle = [](double low, double high) {
    return std::max(low, -DBL_MAX) / 2 + std::min(high, DBL_MAX) / 2;
  };
  for (auto i = begin; i != end; ++i) around.add(boxes[*i]);
  nodes.push_back({around, 0, *begin});
  if (end - begin == 1) return;
  const bool wide = around.x_high - around.x_low > around.y_high - around.y_low;
  const auto half = begin + (end - begin) / 2;
  std::nth_element(begin, half, end, [&](std::uint32_t a, std::uint32_t b) {
    const Box& of_a = boxes[a];
    const Box& of_b = boxes[b];
    return wide ? middle(of_a.x_low, of_a.x_high) < middle(of_b.x_low, of_b.x_high)
                : middle(of_a.y_low, of_a.y_high) < middle(of_b.y_low, of_b.y_high);
  });
  build(begin, half);
  nodes[self].right = static_cast<std::uint32_t>(nodes.size());
  build(half, end);
  double of_pieces = 0;
  for (auto i = begin; i != end; ++i) of_pieces += boxes[*i].size();
  nodes[self].slack = around.size() - of_pieces / static_cast<double>(end - begin);
}

}  // namespace oplus::convex_parts
