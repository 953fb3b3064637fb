// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "properties/runner/mixture.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter4/points_in_faces.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/tangent_count.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// So many of all, from beginning to end.
template <typename T>
std::vector<T> some_of(const std::vector<T>& all, std::size_t most) {
  const std::size_t n = std::min(all.size(), most);
  std::vector<T> result;
  for (std::size_t k = 0; k < n; ++k) result.push_back(all[k * all.size() / n]);
  return result;
}

/// A chain with neighbours exchanged: it may cross itself, or go round clockwise.
Chain entangled(Chain chain) {
  for (std::size_t i = 1; i + 1 < chain.size(); i += 3) std::swap(chain[i], chain[i + 1]);
  return chain;
}

Region entangled(Region region) {
  for (Component& component : region.components) {
    component.outer = entangled(component.outer);
    for (Chain& hole : component.holes) hole = entangled(hole);
  }
  return region;
}

void expect(const Summands& pair, Outcome& outcome) {
  const std::vector<Segment> all = segments(convolution(pair.p, pair.q));
  std::vector<Point> points = some_of(points_in_faces(all, {}), 12);
  for (const Segment& s : some_of(all, 6)) {
    points.push_back(s.source);
    points.push_back(midpoint(s.source, s.target));
  }
  std::vector<Vector> directions{{1, 0}, {-1, 0}, {3, -7}};
  for (const Region* const summand : {&pair.p, &pair.q})
    for (const Segment& e : some_of(edges(*summand), 2)) {
      directions.push_back(direction_of(e));
      directions.push_back(-direction_of(e));
    }
  for (const Point& x : points) {
    const int winding = winding_number(x, all);
    ++outcome.counts["points"];
    if (winding != 0) ++outcome.counts["points with a winding number other than zero"];
    for (const Vector& d : directions) {
      const int count = tangent_count(x, pair.p, pair.q, d);
      if (count == winding) continue;
      outcome.fail("the winding number is " + std::to_string(winding) + ", and " +
                       std::to_string(count) + " corners have the tangent direction " +
                       to_string(Point{d.x, d.y}),
                   x);
      return;
    }
  }
}

Outcome check(const Summands& summands) {
  Outcome outcome;
  for (const Summands& pair : {summands, Summands{entangled(summands.p), summands.q},
                               Summands{entangled(summands.p), entangled(summands.q)}})
    if (outcome.kind == Outcome::Kind::holds) expect(pair, outcome);
  return outcome;
}

const Registered registered({
    .id = "fact-tangent-count",
    .title = "Winding numbers of the convolution, corner by corner of the intersection",
    .statement =
        "For closed chains P and Q, which may cross themselves, every point x and every direction d: the "
        "winding number of x with respect to the convolution is the sum of three sums. First, over the "
        "vertices p of P whose tangent set has d, the winding number of x - p with respect to Q. Second, "
        "over the vertices q of Q whose tangent set has -d, that of x - q with respect to P. Third, over "
        "all pairs of an edge e of P and an edge f of Q, the winding number of x with respect to the "
        "boundary of e ⊕ f, times [e < f] - [e < d] + [f < -d] - [d < -d], where [u < v] is 1 if u comes "
        "before v by angle, else 0. x may be on the convolution, if all winding numbers are counted on "
        "the same ray. For regions, all terms are sums over pairs of chains. The same holds for any "
        "direction in place of -d; with -d, no term is negative if winding numbers of P and Q are not.",
    .why =
        "CCW(d, a, b) is [a < d] - [b < d] + [b < a] for three directions of which no two are equal. So "
        "whether an edge e is in the tangent set of q is whether -d is, plus the weight of e and the edge "
        "that leaves q, less that of e and the edge that enters q; for edges of Q the same. The winding "
        "number is a sum of such terms times crossings of a ray, and summation by parts moves the "
        "differences from the weights to the crossings, where they make up the boundary of e ⊕ f. The "
        "weight has the sign of the skew product of e and f or is 0, and so has the winding number of that "
        "boundary.",
    .hypotheses = {"P and Q consist of closed chains; no two vertices in a row are equal",
                   "d is not zero"},
    .rests_on = {},
    .sources = small_mixture(),
    .promises = promises_of_mixture(),
    .kills = {"crossings-count-with-a-sign", "tie-rule-depends-on-who-asks",
              "tangent-set-without-ties", "reflex-turns-clockwise", "ray-counts-both-ends"},
    .cases = 150,
    .check = check,
});

}  // namespace

}  // namespace oplus
