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
    .title = "What is counterclockwise between, and which of two equal directions comes first",
    .statement =
        "CCW(d, from, to): turning counterclockwise from one direction to another, d is met before the "
        "other, and after the start (Definitions 2.1.10 and 2.1.11). Of a direction of P and an equal one "
        "of Q, that of Q counts as turned counterclockwise by an infinitesimal (Definition 2.2.7).",
    .why =
        "Take the directions in the order of their angles, and behind each of P's the equal one of Q: "
        "then CCW compares how many places d and `to` are behind `from`. The code sees directions only "
        "through signs of coordinates and of skew products, so the eight directions of four lines, and "
        "for each whose it is, are all cases there are.",
    .hypotheses = {"the vectors are not zero"},
    .rests_on = {},
    .sources = {},
    .promises = {},
    .kills = {"ties-go-the-other-way", "left-and-right-are-one-direction", "angles-grow-clockwise",
              "between-is-on-the-other-arc"},
    .enumerate = enumerate,
});

}  // namespace

}  // namespace oplus
