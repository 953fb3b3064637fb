// SPDX-License-Identifier: MIT
#include "checked/verify/summand_parts.hpp"

#include <numeric>
#include <utility>

#include "reference/chains/near_point.hpp"

namespace oplus::convex_parts {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

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
  lines.reserve(edges.size());
  walls.reserve(edges.size());
  corners.reserve(edges.size());
  near_points.reserve(edges.size());
  for (const Segment& e : edges) {
    Vector along = direction_of(e);
    const IntervalPoint source = interval(e.source);
    const NearPoint near_along = near(interval(along));
    near_points.push_back(source);
    lines.push_back({&e.source, std::move(along), near(source), near_along});
    walls.push_back({&e.source, {0, 1}, near(source), {{0, 0}, {1, 0}}});
    corners.push_back({e.source, near(source), is_small(e.source, source)});
  }
  add_pieces(trapezoids(region));
  std::vector<std::uint32_t> order(pieces.size());
  std::iota(order.begin(), order.end(), 0U);
  for (const Piece& piece : pieces) {
    Box box;
    for (std::uint32_t i = 0; i < piece.count; ++i) box.add(*sides[piece.first + i].start);
    boxes.push_back(box);
  }
  nodes.reserve(2 * pieces.size());
  if (!pieces.empty()) build(order.begin(), order.end());
}

void SummandParts::add_pieces(const std::vector<Trapezoid>& trapezoids) {
  // Joined ones, by the first and the last, and each by the next. Lower edges lead to the right.
  constexpr auto none = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> last_above(edges.size(), none);  // the last trapezoid above each edge
  std::vector<std::uint32_t> joined_to(trapezoids.size(), none);
  std::vector<bool> is_first(trapezoids.size(), true);
  const auto turns_left = [&](std::size_t in, std::size_t out) {
    const auto source = [&](std::size_t e) {
      return oplus::NearPoint{near_points[e], &edges[e].source};
    };
    return orientation(source(in), source(out), source(after[out])) >= 0;
  };
  for (std::uint32_t i = 0; i < trapezoids.size(); ++i) {
    const Trapezoid& t = trapezoids[i];
    for (const std::size_t below : {t.below, before[t.below]}) {
      const std::uint32_t other = last_above[below];
      if (other == none || edges[trapezoids[other].right].source.x != edges[t.left].source.x)
        continue;
      const std::size_t above = trapezoids[other].above;
      if ((below == t.below || turns_left(below, t.below)) &&
          (above == t.above || (after[t.above] == above && turns_left(t.above, above)))) {
        joined_to[other] = i;
        is_first[i] = false;
      }
      break;
    }
    last_above[t.below] = i;
  }

  cut_corners.reserve(4 * trapezoids.size());
  std::vector<Side> upper;
  for (std::uint32_t i = 0; i < trapezoids.size(); ++i) {
    if (!is_first[i]) continue;
    const Trapezoid& leftmost = trapezoids[i];
    Piece piece{static_cast<std::uint32_t>(sides.size()), 0, 0};
    sides.push_back({&walls[leftmost.left], at(leftmost.above, leftmost.left)});
    sides.push_back({&lines[leftmost.below], at(leftmost.below, leftmost.left)});
    upper.clear();
    std::uint32_t last = i;
    for (; joined_to[last] != none; last = joined_to[last]) {
      const Trapezoid& t = trapezoids[last];
      const Trapezoid& next = trapezoids[joined_to[last]];
      if (next.below != t.below) sides.push_back({&lines[next.below], &corners[next.below]});
      if (next.above != t.above) upper.push_back({&lines[t.above], &corners[t.above]});
    }
    const Trapezoid& rightmost = trapezoids[last];
    piece.right_wall = static_cast<std::uint32_t>(sides.size()) - piece.first;
    sides.push_back({&walls[rightmost.right], at(rightmost.below, rightmost.right)});
    sides.push_back({&lines[rightmost.above], at(rightmost.above, rightmost.right)});
    sides.insert(sides.end(), upper.rbegin(), upper.rend());
    piece.count = static_cast<std::uint32_t>(sides.size()) - piece.first;
    pieces.push_back(piece);
  }
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
  // Where the middles are further apart: long boxes are told apart by their short sides.
  std::array<double, 4> middles{infinity, -infinity, infinity, -infinity};
  for (auto i = begin; i != end; ++i) {
    const double x = middle(boxes[*i].x_low, boxes[*i].x_high);
    const double y = middle(boxes[*i].y_low, boxes[*i].y_high);
    middles = {std::min(middles[0], x), std::max(middles[1], x), std::min(middles[2], y),
               std::max(middles[3], y)};
  }
  const bool wide = middles[1] - middles[0] > middles[3] - middles[2];
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
