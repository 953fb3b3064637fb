// SPDX-License-Identifier: MIT
#pragma once

#include "checked/slide/integer_summands.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus::slide {

/// Whether components of P and -Q + x(t) overlap where no edges cross: one is inside the other then.
/// x(t) is shifted by an infinitesimal along the segment and a yet smaller one to its right. So no
/// vertex is on an edge, and the edges that touch at x(t) have come apart.
template <typename Numbers>
class ComponentTest {
 public:
  explicit ComponentTest(const IntegerSummands<Numbers>& summands) : summands_(summands) {}

  /// Whether there is anything to test. The two components that touch each other as the segment says
  /// do not overlap where their edges do not cross (docs/slide.md, step 4).
  bool is_needed() const { return components(summands_.p) > 1 || components(summands_.q) > 1; }

  /// Requires: no edges cross at t, and t is not at an end of a free piece.
  bool overlap_at(const Track<Numbers>& track, const Fraction<Numbers>& t) const {
    const IntegerSummand<Numbers>& p = summands_.p;
    const IntegerSummand<Numbers>& q = summands_.q;
    const Box point = near_place(track, t).box();
    for (std::size_t c = 0; c < components(p); ++c) {
      for (std::size_t d = 0; d < components(q); ++d) {
        if (OPLUS_MUTANT("slide-components-never-overlap",
                         "where no edges cross, a component inside another one is not seen"))
          continue;
        if (!contains(p.boxes_of_components[c] + q.boxes_of_components[d], point)) continue;
        const auto& vertex_of_p = p.edges[p.first_of_component[c]].source;
        const auto& vertex_of_q = q.edges[q.first_of_component[d]].source;
        if (is_inside(p, c, track.exact, t, vertex_of_q) ||
            is_inside(q, d, track.exact, t, vertex_of_p))
          return true;
      }
    }
    return false;
  }

 private:
  using Value = typename Numbers::Value;
  using Product = typename Numbers::Product;

  static std::size_t components(const IntegerSummand<Numbers>& summand) {
    return summand.boxes_of_components.size();
  }

  /// Whether x(t) - v, shifted, is in a component: by the parity of the edges to the right of it.
  static bool is_inside(const IntegerSummand<Numbers>& summand, std::size_t component,
                        const IntegerSegment<Numbers>& segment, const Fraction<Numbers>& t,
                        const IntegerVector<Numbers>& v) {
    const Product scale(t.denominator());
    const auto& d = segment.direction;
    const auto place = [&](const auto& source, const auto& less, const auto& along) {
      return Product(Product(source - less) * scale + Product(along) * Product(t.numerator()));
    };
    const Product x = place(segment.source.x, v.x, d.x), y = place(segment.source.y, v.y, d.y);
    // Of three numbers, each infinitely smaller than the one before, the first that is not zero.
    const auto first_sign = [](const auto& a, const auto& b, const auto& c) {
      const int sign = sign_of(a) != 0 ? sign_of(a) : sign_of(b);
      return sign != 0 ? sign : sign_of(c);
    };
    // The right normal of d is (d.y, -d.x).
    const auto is_above = [&](const auto& height) {
      return first_sign(Product(Product(height) * scale - y), Value(-d.y), d.x) > 0;
    };
    bool inside = false;
    for (std::size_t i = summand.first_of_component[component];
         i < summand.first_of_component[component + 1]; ++i) {
      const auto& a = summand.edges[i].source;
      const auto& u = summand.edges[i].direction;
      const bool ends_above = is_above(a.y + u.y);
      if (is_above(a.y) == ends_above) continue;
      const Product turn =
          Product(u.x) * (y - Product(a.y) * scale) - Product(u.y) * (x - Product(a.x) * scale);
      const int side = first_sign(turn, cross(u, d), Value(-dot(u, d)));
      if ((side > 0) == ends_above) inside = !inside;
    }
    return inside;
  }

  const IntegerSummands<Numbers>& summands_;
};

}  // namespace oplus::slide
