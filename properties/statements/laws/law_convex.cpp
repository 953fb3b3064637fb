// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/laws/convex_hull.hpp"

namespace oplus {

namespace {

/// Two convex chains merged by the angles of their edges, O(n + m); equal directions become one
/// edge. Each chain starts at its smallest vertex, so its first edge is the first after -y.
Chain merged(const Chain& p, const Chain& q) {
  const std::vector<Segment> of_p = edges(p), of_q = edges(q);
  Chain result;
  Point at = p[0] + q[0];
  for (std::size_t i = 0, j = 0; i < of_p.size() || j < of_q.size();) {
    result.push_back(at);
    const Rational turn = i == of_p.size()   ? Rational(-1)
                          : j == of_q.size() ? Rational(1)
                                             : cross(direction_of(of_p[i]), direction_of(of_q[j]));
    // If the two are in one half plane, the cross product decides; else the one in the first half
    // plane comes first.
    const auto half = [](const Segment& e) { return e.source < e.target ? 0 : 1; };
    int order = sign(turn);
    if (i < of_p.size() && j < of_q.size() && half(of_p[i]) != half(of_q[j]))
      order = half(of_q[j]) - half(of_p[i]);
    if (order >= 0) at = at + direction_of(of_p[i++]);
    if (order <= 0) at = at + direction_of(of_q[j++]);
  }
  return result;
}

Outcome law(const Sum& sum, const Summands& summands) {
  const Chain p = convex_hull(chains(summands.p)), q = convex_hull(chains(summands.q));
  const MinkowskiSum expected{{merged(p, q)}, {}, {}, {}};
  const std::string what = told_apart(sum(polygon(p), polygon(q)), expected);
  if (!what.empty()) return unless_broken("of the hulls, " + what);
  if (convex_hull(sum(summands.p, summands.q).outer) != expected.outer[0])
    return unless_broken("the hull of the sum is not the sum of the hulls");
  return {};
}

const Registered registered({
    .id = "law-convex",
    .sources = {{"grid", 8, 4},
                {"convex", 12, 2},
                {"components", 4, 1},
                {"holes", 4, 1},
                {"diamond-u", 1, 1}},
    .promises = {{"reflex vertices", 10}, {"parallel edges", 40}},
    .kills = {"edges-in-line-stay-apart"},
    .cases = 200,
    .check = of_each_engine(law),
    .of_engine = of_one(law),
});

}  // namespace

}  // namespace oplus
