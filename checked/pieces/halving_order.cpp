// SPDX-License-Identifier: MIT
#include "checked/pieces/halving_order.hpp"

#include <algorithm>
#include <numeric>
#include <span>

namespace oplus::pieces {

namespace {

void halve(std::span<std::uint32_t> order, const std::vector<Place>& places) {
  if (order.size() < 2) return;
  const auto by_x = [&](std::uint32_t i) { return places[i].x; };
  const auto by_y = [&](std::uint32_t i) { return places[i].y; };
  const auto length = [&](const auto& coordinate) {
    const auto [low, high] = std::ranges::minmax_element(order, {}, coordinate);
    return coordinate(*high) - coordinate(*low);
  };
  const auto middle = order.begin() + static_cast<std::ptrdiff_t>(first_half(order.size()));
  if (length(by_x) >= length(by_y))
    std::ranges::nth_element(order, middle, {}, by_x);
  else
    std::ranges::nth_element(order, middle, {}, by_y);
  halve({order.begin(), middle}, places);
  halve({middle, order.end()}, places);
}

}  // namespace

std::vector<std::uint32_t> halving_order(const std::vector<Place>& places) {
  std::vector<std::uint32_t> order(places.size());
  std::iota(order.begin(), order.end(), 0U);
  halve(order, places);
  return order;
}

}  // namespace oplus::pieces
