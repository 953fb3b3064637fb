// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include "checked/slide/blocked_interval.hpp"
#include "checked/slide/integer_summands.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus::slide {

/// Whether components of P and -Q + x(t) overlap where no edges cross: one is inside the other then.
/// Shifted, x(t) is moved by an infinitesimal along the segment and a yet smaller one to its right. So no
/// vertex is on an edge, and the edges that touch at x(t) have come apart.
template <typename Numbers>
class ComponentTest {
 public:
  explicit ComponentTest(const IntegerSummands<Numbers>& summands,
                         Shift shift = Shift::to_the_right)
      : summands_(summands), shift_(shift) {}

  /// Whether there is anything to test. The two components that touch each other as the segment says
  /// do not overlap where their edges do not cross (docs/slide.md, step 4).
  bool is_needed() const { return summands_.has_several_components(); }

  /// O(log n + log m) for each pair of components the sum of whose boxes contains x(t), where chains
  /// are not wound around a place. Requires: prepare_component_test(), no edges cross at t, and t is not at
  /// an end of a free piece.
  bool overlap_at(const ReducedSegment<Numbers>& segment, const Fraction<Numbers>& t) const {
    return overlap_at(segment, t, [](Summand, std::uint32_t) { return true; });
  }

  /// The same, where only those components can be inside another one of which may_be_inside(summand,
  /// first vertex) holds. Requires: without a shift, it does not hold of those that touch another one at x(t).
  template <typename MayBeInside>
  bool overlap_at(const ReducedSegment<Numbers>& segment, const Fraction<Numbers>& t,
                  const MayBeInside& may_be_inside) const {
    if (OPLUS_MUTANT("slide-components-never-overlap",
                     "where no edges cross, a component inside another one is not seen"))
      return false;
    ApproximatePoint near = near_place(segment, t);
    if (shift_ == Shift::to_the_right && summands_.margins.area_is_exact)
      near = shifted_to_the_right(segment, near);
    return overlap_below(0, 0, segment, t, near, may_be_inside);
  }

 private:
  using Value = typename Numbers::Value;
  using Product = typename Numbers::Product;

  /// Places, and differences of a place and a vertex, are off by less.
  double margin() const { return 8 * summands_.margins.point; }

  /// Whether components below two nodes of the trees overlap.
  template <typename MayBeInside>
  bool overlap_below(std::uint32_t i, std::uint32_t j, const ReducedSegment<Numbers>& segment,
                     const Fraction<Numbers>& t, const ApproximatePoint& x,
                     const MayBeInside& may_be_inside) const {
    const ComponentTree::Node& a = summands_.components_of_p.components()[i];
    const ComponentTree::Node& b = summands_.components_of_q.components()[j];
    if (!(a.box + b.box).contains(x, margin())) return false;
    if (a.is_leaf() && b.is_leaf()) {
      const IntegerSummand<Numbers>& p = summands_.p;
      const IntegerSummand<Numbers>& q = summands_.q;
      const std::uint32_t of_p = p.first_of_component[a.first],
                          of_q = q.first_of_component[b.first];
      return (may_be_inside(Summand::Q, of_q) &&
              is_inside(p, summands_.components_of_p, a.first, segment, t, q, of_q)) ||
             (may_be_inside(Summand::P, of_p) &&
              is_inside(q, summands_.components_of_q, b.first, segment, t, p, of_p));
    }
    const auto overlap = [&](std::uint32_t in_p, std::uint32_t in_q) {
      return overlap_below(in_p, in_q, segment, t, x, may_be_inside);
    };
    if (b.is_leaf() || (!a.is_leaf() && a.box.size() > b.box.size()))
      return overlap(i + 1, j) || overlap(a.right, j);
    return overlap(i, j + 1) || overlap(i, b.right);
  }

  /// Of three numbers, each infinitely smaller than the one before, the sign of the first that is not
  /// zero; without a shift, only the first counts.
  template <typename A, typename B, typename C>
  int first_sign(const A& a, const B& b, const C& c) const {
    if (shift_ == Shift::none) return sign_of(a);
    const int sign = sign_of(a) != 0 ? sign_of(a) : sign_of(b);
    return sign != 0 ? sign : sign_of(c);
  }

  /// Whether x(t) - v is in a component of a summand: by the parity of the edges to the right
  /// of it. v is a vertex of the other summand.
  bool is_inside(const IntegerSummand<Numbers>& summand, const ComponentTree& tree,
                 std::uint32_t component, const ReducedSegment<Numbers>& segment,
                 const Fraction<Numbers>& t, const IntegerSummand<Numbers>& other,
                 std::uint32_t vertex) const {
    const IntegerVector<Numbers>& v = other.edges[vertex].source;
    const IntegerVector<Numbers>& d = segment.exact.direction;
    const ApproximatePoint place = near_place(segment, t);
    const ApproximatePoint near = {place.x - other.near[vertex].x, place.y - other.near[vertex].y};
    // The place times the denominator of t, computed once it is needed.
    const Product scale(t.denominator());
    const auto scaled = [&](const Value& source, const Value& less, const Value& along) {
      return Product(Product(source - less) * scale + Product(along) * Product(t.numerator()));
    };
    struct Place {
      Product x, y;
    };
    std::optional<Place> computed;
    const auto exact = [&]() -> const Place& {
      if (!computed)
        computed = {scaled(segment.exact.source.x, v.x, d.x),
                    scaled(segment.exact.source.y, v.y, d.y)};
      return *computed;
    };
    // The right normal of d is (d.y, -d.x).
    const auto is_above = [&](std::uint32_t i) {
      const double height = summand.near[i].y - near.y;
      if (std::abs(height) > margin()) return height > 0;
      return first_sign(Product(Product(summand.edges[i].source.y) * scale - exact().y),
                        Value(-d.y), d.x) > 0;
    };
    const auto crosses = [&](std::uint32_t i, std::uint32_t next) {
      const bool ends_above = is_above(next);
      if (is_above(i) == ends_above) return false;
      const NearSegment& e = summand.near[i];
      const auto& a = summand.edges[i].source;
      const auto& u = summand.edges[i].direction;
      const double turn = e.dx * (near.y - e.y) - e.dy * (near.x - e.x);
      // The differences are off by less than two margins, and less than 2^50 margins.
      if (std::abs(turn) > 4 * margin() * (std::abs(e.dx) + std::abs(e.dy) + margin()))
        return (turn > 0) == ends_above;
      const Product exact_turn = Product(u.x) * (exact().y - Product(a.y) * scale) -
                                 Product(u.y) * (exact().x - Product(a.x) * scale);
      return (first_sign(exact_turn, cross(u, d), Value(-dot(u, d))) > 0) == ends_above;
    };
    return tree.is_inside(component, near, margin(), is_above, crosses);
  }

  const IntegerSummands<Numbers>& summands_;
  Shift shift_;
};

}  // namespace oplus::slide
