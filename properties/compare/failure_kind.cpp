// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/failure_kind.hpp"

#include <algorithm>
#include <vector>

#include "checked/verify/closeness.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/quoting.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

Failure named(std::string kind, std::string what) {
  return {std::move(kind), std::move(what), std::nullopt, std::nullopt};
}

/// How the areas of two sums, such as their holes, correspond: which of them meet.
struct Correspondence {
  bool lost = false;
  bool invented = false;
  bool joined = false;
  bool split = false;
};

Correspondence correspondence(const std::vector<Region>& right, const std::vector<Region>& given) {
  std::vector<std::size_t> met(given.size(), 0);
  Correspondence result;
  for (const Region& r : right) {
    std::size_t meets = 0;
    for (std::size_t g = 0; g < given.size(); ++g) {
      if (!interiors_meet(r, given[g])) continue;
      ++meets;
      ++met[g];
    }
    result.lost = result.lost || meets == 0;
    result.split = result.split || meets > 1;
  }
  for (const std::size_t count : met) {
    result.invented = result.invented || count == 0;
    result.joined = result.joined || count > 1;
  }
  return result;
}

/// The name of what is wrong, or nothing.
std::string in_words(const Correspondence& found, const std::string& one, const std::string& many) {
  if (found.lost) return one + " lost";
  if (found.invented) return one + " invented";
  if (found.joined) return many + " joined";
  return found.split ? one + " split" : "";
}

std::vector<Region> components(const Region& region) {
  std::vector<Region> result;
  for (const Component& component : region.components) result.push_back({{component}});
  return result;
}

std::vector<Region> holes(const Region& region) {
  std::vector<Region> result;
  for (const Component& component : region.components) {
    for (const Chain& hole : component.holes)
      result.push_back(polygon({hole.rbegin(), hole.rend()}));
  }
  return result;
}

std::string lost_or_found(const MinkowskiSum& right, const MinkowskiSum& given) {
  const Region a = region_of(right), b = region_of(given);
  const std::string what =
      in_words(correspondence(components(a), components(b)), "component", "components");
  return what.empty() ? in_words(correspondence(holes(a), holes(b)), "hole", "holes") : what;
}

/// The step of the grid that all coordinates are on.
Rational step_of_grid(const MinkowskiSum& sum) {
  mpz_class denominators = 1;
  for (const Segment& edge : edges(sum)) {
    denominators = lcm(denominators, edge.source.x.get_den());
    denominators = lcm(denominators, edge.source.y.get_den());
  }
  return Rational(1, denominators);
}

Rational extent(const MinkowskiSum& sum) {
  std::vector<Rational> x, y;
  for (const Segment& edge : edges(sum)) {
    x.push_back(edge.source.x);
    y.push_back(edge.source.y);
  }
  if (x.empty()) return 0;
  const auto [low_x, high_x] = std::minmax_element(x.begin(), x.end());
  const auto [low_y, high_y] = std::minmax_element(y.begin(), y.end());
  return std::max(Rational(*high_x - *low_x), Rational(*high_y - *low_y));
}

MinkowskiSum regularized(MinkowskiSum sum) {
  sum.dangling_edges.clear();
  sum.isolated_vertices.clear();
  return sum;
}

std::vector<Point> vertices(const MinkowskiSum& sum) {
  std::vector<Point> all;
  for (const Segment& edge : edges(sum)) all.push_back(edge.source);
  std::sort(all.begin(), all.end());
  return all;
}

/// Whether the answer's vertices are the right ones but for rounding to the grid they are on: what is
/// on the grid has not moved, and nothing has by a step.
bool is_rounded(const MinkowskiSum& right, const MinkowskiSum& given) {
  const Rational millionth = extent(right) / 1000000, step = step_of_grid(given);
  const std::vector<Segment> of_right = edges(right), of_given = edges(given);
  const auto are_within = [&](const Rational& distance) {
    const Rational squared = distance * distance;
    return is_within(of_right, of_given, squared) && is_within(of_given, of_right, squared);
  };
  if (are_within(millionth)) return true;
  if (!are_within(step)) return false;
  const std::vector<Point> kept = vertices(given);
  const auto on_grid = [&](const Rational& v) { return Rational(v / step).get_den() == 1; };
  const std::vector<Point> all = vertices(right);
  return std::all_of(all.begin(), all.end(), [&](const Point& p) {
    return !on_grid(p.x) || !on_grid(p.y) || std::binary_search(kept.begin(), kept.end(), p);
  });
}

/// Of two regularized sums.
std::optional<Failure> regular_failure(const MinkowskiSum& right, const MinkowskiSum& given) {
  const auto differs = difference(right, given);
  if (!differs || differs->in_a == differs->in_b) return std::nullopt;
  if (const std::string kind = lost_or_found(right, given); !kind.empty()) return named(kind, "");
  if (is_rounded(right, given)) {
    Failure rounded = named("rounded", "");
    rounded.squared_distance = distance(edges(right), edges(given)).least_squared;
    return rounded;
  }
  const Rational more = area(given) - area(right);
  return named(sign(more) < 0   ? "area smaller"
               : sign(more) > 0 ? "area larger"
                                : "other shape of equal area",
               "");
}

std::string low_dimensional_kind(const MinkowskiSum& right, const MinkowskiSum& given) {
  const auto has_all = [](const auto& all, const auto& some) {
    return std::includes(all.begin(), all.end(), some.begin(), some.end());
  };
  if (!has_all(given.dangling_edges, right.dangling_edges)) return "dangling edge lost";
  if (!has_all(right.dangling_edges, given.dangling_edges)) return "dangling edge invented";
  if (!has_all(given.isolated_vertices, right.isolated_vertices)) return "isolated vertex lost";
  if (!has_all(right.isolated_vertices, given.isolated_vertices)) return "isolated vertex invented";
  return "not canonical";
}

/// A sum with the lists sorted, which others may leave in any order.
MinkowskiSum with_sorted_features(MinkowskiSum sum) {
  std::sort(sum.dangling_edges.begin(), sum.dangling_edges.end());
  std::sort(sum.isolated_vertices.begin(), sum.isolated_vertices.end());
  return sum;
}

}  // namespace

Failure failure_without_sum(const NoSum& answer) {
  const bool has_site =
      answer.kind() == NoSum::Kind::crashed || answer.kind() == NoSum::Kind::unreadable;
  const std::string site = has_site ? one_line(answer.site()) : "";
  return named(name(answer.kind()) + (site.empty() ? "" : ": " + site), one_line(answer.what()));
}

std::optional<Failure> malformed(const MinkowskiSum& sum) {
  const auto not_simple = [](const std::string& what) { return named("not simple", what); };
  std::vector<Segment> all;
  for (const std::vector<Chain>* chains : {&sum.outer, &sum.holes}) {
    for (const Chain& chain : *chains) {
      if (chain.size() < 3)
        return not_simple("a chain has " + std::to_string(chain.size()) + " vertices");
      if (sign(twice_area(chain)) == 0) return not_simple("a chain encloses no area");
      for (const Segment& edge : edges(chain)) {
        if (edge.source == edge.target)
          return not_simple("an edge at " + to_string(edge.source) + " has no length");
        all.push_back(edge);
      }
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (cross_properly(all[i], all[j]) || overlap(all[i], all[j])) {
        Failure crossing =
            not_simple(std::string("edges ") + (overlap(all[i], all[j]) ? "overlap" : "cross"));
        crossing.witness = intersection(all[i], all[j]).at(0);
        return crossing;
      }
    }
  }
  for (const Chain& chain : sum.outer) {
    if (sign(twice_area(chain)) < 0)
      return named("orientation", "the outer chain at " + to_string(chain[0]) + " is clockwise");
  }
  for (const Chain& hole : sum.holes) {
    if (sign(twice_area(hole)) > 0)
      return named("orientation", "the hole at " + to_string(hole[0]) + " is counterclockwise");
    // Edges do not cross, so the middle of one says it for all; where chains touch along nothing but
    // points it is on no other chain.
    const Point middle = midpoint(hole[0], hole[1]);
    if (std::none_of(sum.outer.begin(), sum.outer.end(),
                     [&](const Chain& outer) { return winding_number(middle, edges(outer)) > 0; }))
      return not_simple("the hole at " + to_string(hole[0]) + " is in no outer chain");
  }
  return std::nullopt;
}

std::optional<Failure> failure(const MinkowskiSum& right, const MinkowskiSum& given) {
  if (given == right) return std::nullopt;
  if (std::optional<Failure> found = malformed(given)) return found;
  std::optional<Failure> found = regular_failure(regularized(right), regularized(given));
  if (!found)
    found =
        named(low_dimensional_kind(with_sorted_features(right), with_sorted_features(given)), "");
  if (const auto differs = difference(right, given)) {
    found->what = differs->what;
    found->witness = differs->witness;
  }
  return found;
}

}  // namespace oplus
