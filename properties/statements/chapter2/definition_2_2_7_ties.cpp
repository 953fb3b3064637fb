// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/registry.hpp"
#include "properties/statements/directions_around.hpp"

namespace oplus {

namespace {

std::string in_words(const Direction& d) {
  return std::string(d.of == Summand::P ? "P" : "Q") + "'s (" + d.vector.x.get_str() + ", " +
         d.vector.y.get_str() + ")";
}

Enumeration enumerate() {
  const DirectionsAround around(4);  // three, and the axis from which the code measures
  Enumeration result;
  const auto direction = [&](std::size_t place) {
    return Direction{around[place / 2], place % 2 == 0 ? Summand::P : Summand::Q};
  };
  for_each_choice<3>(around.places(), [&](const std::array<std::size_t, 3>& places) {
    const auto [d, from, to] = places;
    ++result.cases;
    const bool is_between =
        around.turn(from, d) > 0 && around.turn(from, d) < around.turn(from, to);
    if (!result.failure.empty() ||
        counterclockwise_between(direction(d), direction(from), direction(to)) == is_between)
      return;
    result.failure = "from " + in_words(direction(from)) + " to " + in_words(direction(to)) + ", " +
                     in_words(direction(d)) + (is_between ? " is not" : " is") + " found between";
  });
  return result;
}

const Registered registered({
    .id = "definition-2.2.7",
    .kills = {"ties-go-the-other-way", "left-and-right-are-one-direction", "angles-grow-clockwise",
              "between-is-on-the-other-arc"},
    .enumerate = enumerate,
});

}  // namespace

}  // namespace oplus
