// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "checked/slide/blocking_search.hpp"
#include "checked/slide/component_test.hpp"
#include "checked/slide/contacts.hpp"

namespace oplus::slide {

/// Whether points of segments are in the open sum: whether the interiors of P and -Q + x(t) meet, x(t)
/// not shifted. One object a thread.
template <typename Numbers>
class OpenSumTest {
 public:
  OpenSumTest(const IntegerSummands<Numbers>& summands, const RaysOfBoth<Numbers>& rays)
      : summands_(summands),
        components_(summands, Shift::none),
        search_(summands, Shift::none),
        contacts_(summands, rays),
        // Edges that cross where both are touched by other chains show no common interior.
        crossings_decide_(!rays[0].has_inside() || !rays[1].has_inside()),
        touched_of_p_(summands.p.first_of_chain.size(), 0),
        touched_of_q_(summands.q.first_of_chain.size(), 0) {}

  /// A proper crossing decides, else a sector around a contact, else a component without contact that
  /// is inside the other summand (docs/collision.md).
  bool contains(const ReducedSegment<Numbers>& segment, const Fraction<Numbers>& t) {
    if (!crossings_decide_)
      search_.leave_out_all();
    else if (search_.at(segment, t))
      return true;
    ++test_;
    seen_.clear();
    bool meet = false;
    search_.each_pair(segment, {t, t}, [&](const EdgePair& pair) {
      if (meet) return;
      if (!crossings_decide_ && contacts_.cross_at(segment.exact, t, pair)) {
        meet = true;
      } else if (const auto contact = contacts_.at(segment.exact, t, pair)) {
        touch(pair);
        meet = is_new(*contact) && contacts_.interiors_meet_at(*contact);
      }
    });
    return meet || (components_.is_needed() && is_component_inside(segment, t));
  }

  /// The same where neither a crossing nor a contact shows that interiors meet.
  bool contains_by_components(const ReducedSegment<Numbers>& segment, const Fraction<Numbers>& t) {
    if (!components_.is_needed()) return false;
    ++test_;
    search_.leave_out_all();
    search_.each_pair(segment, {t, t}, [&](const EdgePair& pair) {
      if (contacts_.at(segment.exact, t, pair)) touch(pair);
    });
    return is_component_inside(segment, t);
  }

 private:
  void touch(const EdgePair& pair) {
    touched_of_p_[summands_.p.chain_of[pair.first]] = test_;
    touched_of_q_[summands_.q.chain_of[pair.second]] = test_;
  }

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
  bool is_component_inside(const ReducedSegment<Numbers>& segment,
                           const Fraction<Numbers>& t) const {
    return components_.overlap_at(segment, t, [&](Summand of, std::uint32_t first) {
      return of == Summand::P ? touched_of_p_[summands_.p.chain_of[first]] != test_
                              : touched_of_q_[summands_.q.chain_of[first]] != test_;
    });
  }

  const IntegerSummands<Numbers>& summands_;
  ComponentTest<Numbers> components_;
  BlockingSearch<Numbers> search_;
  Contacts<Numbers> contacts_;
  bool crossings_decide_;
  std::size_t test_ = 0;
  std::vector<std::size_t> touched_of_p_,
      touched_of_q_;  ///< the last test that saw a contact of a chain
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen_;
};

}  // namespace oplus::slide
