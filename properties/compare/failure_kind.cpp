// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/failure_kind.hpp"

#include <algorithm>
#include <vector>

#include "checked/verify/closeness.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/common_denominator.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/quoting.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// What is wrong with the components or holes of a sum, by which of them have interior points in common
/// with which of the right sum's; or "".
std::string lost_or_found(const std::vector<Region>& right, const std::vector<Region>& given,
                          const std::string& one, const std::string& many) {
  std::vector<std::size_t> of_right(right.size(), 0), of_given(given.size(), 0);
  for (std::size_t r = 0; r < right.size(); ++r) {
    for (std::size_t g = 0; g < given.size(); ++g) {
      if (!interiors_meet(right[r], given[g])) continue;
      ++of_right[r];
      ++of_given[g];
    }
  }
  const auto is_several = [](std::size_t meets) { return meets > 1; };
  if (std::ranges::count(of_right, 0U) > 0) return one + " lost";
  if (std::ranges::count(of_given, 0U) > 0) return one + " invented";
  if (std::ranges::any_of(of_given, is_several)) return many + " joined";
  return std::ranges::any_of(of_right, is_several) ? one + " split" : "";
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

std::string lost_or_found(const PlanarSet& right, const PlanarSet& given) {
  const Region a = region_of(right), b = region_of(given);
  const std::string what = lost_or_found(components(a), components(b), "component", "components");
  return what.empty() ? lost_or_found(holes(a), holes(b), "hole", "holes") : what;
}

/// How far rounding may move coordinates: by at most `most`, or by less than `step`.
struct Rounding {
  Rational most;
  Rational step;

  Rounding(const PlanarSet& right, const PlanarSet& given) {
    for (const Segment& edge : edges(right))
      most = std::max({most, Rational(abs(edge.source.x)), Rational(abs(edge.source.y))});
    most /= 1000000;
    mpz_class denominators = 1;
    for (const Segment& edge : edges(given)) add_denominators(denominators, edge.source);
    step = Rational(1, denominators);
  }

  bool may_move(const Rational& from, const Rational& to) const {
    const Rational distance = abs(to - from);
    return distance <= most || distance < step;
  }
  bool may_move(const Point& from, const Point& to) const {
    return may_move(from.x, to.x) && may_move(from.y, to.y);
  }
  /// Without vertices that rounding may have added or lost.
  Chain corners(const Chain& chain) const {
    if (chain.empty()) return {};
    Chain kept = {chain[0]};
    for (std::size_t i = 1; i < chain.size(); ++i)
      if (!is_within({{chain[i], chain[i]}},
                     std::vector<Segment>{{kept.back(), chain[next(i, chain.size())]}},
                     most * most))
        kept.push_back(chain[i]);
    return kept;
  }
  bool may_move(const Chain& from, const Chain& to) const {
    const Chain a = corners(from);
    Chain b = corners(to);
    if (a.size() != b.size()) return false;
    if (a.empty()) return true;  // missing outer chains
    const auto is_paired = [&] {
      return std::ranges::equal(a, b,
                                [&](const Point& p, const Point& q) { return may_move(p, q); });
    };
    for (std::size_t i = 0; i < b.size(); ++i, std::rotate(b.begin(), b.begin() + 1, b.end()))
      if (is_paired()) return true;
    return false;
  }
  bool may_move(const Component& from, const Component& to) const {
    return from.holes.size() == to.holes.size() && may_move(from.outer, to.outer) &&
           std::ranges::all_of(from.holes, [&](const Chain& hole) {
             return std::ranges::any_of(to.holes,
                                        [&](const Chain& other) { return may_move(hole, other); });
           });
  }
};

/// Requires: components and holes correspond, see lost_or_found().
bool is_rounded(const PlanarSet& right, const PlanarSet& given) {
  const Rounding rounding(right, given);
  const Region a = region_of(right), b = region_of(given);
  return std::ranges::all_of(a.components, [&](const Component& from) {
    return std::ranges::any_of(b.components,
                               [&](const Component& to) { return rounding.may_move(from, to); });
  });
}

/// Of two regularized sums.
std::optional<Failure> regular_failure(const PlanarSet& right, const PlanarSet& given) {
  const auto differs = difference(right, given);
  if (!differs || differs->in_a == differs->in_b) return std::nullopt;
  if (const std::string kind = lost_or_found(right, given); !kind.empty()) return Failure{kind};
  if (is_rounded(right, given)) {
    return Failure{.kind = "rounded",
                   .squared_distance = distance(edges(right), edges(given)).least_squared};
  }
  const Rational more = area(given) - area(right);
  return Failure{sign(more) < 0   ? "area smaller"
                 : sign(more) > 0 ? "area larger"
                                  : "other shape of equal area"};
}

std::string low_dimensional_kind(const PlanarSet& right, const PlanarSet& given) {
  const auto has_all = [](const auto& all, const auto& some) {
    return std::ranges::includes(all, some);
  };
  if (!has_all(given.dangling_edges, right.dangling_edges)) return "dangling edge lost";
  if (!has_all(right.dangling_edges, given.dangling_edges)) return "dangling edge invented";
  if (!has_all(given.isolated_vertices, right.isolated_vertices)) return "isolated vertex lost";
  if (!has_all(right.isolated_vertices, given.isolated_vertices)) return "isolated vertex invented";
  return "not canonical";
}

/// A sum with sorted lists, which an engine may leave in any order.
PlanarSet with_sorted_features(PlanarSet sum) {
  std::ranges::sort(sum.dangling_edges);
  std::ranges::sort(sum.isolated_vertices);
  return sum;
}

}  // namespace

Failure failure_without_sum(const EngineFailure& answer) {
  const bool has_site = answer.kind() == EngineFailure::Kind::crashed ||
                        answer.kind() == EngineFailure::Kind::unreadable;
  const std::string site = has_site ? one_line(answer.site()) : "";
  return {name(answer.kind()) + (site.empty() ? "" : ": " + site), one_line(answer.what())};
}

std::optional<Failure> malformed(const PlanarSet& sum) {
  const auto not_simple = [](const std::string& what) { return Failure{"not simple", what}; };
  std::vector<Segment> all;
  for (const std::vector<Chain>* chains : {&sum.outer, &sum.holes}) {
    for (const Chain& chain : *chains) {
      if (chain.size() < 3)
        return not_simple("a chain has " + counted(chain.size(), "vertex", "vertices"));
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
        return Failure{"not simple", overlap(all[i], all[j]) ? "edges overlap" : "edges cross",
                       intersection(all[i], all[j]).at(0)};
      }
    }
  }
  for (const Chain& chain : sum.outer) {
    if (sign(twice_area(chain)) < 0)
      return Failure{"orientation", "the outer chain at " + to_string(chain[0]) + " is clockwise"};
  }
  for (const Chain& hole : sum.holes) {
    if (sign(twice_area(hole)) > 0)
      return Failure{"orientation", "the hole at " + to_string(hole[0]) + " is counterclockwise"};
    // Edges do not cross and do not overlap, so the middle of one edge is on no other chain, and decides
    // for the whole hole.
    const Point middle = midpoint(hole[0], hole[1]);
    if (!sum.is_unbounded && std::ranges::none_of(sum.outer, [&](const Chain& outer) {
          return winding_number(middle, edges(outer)) > 0;
        }))
      return not_simple("the hole at " + to_string(hole[0]) + " is in no outer chain");
  }
  return std::nullopt;
}

std::optional<Failure> failure(const PlanarSet& right, const PlanarSet& given) {
  if (given == right) return std::nullopt;
  if (std::optional<Failure> found = malformed(given)) return found;
  std::optional<Failure> found = regular_failure(regularized(right), regularized(given));
  if (!found)
    found = Failure{low_dimensional_kind(with_sorted_features(right), with_sorted_features(given))};
  if (const auto differs = difference(right, given)) {
    found->what = differs->what;
    found->witness = differs->witness;
  }
  return found;
}

}  // namespace oplus
