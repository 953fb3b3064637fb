// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "checked/verify/verify.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/definitions/given_sum.hpp"
#include "reference/definitions/ray.hpp"
#include "reference/definitions/winding_number.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {

/// A way to spoil a sum, and the reasons of which one must be given.
struct Damage {
  std::string name;
  std::set<ReasonKind> right_reasons;
  /// Damages what is given of a sum. Returns false where there is nothing to be damaged in this way.
  std::function<bool(GivenSum& given, const MinkowskiSum& sum)> apply;
};

inline GivenSum undamaged(const MinkowskiSum& sum) {
  return {region_of(sum), sum.dangling_edges, sum.isolated_vertices};
}

/// Whether a segment meets an edge or a feature of a sum.
inline bool meets(const Segment& s, const MinkowskiSum& sum) {
  const std::vector<Segment> all = edges(sum);
  return std::any_of(all.begin(), all.end(),
                     [&](const Segment& e) { return !intersection(s, e).empty(); }) ||
         std::any_of(sum.isolated_vertices.begin(), sum.isolated_vertices.end(),
                     [&](const Point& p) { return lies_on(p, s); });
}

/// A counterclockwise triangle that meets nothing of a sum, to the left of a segment of its boundary,
/// near the middle.
inline Chain triangle_beside(const Segment& edge, const MinkowskiSum& sum) {
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

/// Two components as one, by a narrow bridge between two edges that see each other; false
/// where no such edges are found among the first few.
inline bool bridged(GivenSum& given, const MinkowskiSum& sum) {
  std::vector<Component>& components = given.region.components;
  for (std::size_t c = 1; c < components.size(); ++c) {
    const Chain& a = components[0].outer;
    const Chain& b = components[c].outer;
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < b.size(); ++j) {
        const Segment of_a{a[i], a[next(i, a.size())]};
        const Segment of_b{b[j], b[next(j, b.size())]};
        const auto at = [](const Segment& s, const Rational& t) {
          return s.source + t * direction_of(s);
        };
        const Rational before(31, 64);
        const Rational after(33, 64);
        const Segment there{at(of_a, before), at(of_b, after)};
        const Segment back{at(of_b, before), at(of_a, after)};
        const auto is_free = [&](const Segment& s) {
          // It leaves its edges at once, and meets nothing else.
          const Vector d = direction_of(s);
          return !meets({s.source + Rational(1, 1000) * d, s.target - Rational(1, 1000) * d},
                        sum) &&
                 locate(midpoint(s.source, s.target), sum) == Location::outside;
        };
        const Chain bridge = {there.source, there.target, back.source, back.target};
        if (cross_properly(there, back) || !is_free(there) || !is_free(back) ||
            sign(twice_area(bridge)) <= 0)
          continue;
        const std::vector<Segment> all = edges(sum);
        if (std::any_of(all.begin(), all.end(), [&](const Segment& e) {
              return locate(e.source, polygon(bridge)) != Location::outside;
            }))
          continue;
        Chain joined(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(i + 1));
        joined.push_back(there.source);
        joined.push_back(there.target);
        for (std::size_t k = 0; k < b.size(); ++k) joined.push_back(b[(j + 1 + k) % b.size()]);
        joined.push_back(back.source);
        joined.push_back(back.target);
        joined.insert(joined.end(), a.begin() + static_cast<std::ptrdiff_t>(i + 1), a.end());
        components[0].holes.insert(components[0].holes.end(), components[c].holes.begin(),
                                   components[c].holes.end());
        components[0].outer = std::move(joined);
        components.erase(components.begin() + static_cast<std::ptrdiff_t>(c));
        return true;
      }
    }
  }
  return false;
}

inline Component& first_with_holes(Region& region) {
  return *std::find_if(region.components.begin(), region.components.end(),
                       [](const Component& c) { return !c.holes.empty(); });
}

inline Segment first_edge(const Chain& chain) { return {chain[0], chain[1]}; }

inline const std::vector<Damage>& damages() {
  using K = ReasonKind;
  using Sum = const MinkowskiSum&;
  static constexpr auto always = [](Sum) { return true; };
  static constexpr auto has_hole = [](Sum sum) { return !sum.holes.empty(); };
  // Not one with a component in it, that would stay.
  static constexpr auto has_empty_hole = [](Sum sum) {
    return !sum.holes.empty() && sum.outer.size() == 1;
  };
  static constexpr auto has_dangling_edge = [](Sum sum) { return !sum.dangling_edges.empty(); };
  static constexpr auto has_isolated_vertex = [](Sum sum) {
    return !sum.isolated_vertices.empty();
  };
  static constexpr auto has_features = [](Sum sum) {
    return has_dangling_edge(sum) || has_isolated_vertex(sum);
  };
  static constexpr auto has_no_features = [](Sum sum) { return !has_features(sum); };
  const auto where = [](auto possible, auto change) {
    return [=](GivenSum& given, Sum sum) {
      if (possible(sum)) change(given, sum);
      return possible(sum);
    };
  };
  static const std::vector<Damage> all = {
      {"a hole removed",
       {K::missing_hole},
       where(has_empty_hole,
             [](GivenSum& given, Sum) { first_with_holes(given.region).holes.pop_back(); })},
      {"a hole added",
       {K::additional_hole},
       where(always,
             [](GivenSum& given, Sum sum) {
               const Chain hole = triangle_beside(first_edge(sum.outer.back()), sum);
               component_around(given.region, hole[0])->holes.push_back(backwards(hole));
             })},
      {"a vertex moved by 1/1000000",
       {K::not_in_sum, K::not_in_given},
       where(always,
             [](GivenSum& given, Sum) {
               Chain& chain = given.region.components.front().outer;
               chain[chain.size() / 2].x += Rational(1, 1000000);
             })},
      {"an outer chain turned",
       {K::wrong_orientation},
       where(always,
             [](GivenSum& given, Sum) {
               Chain& chain = given.region.components.back().outer;
               chain = backwards(chain);
             })},
      {"a hole turned",
       {K::wrong_orientation},
       where(has_hole,
             [](GivenSum& given, Sum) {
               Chain& hole = first_with_holes(given.region).holes.front();
               hole = backwards(hole);
             })},
      {"a dangling edge lost",
       {K::missing_dangling_edge},
       where(has_dangling_edge, [](GivenSum& given, Sum) { given.dangling_edges.pop_back(); })},
      {"half of a dangling edge lost",
       {K::missing_dangling_edge},
       where(has_dangling_edge,
             [](GivenSum& given, Sum) {
               Segment& e = given.dangling_edges.back();
               e.target = midpoint(e.source, e.target);
             })},
      {"a dangling edge invented",
       {K::additional_dangling_edge},
       where(always,
             [](GivenSum& given, Sum sum) {
               const Chain inside = triangle_beside(first_edge(sum.outer.front()), sum);
               given.dangling_edges.push_back({inside[0], inside[1]});
             })},
      {"an isolated vertex lost",
       {K::missing_isolated_vertex},
       where(has_isolated_vertex,
             [](GivenSum& given, Sum) { given.isolated_vertices.pop_back(); })},
      {"an isolated vertex invented",
       {K::additional_isolated_vertex},
       where(always,
             [](GivenSum& given, Sum sum) {
               given.isolated_vertices.push_back(
                   triangle_beside(first_edge(sum.outer.front()), sum)[2]);
             })},
      {"two components joined", {K::joined_components}, bridged},
      // Features inside the component would stay outside.
      {"a component lost",
       {K::missing_component},
       where(has_no_features, [](GivenSum& given, Sum) { given.region.components.pop_back(); })},
      {"a component twice",
       {K::unsimple_boundary},
       where(always,
             [](GivenSum& given, Sum) {
               const Component again = given.region.components.front();
               given.region.components.push_back(again);
             })},
      {"a component put into a hole",
       {K::additional_component},
       where(has_hole,
             [](GivenSum& given, Sum sum) {
               const Chain& hole = sum.holes.back();
               given.region.components.push_back({triangle_beside({hole[1], hole[0]}, sum), {}});
             })},
      {"a component put outside",
       {K::additional_component},
       where(always,
             [](GivenSum& given, Sum sum) {
               const Segment e = first_edge(sum.outer.front());
               given.region.components.push_back({triangle_beside(reversed(e), sum), {}});
             })},
      {"a hole filled by a component",
       {K::missing_hole},
       where(has_empty_hole,
             [](GivenSum& given, Sum) {
               const Chain hole = first_with_holes(given.region).holes.front();
               given.region.components.push_back({backwards(hole), {}});
             })},
      {"a spike outwards",
       {K::unsimple_boundary},
       where(always,
             [](GivenSum& given, Sum sum) {
               Chain& chain = given.region.components.front().outer;
               const Segment e = first_edge(chain);
               const Point middle = midpoint(e.source, e.target);
               const Point tip = triangle_beside(reversed(e), sum)[0];
               chain.insert(chain.begin() + 1, {middle, tip, middle});
             })},
      {"the other kind of boundary",
       {K::wrong_boundary},
       where(has_features,
             [](GivenSum& given, Sum) {
               given.dangling_edges.clear();
               given.isolated_vertices.clear();
             })},
      {"translated",
       {K::not_in_sum, K::not_in_given},
       where(has_no_features,
             [](GivenSum& given, Sum) {
               given.region = translated(given.region, {Rational(1, 1000), Rational(1, 777)});
             })},
      {"a vertex rounded",
       {K::not_in_sum, K::not_in_given},
       [](GivenSum& given, Sum) {
         for (Component& component : given.region.components) {
           for (Point& v : component.outer) {
             mpz_class whole = v.x.get_num() / v.x.get_den();
             if (v.x == whole) continue;
             v.x = whole;
             return true;
           }
         }
         return false;
       }},
      {"a vertex left out",
       {K::not_in_sum, K::not_in_given},
       [](GivenSum& given, Sum) {
         Chain& chain = given.region.components.front().outer;
         chain.erase(chain.begin() + 1);
         return chain.size() >= 3;
       }},
      {"two vertices exchanged",
       {K::not_in_sum, K::not_in_given, K::split_component, K::additional_component},
       [](GivenSum& given, Sum) {
         Chain& chain = given.region.components.front().outer;
         std::swap(chain[0], chain[1]);
         return chain.size() >= 4;
       }},
      {"a hole given as a component",
       {K::missing_hole},
       where(has_empty_hole,
             [](GivenSum& given, Sum) {
               Component& component = first_with_holes(given.region);
               const Chain hole = component.holes.back();
               component.holes.pop_back();
               given.region.components.push_back({hole, {}});
             })},
      {"nothing given",
       {K::missing_component},
       where(always, [](GivenSum& given, Sum) { given = {}; })},
  };
  return all;
}

}  // namespace oplus
