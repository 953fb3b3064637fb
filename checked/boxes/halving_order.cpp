// SPDX-License-Identifier: MIT
#include "checked/boxes/halving_order.hpp"

#include <algorithm>
#include <cfloat>
#include <numeric>

namespace oplus {

namespace {

struct Middle {
  double x, y;
};

/// Of infinite ends, too: only the order depends on it.
double middle(double low, double high) {
  return std::max(low, -DBL_MAX) / 2 + std::min(high, DBL_MAX) / 2;
}

void halve(std::span<std::uint32_t> order, const std::vector<Middle>& middles) {
  if (order.size() < 2) return;
  const auto by_x = [&](std::uint32_t i) { return middles[i].x; };
  const auto by_y = [&](std::uint32_t i) { return middles[i].y; };
  const auto length = [&](const auto& coordinate) {
    const auto [low, high] = std::ranges::minmax_element(order, {}, coordinate);
    return coordinate(*high) - coordinate(*low);
  };
  const std::uint32_t half = first_half(static_cast<std::uint32_t>(order.size()));
  const auto middle = order.begin() + half;
  if (length(by_x) >= length(by_y))
    std::ranges::nth_element(order, middle, {}, by_x);
  else
    std::ranges::nth_element(order, middle, {}, by_y);
  halve(order.first(half), middles);
  halve(order.subspan(half), middles);
}

}  // namespace

std::vector<std::uint32_t> halving_order(std::span<const Box> boxes) {
  std::vector<Middle> middles;
  middles.reserve(boxes.size());
  for (const Box& box : boxes)
    middles.push_back({middle(box.low_x, box.high_x), middle(box.low_y, box.high_y)});
  std::vector<std::uint32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0U);
  halve(order, middles);
  return order;
}

}  // namespace oplus
