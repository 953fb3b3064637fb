// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/shrinking.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <iterator>
#include <set>
#include <utility>

#include "reference/chains/frame.hpp"
#include "reference/chains/validity.hpp"
#include "reference/definitions/contract.hpp"

namespace oplus {

namespace {

using Accept = std::function<bool(const Summands&)>;
using Move = std::function<Rational(const Rational&)>;
using Change = std::function<void(Region&)>;

constexpr std::array<Region Summands::*, 2> both{&Summands::p, &Summands::q};
constexpr std::array<Rational Point::*, 2> axes{&Point::x, &Point::y};

Rational rounded_towards_zero(const Rational& value) {
  return mpz_class(value.get_num() / value.get_den());
}

/// The ways to make one coordinate simpler, the largest step first.
const std::vector<Move>& moves() {
  static const std::vector<Move> all{
      [](const Rational&) { return Rational(0); },
      [](const Rational& v) { return rounded_towards_zero(v / 16); },
      [](const Rational& v) { return rounded_towards_zero(v / 2); },
      [](const Rational& v) { return rounded_towards_zero(v); },
      [](const Rational& v) { return Rational(v - sign(v)); },
      // From a fraction to one of half the denominator, not to the integers at once.
      [](const Rational& v) {
        const mpz_class half = v.get_den() / 2;
        if (half == 0) return v;
        return Rational(rounded_towards_zero(v * half) / half);
      },
  };
  return all;
}

/// The value after each of these moves that changes it.
std::vector<Rational> simpler(const Rational& value) {
  std::vector<Rational> result;
  for (const Move& move : moves()) result.push_back(move(value));
  std::erase(result, value);
  return result;
}

std::vector<Chain*> chains_in(Region& region) {
  std::vector<Chain*> result;
  for (Component& component : region.components) {
    result.push_back(&component.outer);
    for (Chain& hole : component.holes) result.push_back(&hole);
  }
  return result;
}

template <typename Visit>
void for_each_point(Region& region, Visit visit) {
  for (Chain* chain : chains_in(region))
    for (Point& p : *chain) visit(p);
}

Change of_all_points(Move move) {
  return [move = std::move(move)](Region& region) {
    for_each_point(region, [&](Point& p) { p = {move(p.x), move(p.y)}; });
  };
}

std::set<Rational> values(Region region, Rational Point::*axis) {
  std::set<Rational> result;
  for_each_point(region, [&](Point& p) { result.insert(p.*axis); });
  return result;
}

void move_to_origin(Region& region) {
  if (vertex_count(region) == 0) return;
  region = translated(region,
                      {-*values(region, &Point::x).begin(), -*values(region, &Point::y).begin()});
}

void rank(Region& region) {
  for (const auto axis : axes) {
    const std::set<Rational> sorted = values(region, axis);
    for_each_point(region, [&](Point& p) {
      p.*axis = static_cast<unsigned long>(std::distance(sorted.begin(), sorted.find(p.*axis)));
    });
  }
}

bool is_valid(const Region& region) {
  const auto is_clockwise = [](const Chain& hole) { return sign(twice_area(hole)) < 0; };
  return std::ranges::all_of(region.components,
                             [&](const Component& c) {
                               return (c.outer.empty() || sign(twice_area(c.outer)) > 0) &&
                                      std::ranges::all_of(c.holes, is_clockwise);
                             }) &&
         !find_defect(framed(region, 1));
}

template <typename T>
void erase_at(std::vector<T>& all, std::size_t i, std::size_t count = 1) {
  const auto first = all.begin() + static_cast<std::ptrdiff_t>(i);
  all.erase(first, first + static_cast<std::ptrdiff_t>(count));
}

Chain rotated(Chain chain, std::size_t first) {
  std::rotate(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(first), chain.end());
  return chain;
}

std::vector<Change> fewer_components(const Region& region) {
  std::vector<Change> changes;
  const std::size_t count = region.components.size();
  for (std::size_t i = 0; count > 1 && i < count; ++i)
    changes.push_back([i](Region& r) { r.components = {Component(r.components[i])}; });
  for (std::size_t i = 0; count > 2 && i < count; ++i)
    changes.push_back([i](Region& r) { erase_at(r.components, i); });
  return changes;
}

std::vector<Change> fewer_holes(const Region& region) {
  std::vector<Change> changes;
  for (std::size_t c = 0; c < region.components.size(); ++c) {
    const std::size_t count = region.components[c].holes.size();
    if (count > 1) changes.push_back([c](Region& r) { r.components[c].holes.clear(); });
    for (std::size_t h = 0; h < count; ++h)
      changes.push_back([c, h](Region& r) { erase_at(r.components[c].holes, h); });
  }
  return changes;
}

/// Leaves out runs of vertices: halves of a chain, quarters, and so on down to one.
std::vector<Change> fewer_vertices(const Region& region) {
  std::vector<Change> changes;
  const std::vector<Chain> all = chains(region);
  for (std::size_t c = 0; c < all.size(); ++c) {
    const std::size_t length = all[c].size();
    for (std::size_t run = length / 2; run > 0; run /= 2) {
      if (length < run + 3) continue;
      for (std::size_t first = 0; first < length; first += run)
        changes.push_back([c, run, first](Region& r) {
          Chain& chain = *chains_in(r)[c];
          chain = rotated(chain, first);
          erase_at(chain, 0, run);
        });
    }
  }
  return changes;
}

/// Turns a hole into a dent of the outer chain, of one of its vertices or all but one: what needs
/// a reflex vertex needs no hole.
std::vector<Change> opened_holes(const Region& region) {
  std::vector<Change> changes;
  for (std::size_t c = 0; c < region.components.size(); ++c) {
    const auto& [outer, holes] = region.components[c];
    for (std::size_t h = 0; h < holes.size(); ++h) {
      for (const std::size_t depth : {std::size_t{1}, holes[h].size() - 1}) {
        for (std::size_t first = 0; first < holes[h].size(); ++first) {
          for (std::size_t edge = 1; edge <= outer.size(); ++edge)
            changes.push_back([=](Region& r) {
              Component& component = r.components[c];
              Chain dent = rotated(component.holes[h], first);
              dent.resize(depth);
              erase_at(component.holes, h);
              component.outer.insert(component.outer.begin() + static_cast<std::ptrdiff_t>(edge),
                                     dent.begin(), dent.end());
            });
        }
      }
    }
  }
  return changes;
}

/// For both regions at once: scaled to integers, by a common factor, rounded, each moved to the
/// origin. The first two change the sum only in scale.
std::vector<Change> simpler_together(const Summands& summands) {
  mpz_class denominators = 1;
  mpz_class numerators = 0;
  for (const auto which : both) {
    for (const auto axis : axes) {
      for (const Rational& v : values(summands.*which, axis)) {
        denominators = lcm(denominators, v.get_den());
        numerators = gcd(numerators, v.get_num());
      }
    }
  }
  std::vector<Change> changes;
  if (denominators > 1)
    changes.push_back(
        of_all_points([=](const Rational& v) -> Rational { return v * denominators; }));
  if (numerators > 1)
    changes.push_back(of_all_points([=](const Rational& v) -> Rational { return v / numerators; }));
  changes.push_back(move_to_origin);
  std::ranges::transform(moves(), std::back_inserter(changes), of_all_points);
  return changes;
}

/// One region: moved so that its corner, middle or a vertex becomes the origin, coordinates
/// replaced by their ranks, or all simplified in the same way.
std::vector<Change> simpler_region(const Region& region) {
  std::vector<Change> changes{move_to_origin};
  for (const Chain& chain : chains(region))
    for (const Point& p : chain) changes.push_back([p](Region& r) { r = translated(r, -p); });
  changes.push_back(rank);
  std::ranges::transform(moves(), std::back_inserter(changes), of_all_points);
  return changes;
}

/// All vertices with a coordinate in common, so that edges parallel to an axis stay that.
std::vector<Change> simpler_lines(const Region& region) {
  std::vector<Change> changes;
  for (const auto axis : axes) {
    for (const Rational& line : values(region, axis)) {
      for (const Rational& to : simpler(line))
        changes.push_back([=](Region& r) {
          for_each_point(r, [&](Point& p) {
            if (p.*axis == line) p.*axis = to;
          });
        });
    }
  }
  return changes;
}

std::vector<Change> simpler_points(const Region& region) {
  std::vector<Change> changes;
  const std::vector<Chain> all = chains(region);
  for (std::size_t c = 0; c < all.size(); ++c) {
    for (std::size_t v = 0; v < all[c].size(); ++v) {
      for (const auto axis : axes) {
        for (const Rational& to : simpler(all[c][v].*axis))
          changes.push_back([=](Region& r) { (*chains_in(r)[c])[v].*axis = to; });
      }
    }
  }
  return changes;
}

/// Makes the candidates one after the other until one is accepted, so that `shrink` need not make the
/// rest. Returns whether one was.
bool visit_candidates(const Summands& from, const Accept& accept) {
  const Size size = size_of(from);
  const auto offer = [&](const Change& change, std::initializer_list<Region Summands::*> changed) {
    Summands candidate = from;
    for (const auto which : changed) change(candidate.*which);
    return size_of(candidate) < size && is_valid(candidate.p) && is_valid(candidate.q) &&
           accept(candidate);
  };
  // Of either region, one after the other.
  const auto offer_each = [&](auto changes_of) {
    return std::ranges::any_of(both, [&](const auto which) {
      return std::ranges::any_of(changes_of(from.*which),
                                 [&](const Change& change) { return offer(change, {which}); });
    });
  };
  return offer_each(fewer_components) || offer_each(fewer_holes) || offer_each(fewer_vertices) ||
         offer_each(opened_holes) ||
         std::ranges::any_of(simpler_together(from),
                             [&](const Change& change) {
                               return offer(change, {&Summands::p, &Summands::q});
                             }) ||
         offer_each(simpler_region) || offer_each(simpler_lines) || offer_each(simpler_points);
}

}  // namespace

std::vector<Summands> smaller(const Summands& summands) {
  std::vector<Summands> all;
  const Accept collect = [&](const Summands& candidate) {
    if (std::find(all.begin(), all.end(), candidate) == all.end()) all.push_back(candidate);
    return false;
  };
  visit_candidates(summands, collect);
  return all;
}

Size size_of(const Summands& summands) {
  Size size;
  for (const Region* region : {&summands.p, &summands.q}) {
    size.vertices += vertex_count(*region);
    for (const Chain& chain : chains(*region)) {
      for (const Point& p : chain)
        size.coordinates += abs(p.x.get_num()) + p.x.get_den() + abs(p.y.get_num()) + p.y.get_den();
    }
  }
  return size;
}

Summands shrink(Summands summands, const std::function<bool(const Summands&)>& fails) {
  // Always checked: if the outcome changed from call to call, any pair could be the result.
  if (!fails(summands)) throw ContractViolation("shrink: the pair to start from does not fail");
  Summands next;
  const Accept accept = [&](const Summands& candidate) {
    if (!fails(candidate)) return false;
    next = candidate;
    return true;
  };
  while (visit_candidates(summands, accept)) summands = std::move(next);
  return summands;
}

}  // namespace oplus
