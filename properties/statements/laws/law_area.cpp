// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/operations/image.hpp"
#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/laws/convex_hull.hpp"

namespace oplus {

namespace {

/// Compares |S| with (√|P| + √|Q|)² without roots: the square of |S| - |P| - |Q| with 4|P||Q|.
int compare_with_bound(const Rational& of_sum, const Rational& of_p, const Rational& of_q) {
  const Rational excess = of_sum - of_p - of_q;
  if (sign(excess) < 0) return -1;
  return sign(Rational(excess * excess - 4 * of_p * of_q));
}

std::string in_words(int compared) {
  return compared < 0 ? "less than" : compared > 0 ? "more than" : "equal to";
}

/// Whether one is the other scaled by a positive factor and translated, both convex.
bool are_homothetic(const Region& p, const Region& q) {
  if (!is_convex(p) || !is_convex(q)) return false;
  const Chain of_p = convex_hull(chains(p)), of_q = convex_hull(chains(q));
  if (of_p.size() != of_q.size()) return false;
  // Both start at their smallest vertex; all edges must have the ratio of the first ones.
  const Vector first_p = of_p[1] - of_p[0], first_q = of_q[1] - of_q[0];
  const Rational factor =
      first_p.x != 0 ? Rational(first_q.x / first_p.x) : Rational(first_q.y / first_p.y);
  if (sign(factor) <= 0) return false;
  for (std::size_t i = 0; i < of_p.size(); ++i)
    if (of_q[i] - of_q[0] != factor * (of_p[i] - of_p[0])) return false;
  return true;
}

std::string broken(const Sum& sum, const Region& p, const Region& q) {
  const int compared = compare_with_bound(area(sum(p, q)), area(p), area(q));
  const bool equal = are_homothetic(p, q);
  if (equal ? compared == 0 : compared > 0) return "";
  return "the area is " + in_words(compared) + " (√|P| + √|Q|)², the summands are " +
         (equal ? "" : "not ") + "convex and homothetic";
}

Outcome law(const Sum& sum, const Summands& summands) {
  const auto& [p, q] = summands;
  const Region similar_to_p = translated(image(scaling(Rational(2, 3)), p), {1, 5});
  std::string what = broken(sum, p, q);
  what = what.empty() ? broken(sum, p, similar_to_p) : "P and a smaller P: " + what;
  Outcome outcome = unless_broken(what);
  if (are_homothetic(p, similar_to_p)) ++outcome.counts["equal areas"];
  return outcome;
}

const Registered registered({
    .id = "law-area",
    .sources = {{"grid", 6, 4},
                {"convex", 8, 2},
                {"holes", 4, 1},
                {"components", 4, 2},
                {"islands", 1, 1},
                {"tight", 3, 1}},
    .promises = {{"holes", 5}, {"several components", 5}, {"parallel edges", 40}},
    .kills = {"area-is-of-the-first-chain"},
    .cases = 100,
    .check = of_each_engine(law),
    .of_engine = of_one(law),
});

}  // namespace

}  // namespace oplus
