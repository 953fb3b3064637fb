// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "checked/collision/contact.hpp"
#include "checked/slide/boundary_rays.hpp"
#include "checked/slide/integer_summands.hpp"

namespace oplus::slide {

/// A point that the boundaries of P and -Q + x(t) have in common: not inside two edges.
struct Contact {
  Feature of_p;
  Feature of_q;
};

/// Where boundaries touch without a proper crossing (thesis, Section 5.1.1), x(t) not shifted. One
/// object a thread.
template <typename Numbers>
class Contacts {
 public:
  using Value = typename Numbers::Value;
  using Product = typename Numbers::Product;

  Contacts(const IntegerSummands<Numbers>& summands, const RaysOfBoth<Numbers>& rays)
      : summands_(summands), rays_(rays) {}

  /// Where a pair of edges touches at a place; nothing if they are parallel or do not touch, or if
  /// another chain touches an edge there: then a pair with that chain does.
  std::optional<Contact> at(const IntegerSegment<Numbers>& segment, const Fraction<Numbers>& t,
                            const EdgePair& pair) const {
    const auto& [u, w, from_corner, area] = parallelogram(segment, pair);
    if (area == 0) return std::nullopt;
    const auto& d = segment.direction;
    // x(t) is the corner plus a u + b w.
    const Product whole = Product(area) * Product(t.denominator());
    const Where a = where(scaled(t, cross(from_corner, w), cross(d, w)), whole);
    if (a == Where::outside) return std::nullopt;
    const Where b = where(scaled(t, cross(u, from_corner), cross(u, d)), whole);
    if (b == Where::outside || (a == Where::inside && b == Where::inside)) return std::nullopt;
    const Contact contact{feature(0, pair.first, a), feature(1, pair.second, b)};
    if (!is_between_touching_points(segment, t, contact)) return std::nullopt;
    return contact;
  }

  /// Whether a pair of edges crosses properly at a place, and not in a point where other chains of
  /// both summands touch them: there, interiors need not meet.
  bool cross_at(const IntegerSegment<Numbers>& segment, const Fraction<Numbers>& t,
                const EdgePair& pair) const {
    const auto& [u, w, from_corner, area] = parallelogram(segment, pair);
    if (area == 0) return false;
    const auto& d = segment.direction;
    const Product whole = Product(area) * Product(t.denominator());
    if (where(scaled(t, cross(from_corner, w), cross(d, w)), whole) != Where::inside ||
        where(scaled(t, cross(u, from_corner), cross(u, d)), whole) != Where::inside)
      return false;
    for (const auto& [edge_of_p, v] : rays_[0].inside(pair.first))
      for (const auto& [edge_of_q, w_] : rays_[1].inside(pair.second))
        if (is_at(segment, t, summands_.p.edges[v].source + summands_.q.edges[w_].source))
          return false;
    return true;
  }

  const RaysOfBoth<Numbers>& rays() const { return rays_; }

  /// Where a pair of edges touches on a part of the segment's line longer than a point: always a
  /// vertex in an edge. Nothing if it does not.
  std::optional<Contact> along(const IntegerSegment<Numbers>& segment, const EdgePair& pair) const {
    const auto& d = segment.direction;
    const bool is_along_q = turn(d, summands_.q.edges[pair.second].direction) == 0;
    if (!is_along_q && turn(d, summands_.p.edges[pair.first].direction) != 0) return std::nullopt;
    const Parallelogram sum = parallelogram(segment, pair);
    if (sum.area == 0) return std::nullopt;
    const auto vertex = [&](std::size_t of, std::uint32_t edge,
                            const Value& along) -> std::optional<Feature> {
      if (along == 0) return Feature{edge, true};
      if (along == sum.area) return Feature{rays_[of].target(edge), true};
      return std::nullopt;
    };
    if (is_along_q) {
      if (const auto of_p = vertex(0, pair.first, cross(sum.from_corner, sum.w)))
        return Contact{*of_p, {pair.second, false}};
    } else if (const auto of_q = vertex(1, pair.second, cross(sum.u, sum.from_corner))) {
      return Contact{{pair.first, false}, *of_q};
    }
    return std::nullopt;
  }

  /// Calls add(t) with the places at which a vertex that slides along an edge meets a vertex of another
  /// chain inside it.
  template <typename Add>
  void each_touching_point(const IntegerSegment<Numbers>& segment, const Contact& contact,
                           const Add& add) const {
    const auto& d = segment.direction;
    each_meeting_point(contact, [&](const IntegerVector<Numbers>& x) {
      add(Fraction<Numbers>{dot(d, x - segment.source), dot(d, d)});
    });
  }

  /// Whether the interiors have a sector around the contact in common.
  bool interiors_meet_at(const Contact& contact) {
    return !OPLUS_MUTANT(
               "slide-ignores-weak-intersections",
               "slide takes boundaries that meet without a proper crossing to touch only") &&
           (contact.of_p.is_vertex == contact.of_q.is_vertex ||
                    rays_[0].is_touching_point(contact.of_p) ||
                    rays_[1].is_touching_point(contact.of_q)
                ? is_sector_common(contact)
                : is_sector_beside_edge(contact));
  }

 private:
  struct Around {
    IntegerVector<Numbers> direction;
    bool is_lower;  ///< its angle is at least π
    Summand of;
    bool interior_is_counterclockwise;
  };

  bool is_sector_common(const Contact& contact) {
    around_.clear();
    const auto add_to = [&](Summand of) {
      return [this, of](const Ray<Numbers>& ray) {
        const auto direction = of == Summand::P ? ray.direction : -ray.direction;
        const bool is_lower = direction.y < 0 || (direction.y == 0 && direction.x < 0);
        around_.push_back({direction, is_lower, of, ray.interior_is_counterclockwise});
      };
    };
    rays_[0].each_ray(contact.of_p, add_to(Summand::P));
    rays_[1].each_ray(contact.of_q, add_to(Summand::Q));
    const auto is_before = [](const Around& a, const Around& b) {
      if (a.is_lower != b.is_lower) return b.is_lower;
      return turn(a.direction, b.direction) > 0;
    };
    std::sort(around_.begin(), around_.end(), is_before);
    in_order_.clear();
    for (std::size_t i = 0; i < around_.size(); ++i) {
      if (i == 0 || is_before(around_[i - 1], around_[i])) in_order_.emplace_back();
      in_order_.back()[static_cast<std::size_t>(around_[i].of)] =
          around_[i].interior_is_counterclockwise;
    }
    return is_sector_inside_both(in_order_);
  }

  /// The same for a vertex in an edge, no other chain there: whether not all of the sector at the vertex
  /// is to the right of the edge. In -Q, directions are turned round.
  bool is_sector_beside_edge(const Contact& contact) const {
    const bool is_of_p = contact.of_p.is_vertex;
    const auto& with_vertex = is_of_p ? summands_.p : summands_.q;
    const std::uint32_t vertex = (is_of_p ? contact.of_p : contact.of_q).number;
    const auto& edge = is_of_p ? summands_.q.edges[contact.of_q.number].direction
                               : summands_.p.edges[contact.of_p.number].direction;
    // The sector is counterclockwise of the ray ahead, up to the ray back.
    const auto& ahead = with_vertex.edges[vertex].direction;
    const auto& entering = with_vertex.edges[with_vertex.previous[vertex]].direction;
    if (turn(edge, ahead) < 0 || turn(edge, entering) > 0) return true;
    const int corner = turn(entering, ahead);
    // Straight on, the sector is a half plane.
    return corner < 0 || (corner == 0 && dot(edge, ahead) < 0);
  }

  struct Parallelogram {
    const IntegerVector<Numbers>& u;
    const IntegerVector<Numbers>& w;
    IntegerVector<Numbers> from_corner;
    Value area;
  };

  /// The sum of a pair of edges; from its corner, the segment's source.
  Parallelogram parallelogram(const IntegerSegment<Numbers>& segment, const EdgePair& pair) const {
    const auto& e = summands_.p.edges[pair.first];
    const auto& f = summands_.q.edges[pair.second];
    return {e.direction, f.direction, segment.source - e.source - f.source,
            cross(e.direction, f.direction)};
  }

  static Product scaled(const Fraction<Numbers>& t, const Value& constant, const Value& slope) {
    return Product(constant) * Product(t.denominator()) + Product(slope) * Product(t.numerator());
  }

  /// Whether x is x(t).
  static bool is_at(const IntegerSegment<Numbers>& segment, const Fraction<Numbers>& t,
                    const IntegerVector<Numbers>& x) {
    const auto to = x - segment.source;
    const auto& d = segment.direction;
    const Product n(t.numerator()), whole(t.denominator());
    return Product(to.x) * whole == Product(d.x) * n && Product(to.y) * whole == Product(d.y) * n;
  }

  /// On an edge.
  enum class Where { outside, source, inside, target };

  static Where where(const Product& along, const Product& whole) {
    if (along == 0) return Where::source;
    if (along == whole) return Where::target;
    const bool is_inside = whole > 0 ? along > 0 && along < whole : along < 0 && along > whole;
    return is_inside ? Where::inside : Where::outside;
  }

  Feature feature(std::size_t of, std::uint32_t edge, Where where) const {
    if (where == Where::inside) return {edge, false};
    return {where == Where::source ? edge : rays_[of].target(edge), true};
  }

  /// Calls visit(x) where a vertex of one summand touches, inside an edge of the other, a vertex of
  /// another chain.
  template <typename Visit>
  void each_meeting_point(const Contact& contact, const Visit& visit) const {
    const auto& p = summands_.p.edges;
    const auto& q = summands_.q.edges;
    if (!contact.of_p.is_vertex)
      for (const auto& [edge, vertex] : rays_[0].inside(contact.of_p.number))
        visit(p[vertex].source + q[contact.of_q.number].source);
    if (!contact.of_q.is_vertex)
      for (const auto& [edge, vertex] : rays_[1].inside(contact.of_q.number))
        visit(p[contact.of_p.number].source + q[vertex].source);
  }

  bool is_between_touching_points(const IntegerSegment<Numbers>& segment,
                                  const Fraction<Numbers>& t, const Contact& contact) const {
    bool is_between = true;
    each_meeting_point(contact, [&](const IntegerVector<Numbers>& x) {
      if (is_at(segment, t, x)) is_between = false;
    });
    return is_between;
  }

  const IntegerSummands<Numbers>& summands_;
  const RaysOfBoth<Numbers>& rays_;
  std::vector<Around> around_;  // of one contact; kept for their memory
  std::vector<InteriorSides> in_order_;
};

}  // namespace oplus::slide
