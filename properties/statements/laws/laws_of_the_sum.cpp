// SPDX-License-Identifier: GPL-3.0-or-later
// The laws that every engine's sums must obey, closed and open; the table at the end registers them.
#include <optional>

#include "checked/operations/image.hpp"
#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/laws/convex_hull.hpp"
#include "properties/statements/placements/overlay.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/validity.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

Outcome commutative(const Sum& sum, const Summands& summands) {
  const auto& [p, q] = summands;
  Outcome outcome;
  if (const auto found = difference(sum(p, q), sum(q, p)))
    outcome.fail(found->what + ", at " + to_string(found->witness), found->witness);
  return outcome;
}

Outcome associative(const Sum& sum, const Summands& summands) {
  const auto& [p, q] = summands;
  const Region pq = region_of(sum.closed(p, q));
  for (const Region& r : {polygon({{0, 0}, {1, 0}, {0, 2}}),
                          polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}), summands.q}) {
    const std::string what = difference_in_words(sum(pq, r), sum(p, region_of(sum.closed(q, r))));
    if (!what.empty()) return unless_broken(what);
  }
  return {};
}

/// Maps of P and of Q, and the one that the sum of the images must be the sum's image by.
struct Maps {
  std::string in_words;
  AffineMap of_p, of_q, of_sum;
};

/// The same map of both.
Maps linear_map(const std::string& in_words, const AffineMap& map) {
  return {in_words + ", ", map, map, map};
}

Law images(std::vector<Maps> all) {
  return [all = std::move(all)](const Sum& sum, const Summands& summands) {
    const auto& [p, q] = summands;
    const PlanarSet here = sum(p, q);
    for (const Maps& maps : all) {
      const std::string what = difference_in_words(image(maps.of_sum, here),
                                                   sum(image(maps.of_p, p), image(maps.of_q, q)));
      if (!what.empty()) return unless_broken(maps.in_words + what);
    }
    return Outcome();
  };
}

/// By small integers, by fractions, and by numbers whose squares overflow a double.
std::vector<Maps> translations() {
  const Rational far(mpz_class(1) << 600);
  const std::pair<Vector, Vector> all[] = {
      {{3, -5}, {0, 0}},
      {{Rational(1, 3), 0}, {Rational(-2, 7), Rational(5, 11)}},
      {{far, 1}, {-1, far}}};
  std::vector<Maps> maps;
  for (const auto& [s, t] : all) maps.push_back({"", {.by = s}, {.by = t}, {.by = s + t}});
  return maps;
}

std::vector<Maps> linear_maps() {
  return {linear_map("under a quarter turn", {0, -1, 1, 0}),
          linear_map("under a reflection in the y-axis", {-1, 0, 0, 1}),
          linear_map("under x and y exchanged", {0, 1, 1, 0}),
          linear_map("under a shear", {1, 2, 0, 1}),
          linear_map("under a map that stretches and turns", {3, -1, 1, 2})};
}

std::vector<Maps> scalings() {
  const Rational large(mpz_class(1) << 600);
  std::vector<Maps> maps;
  for (const Rational& factor : {Rational(-1), Rational(2, 3), large, Rational(1 / large)})
    maps.push_back(linear_map("scaled by " + factor.get_str(), scaled_by(factor)));
  return maps;
}

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

Outcome convex(const Sum& sum, const Summands& summands) {
  const Chain p = convex_hull(chains(summands.p)), q = convex_hull(chains(summands.q));
  const PlanarSet expected{{merged(p, q)}, {}, {}, {}};
  const std::string what = difference_in_words(sum(polygon(p), polygon(q)), expected);
  if (!what.empty()) return unless_broken("of the hulls, " + what);
  if (convex_hull(sum(summands.p, summands.q).outer) != expected.outer[0])
    return unless_broken("the hull of the sum is not the sum of the hulls");
  return {};
}

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

std::string broken_area(const Sum& sum, const Region& p, const Region& q) {
  const int compared = compare_with_bound(area(sum(p, q)), area(p), area(q));
  const bool equal = are_homothetic(p, q);
  if (equal ? compared == 0 : compared > 0) return "";
  return "the area is " + in_words(compared) + " (√|P| + √|Q|)², the summands are " +
         (equal ? "" : "not ") + "convex and homothetic";
}

Outcome area_of_the_sum(const Sum& sum, const Summands& summands) {
  const auto& [p, q] = summands;
  const Region similar_to_p = translated(image(scaled_by(Rational(2, 3)), p), {1, 5});
  std::string what = broken_area(sum, p, q);
  what = what.empty() ? broken_area(sum, p, similar_to_p) : "P and a smaller P: " + what;
  Outcome outcome = unless_broken(what);
  if (are_homothetic(p, similar_to_p)) ++outcome.counts["equal areas"];
  return outcome;
}

/// Pairs of regions, the smaller one first: P and its convex hull; the first component and P; that
/// component and the same without holes.
std::vector<std::pair<Region, Region>> nested(const Region& p) {
  const Region component{{p.components[0]}};
  const Region without_holes = polygon(p.components[0].outer);
  std::vector<std::pair<Region, Region>> pairs = {{p, polygon(convex_hull(chains(p)))}};
  if (component != p) pairs.emplace_back(component, p);
  if (without_holes != component) pairs.emplace_back(component, without_holes);
  return pairs;
}

Outcome not_monotone(const Sum& sum, const Region& smaller, const Region& larger, const Region& q) {
  for (const OverlaidPoint& x : overlaid({sum(smaller, q), sum(larger, q)})) {
    if (x.is_in(0, sum.is_open()) && !x.is_in(1, sum.is_open()))
      return Outcome().fail(to_string(x.point) + " is in the sum of the smaller region only",
                            x.point);
  }
  return {};
}

Outcome monotone(const Sum& sum, const Summands& summands) {
  const std::vector<std::pair<Region, Region>> pairs = nested(summands.p);
  Outcome outcome;
  for (const auto& [smaller, larger] : pairs) {
    outcome = not_monotone(sum, smaller, larger, summands.q);
    if (outcome.kind == Outcome::Kind::fails) break;
  }
  outcome.counts["nested regions"] += pairs.size();
  return outcome;
}

/// The two parts of a polygon cut along its first diagonal for which both parts are valid.
std::optional<std::vector<Region>> halves(const Chain& chain) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    for (std::size_t j = i + 2; j < chain.size(); ++j) {
      const auto first = chain.begin() + static_cast<std::ptrdiff_t>(i);
      const auto last = chain.begin() + static_cast<std::ptrdiff_t>(j);
      Chain one(first, last + 1);
      Chain other(last, chain.end());
      other.insert(other.end(), chain.begin(), first + 1);
      if (other.size() < 3 || sign(twice_area(one)) <= 0 || sign(twice_area(other)) <= 0) continue;
      std::vector<Region> both = {polygon(std::move(one)), polygon(std::move(other))};
      if (!find_defect(both[0]) && !find_defect(both[1])) return both;
    }
  }
  return std::nullopt;
}

/// At least two regions whose union is the region; empty if none are found.
std::optional<std::vector<Region>> parts(const Region& region) {
  if (region.components.size() > 1) {
    std::vector<Region> components;
    for (const Component& component : region.components) components.push_back({{component}});
    return components;
  }
  const Component& only = region.components[0];
  return only.holes.empty() ? halves(only.outer) : std::nullopt;
}

Outcome not_distributive(const Sum& sum, const Summands& summands,
                         const std::vector<Region>& parts) {
  std::vector<PlanarSet> sums = {sum(summands.p, summands.q)};
  for (const Region& part : parts) sums.push_back(sum(part, summands.q));
  for (const OverlaidPoint& x : overlaid(sums)) {
    const bool in_whole = x.is_in(0, sum.is_open());
    bool in_a_part = false;
    for (std::size_t i = 1; i < sums.size(); ++i)
      in_a_part = in_a_part || x.is_in(i, sum.is_open());
    if (in_whole == in_a_part) continue;
    return Outcome().fail(
        to_string(x.point) + " is in the sum of " +
            (in_whole ? "the union and of no part" : "a part and not of the union"),
        x.point);
  }
  return {};
}

Outcome distributive(const Sum& sum, const Summands& summands) {
  const std::optional<std::vector<Region>> of_p = parts(summands.p);
  if (!of_p)
    return {Outcome::Kind::discarded,
            "P has one component and holes, or is a polygon without such a diagonal",
            {}};
  Outcome outcome = not_distributive(sum, summands, *of_p);
  ++outcome
        .counts[summands.p.components.size() > 1 ? "unions of components" : "polygons cut in two"];
  return outcome;
}

/// P + x, where x is a point of the closed Q, must be in the closed sum.
Outcome contains_translates(const Sum& sum, const Region& p, const Region& q) {
  const PlanarSet whole = sum(p, q);
  for (const Chain& chain : chains(q)) {
    const PlanarSet part = canonical_sum(translated(p, chain[0]));
    for (const OverlaidPoint& at : overlaid({whole, part})) {
      if (at.is_in(1, false) && !at.is_in(0, false))
        return Outcome().fail("P + " + to_string(chain[0]) + " contains " + to_string(at.point) +
                                  ", the sum does not",
                              at.point);
    }
  }
  return {};
}

/// The value at zero of the quadratic through (1, f1), (2, f2), (3, f3); empty if (4, f4) is not on
/// it.
std::optional<Rational> value_at_zero(const Rational& f1, const Rational& f2, const Rational& f3,
                                      const Rational& f4) {
  if (f4 - 3 * f3 + 3 * f2 - f1 != 0) return std::nullopt;
  return Rational(3 * f1 - 3 * f2 + f3);
}

std::string shrinks_to_p(const Sum& sum, const Region& p, const Region& q) {
  const Rational tiny = 1 / Rational(mpz_class(1) << 300);
  const auto area_with = [&](int times) {
    return area(sum(p, image(scaled_by(Rational(times * tiny)), q)));
  };
  const std::optional<Rational> limit =
      value_at_zero(area_with(1), area_with(2), area_with(3), area_with(4));
  if (!limit) return "the area of P ⊕ λQ is not a quadratic function of λ for small λ";
  if (*limit != area(p))
    return "the area of P ⊕ λQ tends to " + limit->get_str() + ", P's is " + area(p).get_str();
  return "";
}

Outcome of_a_point(const Sum& sum, const Summands& summands) {
  const auto& [p, q] = summands;
  if (!sum.is_open()) {
    const Outcome outcome = contains_translates(sum, p, q);
    if (outcome.kind == Outcome::Kind::fails) return outcome;
  }
  return unless_broken(shrinks_to_p(sum, p, q));
}

/// The sources that three laws share.
std::vector<Source> for_maps() {
  return {{"grid", 7, 4},    {"tight", 4, 2}, {"holes", 5, 2},    {"components", 4, 2},
          {"islands", 1, 1}, {"fork", 2, 1},  {"diamond-u", 1, 1}};
}

Registered law(std::string id, const Law& check, std::size_t cases, std::vector<Source> sources,
               std::vector<Promise> promises, std::vector<std::string> kills) {
  return Registered({.id = std::move(id),
                     .sources = std::move(sources),
                     .promises = std::move(promises),
                     .kills = std::move(kills),
                     .cases = cases,
                     .check = of_each_engine(check),
                     .of_engine = for_one_engine(check)});
}

const std::vector<Promise> with_holes = {
    {"holes", 15}, {"several components", 5}, {"parallel edges", 40}};

const Registered registered[] = {
    law("law-commutative", commutative, 250,
        {{"grid", 8, 4},
         {"tight", 6, 3},
         {"holes", 5, 2},
         {"components", 5, 2},
         {"islands", 2, 1},
         {"fork", 3, 1},
         {"diamond-u", 1, 1},
         {"simple", 8, 1}},
        {{"holes", 15},
         {"several components", 5},
         {"reflex vertices", 10},
         {"parallel edges", 40},
         {"overlapping segments", 5}},
        {"candidates-need-no-hole-test", "holes-of-q-are-left-out"}),
    law("law-associative", associative, 80,
        {{"grid", 5, 4},
         {"tight", 2, 2},
         {"holes", 4, 2},
         {"components", 3, 2},
         {"fork", 1, 1},
         {"diamond-u", 1, 1}},
        with_holes, {"candidates-need-no-hole-test"}),
    law("law-translation", images(translations()), 80, for_maps(), with_holes,
        {"coordinates-stay-scaled"}),
    law("law-linear", images(linear_maps()), 80, for_maps(), with_holes,
        {"left-and-right-are-one-direction", "vertical-edges-never-dangle"}),
    law("law-scaling", images(scalings()), 60, for_maps(), with_holes, {"coordinates-stay-scaled"}),
    law("law-convex", convex, 200,
        {{"grid", 8, 4},
         {"convex", 12, 2},
         {"components", 4, 1},
         {"holes", 4, 1},
         {"diamond-u", 1, 1}},
        {{"reflex vertices", 10}, {"parallel edges", 40}}, {"edges-in-line-stay-apart"}),
    law("law-area", area_of_the_sum, 100,
        {{"grid", 6, 4},
         {"convex", 8, 2},
         {"holes", 4, 1},
         {"components", 4, 2},
         {"islands", 1, 1},
         {"tight", 3, 1}},
        {{"holes", 5}, {"several components", 5}, {"parallel edges", 40}},
        {"area-is-of-the-first-chain"}),
    law("law-monotone", monotone, 60,
        {{"holes", 4, 3}, {"components", 4, 3}, {"grid", 6, 2}, {"islands", 1, 1}, {"tight", 3, 1}},
        {{"holes", 15}, {"several components", 15}, {"parallel edges", 40}},
        {"candidates-need-no-hole-test"}),
    law("law-union", distributive, 50,
        {{"components", 4, 4}, {"grid", 6, 3}, {"islands", 1, 1}, {"tight", 3, 1}},
        {{"several components", 15}, {"reflex vertices", 10}, {"parallel edges", 40}},
        {"candidates-need-no-hole-test", "dangling-edges-run-one-way"}),
    law("law-point", of_a_point, 60,
        {{"grid", 6, 4}, {"holes", 4, 2}, {"components", 4, 2}, {"tight", 2, 1}}, with_holes,
        {"area-is-of-the-first-chain"}),
};

}  // namespace

}  // namespace oplus
