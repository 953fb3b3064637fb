// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "checked/slide/blocking_search.hpp"
#include "checked/slide/contacts.hpp"

namespace oplus::slide {

/// The first vertices of the components of both summands.
template <typename Numbers>
struct ComponentTrees {
  explicit ComponentTrees(const IntegerSummands<Numbers>& summands)
      : of_p(boxes(summands.p)), of_q(boxes(summands.q)) {}

  BoxTree of_p, of_q;

 private:
  static std::vector<Box> boxes(const IntegerSummand<Numbers>& summand) {
    std::vector<Box> boxes;
    for (std::size_t c = 0; c + 1 < summand.first_of_component.size(); ++c) {
      const NearSegment& first = summand.near[summand.first_of_component[c]];
      boxes.push_back(box_around<Numbers>({first.x, first.y, 0, 0}));
    }
    return boxes;
  }
};

/// Whether points of segments are in the open sum: whether the interiors of P and -Q + x(t) meet, x(t)
/// not shifted. One object a thread.
template <typename Numbers>
class OpenSumTest {
 public:
  OpenSumTest(const IntegerSummands<Numbers>& summands, const RaysOfBoth<Numbers>& rays,
              const ComponentTrees<Numbers>& components)
      : summands_(summands),
        components_(components),
        search_(summands, Shift::none),
        contacts_(summands, rays),
        // Edges that cross where both are touched by other chains show no common interior.
        crossings_decide_(!rays[0].has_inside() || !rays[1].has_inside()),
        touched_of_p_(summands.p.first_of_chain.size(), 0),
        touched_of_q_(summands.q.first_of_chain.size(), 0) {}

  /// A proper crossing decides, else a sector around a contact, else a component without contact that
  /// is inside the other summand (docs/collision.md).
  bool contains(const Track<Numbers>& track, const Fraction<Numbers>& t) {
    if (!crossings_decide_)
      search_.leave_out_all();
    else if (search_.at(track, t))
      return true;
    ++test_;
    seen_.clear();
    bool meet = false;
    search_.each_pair(track, {t, t}, [&](const EdgePair& pair) {
      if (meet) return;
      if (!crossings_decide_ && contacts_.cross_at(track.exact, t, pair)) {
        meet = true;
      } else if (const auto contact = contacts_.at(track.exact, t, pair)) {
        touch(pair);
        meet = is_new(*contact) && contacts_.interiors_meet_at(*contact);
      }
    });
    return meet || (has_several_components() && is_component_inside(track, t));
  }

  /// The same where neither a crossing nor a contact shows that interiors meet.
  bool contains_by_components(const Track<Numbers>& track, const Fraction<Numbers>& t) {
    if (!has_several_components()) return false;
    ++test_;
    search_.leave_out_all();
    search_.each_pair(track, {t, t}, [&](const EdgePair& pair) {
      if (contacts_.at(track.exact, t, pair)) touch(pair);
    });
    return is_component_inside(track, t);
  }

 private:
  using Product = typename Numbers::Product;

  void touch(const EdgePair& pair) {
    touched_of_p_[summands_.p.chain_of[pair.first]] = test_;
    touched_of_q_[summands_.q.chain_of[pair.second]] = test_;
  }

  bool has_several_components() const { return summands_.has_several_components(); }

  /// Where many chains touch, a contact is seen many times.
  bool is_new(const Contact& contact) {
    const auto& [rays_of_p, rays_of_q] = contacts_.rays();
    if (!rays_of_p.is_touching_point(contact.of_p) && !rays_of_q.is_touching_point(contact.of_q))
      return true;
    return seen_.insert({rays_of_p.name(contact.of_p), rays_of_q.name(contact.of_q)}).second;
  }

  /// Of two components that touch and have no sector in common, none is inside the other: the boundary
  /// at the contact, which the other does not enter, divides them. So it is enough to look at outer
  /// chains, and at none if both summands are connected, since those of the segment touch.
  bool is_component_inside(const Track<Numbers>& track, const Fraction<Numbers>& t) const {
    return is_one_inside(summands_.p, components_.of_p, touched_of_p_, summands_.q,
                         summands_.tree_of_q, track, t) ||
           is_one_inside(summands_.q, components_.of_q, touched_of_q_, summands_.p,
                         summands_.tree_of_p, track, t);
  }

  bool is_one_inside(const IntegerSummand<Numbers>& inner, const BoxTree& first_vertices,
                     const std::vector<std::size_t>& touched, const IntegerSummand<Numbers>& outer,
                     const BoxTree& tree_of_outer, const Track<Numbers>& track,
                     const Fraction<Numbers>& t) const {
    return any_leaf_around(
        first_vertices, near_place(track, t).box(),
        [&](std::uint32_t component) {
          const std::uint32_t first = inner.first_of_component[component];
          return touched[inner.chain_of[first]] != test_ &&
                 is_inside(outer, tree_of_outer, track, t, inner, first);
        },
        tree_of_outer[0].box);
  }

  /// Whether x(t) - v is inside a summand, by the parity of the edges to the right of it. Requires: it
  /// is not on the boundary.
  bool is_inside(const IntegerSummand<Numbers>& summand, const BoxTree& tree,
                 const Track<Numbers>& track, const Fraction<Numbers>& t,
                 const IntegerSummand<Numbers>& of_v, std::uint32_t v) const {
    const auto from = track.exact.source - of_v.edges[v].source;
    const auto& d = track.exact.direction;
    const Product whole(t.denominator()), n(t.numerator());
    const Product x = Product(from.x) * whole + Product(d.x) * n;
    const Product y = Product(from.y) * whole + Product(d.y) * n;
    Box right_of = difference(near_place(track, t), of_v.near[v]).box();
    right_of[0] = std::numeric_limits<float>::infinity();
    bool inside = false;
    any_leaf_around(tree, right_of, [&](std::uint32_t edge) {
      const auto& a = summand.edges[edge].source;
      const auto& u = summand.edges[edge].direction;
      const Product to_x = x - Product(a.x) * whole, to_y = y - Product(a.y) * whole;
      const bool source_below = to_y >= 0, target_below = to_y >= Product(u.y) * whole;
      if (source_below == target_below) return false;
      // Of an upward edge, the left side is also to the left.
      const int side = sign_of(Product(Product(u.x) * to_y - Product(u.y) * to_x));
      if ((side > 0) == source_below) inside = !inside;
      return false;
    });
    return inside;
  }

  const IntegerSummands<Numbers>& summands_;
  const ComponentTrees<Numbers>& components_;
  BlockingSearch<Numbers> search_;
  Contacts<Numbers> contacts_;
  bool crossings_decide_;
  std::size_t test_ = 0;
  std::vector<std::size_t> touched_of_p_,
      touched_of_q_;  ///< the last test that saw a contact of a chain
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen_;
};

}  // namespace oplus::slide
