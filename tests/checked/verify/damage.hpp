// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "checked/verify/verify.hpp"
#include "reference/definitions/claimed_sum.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/definitions/ray.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {

/// A way to spoil a sum, and the reasons of which one must be given.
struct Damage {
  std::string name;
  std::set<ReasonKind> right_reasons;
  /// Damages what is given of a sum. Changes nothing where there is nothing to be damaged in this way.
  std::function<void(ClaimedSum& given, const PlanarSet& sum)> apply;
};

/// Whether a segment meets an edge or a feature of a sum.
inline bool meets(const Segment& s, const PlanarSet& sum) {
  const std::vector<Segment> all = edges(sum);
  return std::any_of(all.begin(), all.end(),
                     [&](const Segment& e) { return !intersection(s, e).empty(); }) ||
         std::any_of(sum.isolated_vertices.begin(), sum.isolated_vertices.end(),
                     [&](const Point& p) { return lies_on(p, s); });
}

/// A counterclockwise triangle that meets nothing of a sum, to the left of a segment of its boundary,
/// near the middle.
inline Chain triangle_beside(const Segment& edge, const PlanarSet& sum) {
  std::vector<Segment> around = edges(sum);
  std::vector<Point> ends;
  for (const Segment& e : around) {
    ends.push_back(e.source);
    ends.push_back(e.target);
  }
  for (const Point& p : sum.isolated_vertices) around.push_back({p, p});
  const Segment piece = cut(edge, ends)[0];
  const Vector along = direction_of(piece);
  const Point centre =
      point_beside(midpoint(piece.source, piece.target), {-along.y, along.x}, around);
  for (Rational size = 1;; size /= 2) {
    const Chain triangle = {{centre.x - size, centre.y - size},
                            {centre.x + size, centre.y - size / 3},
                            {centre.x + size / 5, centre.y + size}};
    const std::vector<Segment> sides = edges(triangle);
    if (std::none_of(sides.begin(), sides.end(), [&](const Segment& s) { return meets(s, sum); }) &&
        std::none_of(around.begin(), around.end(), [&](const Segment& e) {
          return locate(e.source, polygon(triangle)) != Location::outside;
        }))
      return triangle;
  }
}

/// The component whose outer chain is the smallest around the place, to put a hole into.
inline Component* component_around(Region& region, const Point& place) {
  Component* best = nullptr;
  for (Component& c : region.components)
    if (locate(place, polygon(c.outer)) == Location::inside &&
        (best == nullptr || twice_area(c.outer) < twice_area(best->outer)))
      best = &c;
  return best;
}

/// A narrow bridge between two edges of a sum that see each other: its side from the first to the
/// second, then that back; empty where they do not.
inline std::optional<Chain> bridge(const Segment& a, const Segment& b, const PlanarSet& sum) {
  const auto at = [](const Segment& s, const Rational& t) {
    return s.source + t * direction_of(s);
  };
  const Rational before(31, 64), after(33, 64);
  const Segment there{at(a, before), at(b, after)}, back{at(b, before), at(a, after)};
  const auto is_free = [&](const Segment& s) {
    // It leaves its edges at once, and meets nothing else.
    const Vector little = Rational(1, 1000) * direction_of(s);
    return !meets({s.source + little, s.target - little}, sum) &&
           locate(midpoint(s.source, s.target), sum) == Location::outside;
  };
  const Chain corners = {there.source, there.target, back.source, back.target};
  if (cross_properly(there, back) || !is_free(there) || !is_free(back) ||
      sign(twice_area(corners)) <= 0)
    return std::nullopt;
  for (const Segment& e : edges(sum))
    if (locate(e.source, polygon(corners)) != Location::outside) return std::nullopt;
  return corners;
}

/// Makes two components one, by the first bridge that is found.
inline void join_components(ClaimedSum& given, const PlanarSet& sum) {
  std::vector<Component>& components = given.region.components;
  for (std::size_t c = 1; c < components.size(); ++c) {
    Chain& a = components[0].outer;
    Chain& b = components[c].outer;
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < b.size(); ++j) {
        const auto sides = bridge(edges(a)[i], edges(b)[j], sum);
        if (!sides) continue;
        std::rotate(b.begin(), b.begin() + static_cast<std::ptrdiff_t>(next(j, b.size())), b.end());
        b.insert(b.begin(), sides->begin(), sides->begin() + 2);
        b.insert(b.end(), sides->begin() + 2, sides->end());
        a.insert(a.begin() + static_cast<std::ptrdiff_t>(i + 1), b.begin(), b.end());
        components[0].holes.insert(components[0].holes.end(), components[c].holes.begin(),
                                   components[c].holes.end());
        components.erase(components.begin() + static_cast<std::ptrdiff_t>(c));
        return;
      }
    }
  }
}

inline Component& first_with_holes(Region& region) {
  return *std::find_if(region.components.begin(), region.components.end(),
                       [](const Component& c) { return !c.holes.empty(); });
}

inline Chain& first_chain(ClaimedSum& given) { return given.region.components.front().outer; }
inline Segment first_edge(const Chain& chain) { return {chain[0], chain[1]}; }

inline bool has_hole(const PlanarSet& sum) { return !sum.holes.empty(); }

/// Not one with a component in it, that would stay.
inline bool has_empty_hole(const PlanarSet& sum) { return has_hole(sum) && sum.outer.size() == 1; }

inline bool has_features(const PlanarSet& sum) {
  return !sum.dangling_edges.empty() || !sum.isolated_vertices.empty();
}

inline std::vector<Damage> damages() {
  using K = ReasonKind;
  using Sum = const PlanarSet&;
  std::vector<Damage> all;
  const auto damage = [&](std::string name, std::set<ReasonKind> right_reasons, auto apply) {
    all.push_back({std::move(name), std::move(right_reasons), apply});
  };
  damage("a hole removed", {K::missing_hole}, [](ClaimedSum& given, Sum sum) {
    if (has_empty_hole(sum)) first_with_holes(given.region).holes.pop_back();
  });
  damage("a hole added", {K::additional_hole}, [](ClaimedSum& given, Sum sum) {
    const Chain hole = triangle_beside(first_edge(sum.outer.back()), sum);
    component_around(given.region, hole[0])->holes.push_back(backwards(hole));
  });
  damage("a vertex moved by 1/1000000", {K::not_in_sum, K::not_in_given},
         [](ClaimedSum& given, Sum) {
           Chain& chain = first_chain(given);
           chain[chain.size() / 2].x += Rational(1, 1000000);
         });
  damage("an outer chain turned", {K::wrong_orientation}, [](ClaimedSum& given, Sum) {
    Chain& chain = given.region.components.back().outer;
    chain = backwards(chain);
  });
  damage("a hole turned", {K::wrong_orientation}, [](ClaimedSum& given, Sum sum) {
    if (!has_hole(sum)) return;
    Chain& hole = first_with_holes(given.region).holes.front();
    hole = backwards(hole);
  });
  damage("a dangling edge lost", {K::missing_dangling_edge}, [](ClaimedSum& given, Sum sum) {
    if (!sum.dangling_edges.empty()) given.dangling_edges.pop_back();
  });
  damage("half of a dangling edge lost", {K::missing_dangling_edge},
         [](ClaimedSum& given, Sum sum) {
           if (sum.dangling_edges.empty()) return;
           Segment& e = given.dangling_edges.back();
           e.target = midpoint(e.source, e.target);
         });
  damage("a dangling edge invented", {K::additional_dangling_edge}, [](ClaimedSum& given, Sum sum) {
    const Chain inside = triangle_beside(first_edge(sum.outer.front()), sum);
    given.dangling_edges.push_back(first_edge(inside));
  });
  damage("an isolated vertex lost", {K::missing_isolated_vertex}, [](ClaimedSum& given, Sum sum) {
    if (!sum.isolated_vertices.empty()) given.isolated_vertices.pop_back();
  });
  damage("an isolated vertex invented", {K::additional_isolated_vertex},
         [](ClaimedSum& given, Sum sum) {
           const Chain inside = triangle_beside(first_edge(sum.outer.front()), sum);
           given.isolated_vertices.push_back(inside[2]);
         });
  damage("two components joined", {K::joined_components}, join_components);
  damage("a component lost", {K::missing_component}, [](ClaimedSum& given, Sum sum) {
    // Features inside the component would stay outside.
    if (!has_features(sum)) given.region.components.pop_back();
  });
  damage("a component twice", {K::unsimple_boundary}, [](ClaimedSum& given, Sum) {
    const Component again = given.region.components.front();
    given.region.components.push_back(again);
  });
  damage("a component put into a hole", {K::additional_component}, [](ClaimedSum& given, Sum sum) {
    if (!has_hole(sum)) return;
    const Segment e = first_edge(sum.holes.back());
    given.region.components.push_back({triangle_beside(reversed(e), sum), {}});
  });
  damage("a component put outside", {K::additional_component}, [](ClaimedSum& given, Sum sum) {
    const Segment e = first_edge(sum.outer.front());
    given.region.components.push_back({triangle_beside(reversed(e), sum), {}});
  });
  damage("a hole filled by a component", {K::missing_hole}, [](ClaimedSum& given, Sum sum) {
    if (!has_empty_hole(sum)) return;
    const Chain hole = first_with_holes(given.region).holes.front();
    given.region.components.push_back({backwards(hole), {}});
  });
  damage("a spike outwards", {K::unsimple_boundary}, [](ClaimedSum& given, Sum sum) {
    Chain& chain = first_chain(given);
    const Segment e = first_edge(chain);
    const Point middle = midpoint(e.source, e.target);
    const Point tip = triangle_beside(reversed(e), sum)[0];
    chain.insert(chain.begin() + 1, {middle, tip, middle});
  });
  damage("a chain that is a point", {K::unsimple_boundary}, [](ClaimedSum& given, Sum sum) {
    const Point outside = triangle_beside(reversed(first_edge(sum.outer.front())), sum)[0];
    given.region.components.push_back({Chain(4, outside), {}});
  });
  damage("a hole that is a point", {K::unsimple_boundary}, [](ClaimedSum& given, Sum sum) {
    const Point inside = triangle_beside(first_edge(sum.outer.front()), sum)[0];
    given.region.components.back().holes.push_back(Chain(1, inside));
  });
  damage("a chain forth and back", {K::unsimple_boundary}, [](ClaimedSum& given, Sum sum) {
    const Chain outside = triangle_beside(reversed(first_edge(sum.outer.front())), sum);
    given.region.components.push_back({{outside[0], outside[1], outside[1]}, {}});
  });
  damage("the other kind of boundary", {K::wrong_boundary}, [](ClaimedSum& given, Sum) {
    given.dangling_edges.clear();
    given.isolated_vertices.clear();
  });
  damage("translated", {K::not_in_sum, K::not_in_given}, [](ClaimedSum& given, Sum sum) {
    if (!has_features(sum))
      given.region = translated(given.region, {Rational(1, 1000), Rational(1, 777)});
  });
  damage("a vertex rounded", {K::not_in_sum, K::not_in_given}, [](ClaimedSum& given, Sum) {
    for (Component& component : given.region.components) {
      for (Point& v : component.outer) {
        const mpz_class whole = v.x.get_num() / v.x.get_den();
        if (v.x == whole) continue;
        v.x = whole;
        return;
      }
    }
  });
  damage("a vertex left out", {K::not_in_sum, K::not_in_given}, [](ClaimedSum& given, Sum) {
    Chain& chain = first_chain(given);
    if (chain.size() > 3) chain.erase(chain.begin() + 1);
  });
  damage("two vertices exchanged",
         {K::not_in_sum, K::not_in_given, K::split_component, K::additional_component},
         [](ClaimedSum& given, Sum) {
           Chain& chain = first_chain(given);
           if (chain.size() > 3) std::swap(chain[0], chain[1]);
         });
  damage("a hole given as a component", {K::missing_hole}, [](ClaimedSum& given, Sum sum) {
    if (!has_empty_hole(sum)) return;
    Component& component = first_with_holes(given.region);
    const Chain hole = component.holes.back();
    component.holes.pop_back();
    given.region.components.push_back({hole, {}});
  });
  damage("nothing given", {K::missing_component}, [](ClaimedSum& given, Sum) { given = {}; });
  return all;
}

}  // namespace oplus
