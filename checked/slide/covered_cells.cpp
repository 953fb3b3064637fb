// SPDX-License-Identifier: MIT
#include "checked/slide/covered_cells.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "reference/definitions/mutant.hpp"

namespace oplus::slide {

namespace {

constexpr double nothing = std::numeric_limits<double>::infinity();

double length_of(double x, double y) { return std::sqrt(x * x + y * y); }

/// Bits `first` to `last`, of 64.
std::uint64_t bits(int first, int last) {
  return first > last ? 0 : ~std::uint64_t{0} >> (63 - last) & ~std::uint64_t{0} << first;
}

}  // namespace

double near_distance(const NearSegment& s, double from, double to) {
  const double length = s.dx * s.dx + s.dy * s.dy;
  const double t = length > 0 ? std::clamp(-(s.x * s.dx + s.y * s.dy) / length, from, to) : from;
  return length_of(s.x + t * s.dx, s.y + t * s.dy);
}

CoveredCells::CoveredCells(std::span<const NearSegment> p, std::span<const NearSegment> q,
                           double radius, double error)
    : radius_(radius), cell_(2 * radius / count), error_(error) {
  constexpr std::size_t most_pairs = std::size_t{1} << 20;
  if (!(cell_ > 8 * error) || p.size() * q.size() > most_pairs) return;
  for (const NearSegment& e : p)
    for (const NearSegment& f : q)
      if (std::abs(e.dy) + std::abs(f.dy) > cell_ && std::abs(e.dx) + std::abs(f.dx) > cell_) {
        // Both edges upwards, from the lowest corner.
        const double a = e.dy < 0 ? -1 : 1, b = f.dy < 0 ? -1 : 1;
        cover(e.x + f.x + (a < 0 ? e.dx : 0) + (b < 0 ? f.dx : 0),
              e.y + f.y + (a < 0 ? e.dy : 0) + (b < 0 ? f.dy : 0), a * e.dx, a * e.dy, b * f.dx,
              b * f.dy);
      }
}

/// A row of cells is in the parallelogram between the rightmost places of its left side and the leftmost ones of its
/// right side, on the two lines that bound the row: the left side is convex, the right one concave.
void CoveredCells::cover(double x, double y, double ax, double ay, double bx, double by) {
  if (ax * by < ay * bx) {  // a to the right of b
    std::swap(ax, bx);
    std::swap(ay, by);
  }
  // On no line near a nearly level side, so that each x is off by less than 2^-30 of the largest coordinate.
  const double level = error_ * 0x1p14, margin = std::min(ay, by) > level ? error_ : level;
  const int lowest = line_above(y + margin), highest = line_below(y + ay + by - margin);
  const double along_a = ax / ay, along_b = bx / by;
  double last_left = 0, last_right = 0;
  for (int k = lowest; k <= highest; ++k) {
    const double up = line(k) - y;
    const double left = x + (up < by ? along_b * up : bx + along_a * (up - by));
    const double right = x + (up < ay ? along_a * up : ax + along_b * (up - ay));
    if (k > lowest) {
      const bool is_careless = OPLUS_MUTANT(
          "nearest-boundary-covers-too-much",
          "cells that a parallelogram only meets, or their neighbours, count as inside the open sum");
      const double low =
          is_careless ? std::min(left, last_left) - cell_ : std::max(left, last_left);
      const double high =
          is_careless ? std::max(right, last_right) + cell_ : std::min(right, last_right);
      rows_[static_cast<std::size_t>(k - 1)] |=
          bits(line_above(low + error_), line_below(high - error_) - 1);
    }
    last_left = left;
    last_right = right;
  }
}

double CoveredCells::least_uncovered(const NearSegment& s) const {
  double x = s.x, y = s.y, dx = s.dx, dy = s.dy;
  if (dy < 0) {
    x += dx;
    y += dy;
    dx = -dx;
    dy = -dy;
  }
  const double low_x = std::min(x, x + dx) - error_, high_x = std::max(x, x + dx) + error_;
  const double distance = near_distance(s), plain = distance > error_ ? distance - error_ : 0;
  const bool leaves = !(std::max({-low_x, high_x, error_ - y, y + dy + error_}) < radius_);
  double least = leaves ? std::max(plain, radius_) : nothing;
  const auto gap = [&](int k) { return std::max({0.0, line(k), -line(k + 1)}); };
  const bool is_level = !(dy > error_ * 0x1p14);
  // What is beside the square counts as in its outermost row or column: it is no nearer than that.
  const int last = std::min(line_below(y + dy + error_), count - 1);
  for (int row = line_below(y - error_); row <= last; ++row) {
    double from = low_x, to = high_x;
    if (!is_level) {
      const double low = x + dx / dy * std::clamp(line(row) - error_ - y, 0.0, dy);
      const double high = x + dx / dy * std::clamp(line(row + 1) + error_ - y, 0.0, dy);
      from = std::min(low, high) - error_;
      to = std::max(low, high) + error_;
    }
    const int end = std::min(line_below(to), count - 1);
    for (std::uint64_t open = bits(line_below(from), end) & ~rows_[static_cast<std::size_t>(row)];
         open != 0; open &= open - 1)
      least = std::min(least,
                       std::max(plain, length_of(gap(std::countr_zero(open)), gap(row)) - error_));
  }
  return least;
}

}  // namespace oplus::slide
