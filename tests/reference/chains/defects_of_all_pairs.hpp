// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "reference/chains/validity.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/direction.hpp"

namespace oplus {

/// All defects of a region, each with the chains that it names, the smaller one first where it is of edges.
/// Those of edges have the point at which they show, the smallest one; the others have none.
/// By the definitions, from all pairs of edges and of chains.
class DefectsOfAllPairs {
 public:
  using Named = std::tuple<DefectKind, std::size_t, std::size_t>;

  explicit DefectsOfAllPairs(const Region& region) : all_(chains(region)) {
    for (std::size_t c = 0; c < all_.size(); ++c) look_at_vertices(c);
    if (of_vertices.empty()) of_vertices = repeated_;
    if (!of_vertices.empty()) return;
    for (std::size_t a = 0; a < all_.size(); ++a)
      for (std::size_t b = a; b < all_.size(); ++b) look_at_edges(a, b);
    if (of_edges.empty()) look_at_nesting(region);
  }

  bool empty() const { return of_vertices.empty() && of_edges.empty() && of_nesting.empty(); }

  std::set<Named> of_vertices;                 ///< too few, or equal
  std::set<std::pair<Point, Named>> of_edges;  ///< where there are none of vertices
  std::set<Named> of_nesting;                  ///< where there are none of edges either

 private:
  void look_at_vertices(std::size_t c) {
    const Chain& chain = all_[c];
    if (chain.size() < 3) of_vertices.insert({DefectKind::too_few_vertices, c, c});
    for (std::size_t i = 0; i < chain.size(); ++i)
      if (chain.size() > 1 && chain[i] == chain[next(i, chain.size())])
        of_vertices.insert({DefectKind::zero_length_edge, c, c});
    if (of_vertices.empty() && std::set<Point>(chain.begin(), chain.end()).size() < chain.size())
      repeated_.insert({DefectKind::repeated_vertex, c, c});
  }

  void look_at_edges(std::size_t a, std::size_t b) {
    const std::vector<Segment> of_a = edges(all_[a]), of_b = edges(all_[b]);
    std::set<Point> common;
    for (std::size_t i = 0; i < of_a.size(); ++i) {
      for (std::size_t j = 0; j < of_b.size(); ++j) {
        if (a == b && j <= i) continue;
        const std::vector<Point> met = intersection(of_a[i], of_b[j]);
        if (met.empty()) continue;
        const auto found = [&](DefectKind kind) { of_edges.insert({met[0], {kind, a, b}}); };
        if (met.size() == 2) {
          found(a == b ? DefectKind::self_overlap : DefectKind::chains_overlap);
        } else if (a != b) {
          if (cross_at(met[0], of_a, of_b)) found(DefectKind::chains_cross);
        } else if (cross_properly(of_a[i], of_a[j])) {
          found(DefectKind::self_crossing);
        } else if (is_inside(met[0], of_a[i]) || is_inside(met[0], of_a[j])) {
          found(DefectKind::self_touching);
        }
      }
    }
  }

  static bool is_inside(const Point& p, const Segment& s) { return p != s.source && p != s.target; }

  /// Whether each of two chains passes once through a point, and one of them to both sides of the other.
  static bool cross_at(const Point& p, const std::vector<Segment>& of_a,
                       const std::vector<Segment>& of_b) {
    const auto directions = [&](const std::vector<Segment>& edges) {
      std::vector<Direction> from_p;
      for (const Segment& e : edges) {
        if (!lies_on(p, e)) continue;
        for (const Point* end : {&e.source, &e.target})
          if (*end != p) from_p.push_back({*end - p, Summand::P});
      }
      return from_p;
    };
    const std::vector<Direction> a = directions(of_a), b = directions(of_b);
    if (a.size() != 2 || b.size() != 2) return false;
    for (const Direction& d : a)
      for (const Direction& e : b)
        if (same_direction(d.vector, e.vector)) return false;
    return counterclockwise_between(b[0], a[0], a[1]) != counterclockwise_between(b[1], a[0], a[1]);
  }

  /// Requires: the chains are simple, and don't cross.
  bool is_inside(std::size_t a, std::size_t b) const {
    Chain around = all_[b];
    if (sgn(twice_area(around)) < 0) std::reverse(around.begin(), around.end());
    for (const Segment& e : edges(all_[a]))
      for (const Segment& piece : cut_where_met(e, edges(around)))
        if (locate(midpoint(piece.source, piece.target), polygon(around)) == Location::inside)
          return true;
    return false;
  }

  void look_at_nesting(const Region& region) {
    std::vector<std::size_t> outer_of;
    for (const Component& component : region.components)
      outer_of.insert(outer_of.end(), 1 + component.holes.size(), outer_of.size());
    const auto is_hole = [&](std::size_t c) { return outer_of[c] != c; };
    for (std::size_t a = 0; a < all_.size(); ++a) {
      if (is_hole(a) && !is_inside(a, outer_of[a]))
        of_nesting.insert({DefectKind::hole_outside, a, outer_of[a]});
      for (std::size_t b = 0; b < all_.size(); ++b) {
        if (a == b || !is_inside(a, b)) continue;
        if (is_hole(a) && is_hole(b) && outer_of[a] == outer_of[b])
          of_nesting.insert({DefectKind::holes_nested, a, b});
        if (is_hole(a) || is_hole(b)) continue;
        bool in_a_hole = false;
        for (std::size_t h = 0; h < all_.size(); ++h)
          in_a_hole = in_a_hole || (h != b && outer_of[h] == b && is_inside(a, h));
        if (!in_a_hole) of_nesting.insert({DefectKind::components_overlap, a, b});
      }
    }
  }

  std::vector<Chain> all_;
  std::set<Named> repeated_;
};

}  // namespace oplus
