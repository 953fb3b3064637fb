// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/distance/distance.hpp"
#include "checked/distance/ways_out.hpp"
#include "checked/operations/operations.hpp"
#include "checked/slide/by_slide.hpp"
#include "properties/runner/fitting_pairs.hpp"
#include "properties/runner/registry.hpp"
#include "reference/definitions/exact_box.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

namespace {

/// The corners and the middle of the cells of a grid over the places where Q overlaps P.
std::vector<Vector> places(const Region& p, const Region& q) {
  const ExactBox of_p = box_around(edges(p)), of_q = box_around(edges(q));
  const Vector low = of_p.low - of_q.high, size = of_p.high - of_q.low - low;
  std::vector<Vector> all;
  for (int i = 1; i < 6; ++i)
    for (int j = 1 + i % 2; j < 6; j += 2)
      all.push_back(low + Vector{i * size.x / 6, j * size.y / 6});
  return all;
}

Outcome check(const Summands& summands) {
  Outcome outcome;
  for (std::size_t kind = 0; kind < 3; ++kind) {
    const auto [how, pair] = fitting_pair(summands, kind);
    const PlanarSet all = no_fit(pair.p, pair.q, by_slide);
    if (edges(all).empty() && all.isolated_vertices.empty()) continue;
    const WaysOut general(edges(pair.p), edges(pair.q), all);
    for (const Vector& x : places(pair.p, pair.q)) {
      const std::optional<Overlap> near = depth(pair.p, translated(pair.q, x));
      if (!near) continue;
      ++outcome.counts["overlaps"];
      if (near->squared_depth != general.from(x).squared_depth)
        return outcome.fail(how + ": another depth than by all of the no-fit polygon", x);
    }
    // The same in large numbers, and where these or their squares are too small or too large for doubles.
    const std::optional<Overlap> one = depth(pair.p, pair.q);
    for (const int power : {-1100, -538, 70, 512, 1100}) {
      const mpz_class large = mpz_class(1) << std::abs(power);
      const Rational times = power < 0 ? Rational(1, large) : Rational(large, 7);
      const auto map = [&](const Point& x) { return Point{times * x.x, times * x.y}; };
      const std::optional<Overlap> other = depth(mapped(pair.p, map), mapped(pair.q, map));
      if (one.has_value() != other.has_value() ||
          (one && times * times * one->squared_depth != other->squared_depth))
        return outcome.fail(how + ": another depth in coordinates of the order of 2^" +
                            std::to_string(power));
    }
  }
  return outcome;
}

const Registered registered({
    .id = "step-nearest",
    .sources = {{"star", 16, 5},
                {"simple", 10, 2},
                {"tight", 2, 3},
                {"grid", 6, 4},
                {"holes", 3, 2},
                {"components", 3, 2}},
    .promises = {{"holes", 5}, {"parallel edges", 20}},
    .kills = {"nearest-boundary-covers-too-much", "ways-out-miss-exact-fits"},
    .cases = 500,
    .check = check,
});

}  // namespace

}  // namespace oplus
