// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/sweep/sweep_collision.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_sweep_2.h>
#include <CGAL/Surface_sweep_2/Default_visitor.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

#include "checked/collision/contact.hpp"
#include "checked/collision/summand_boundary.hpp"
#include "checked/sweep/non_crossing_traits.hpp"
#include "checked/sweep/strands.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

static_assert(std::is_same_v<Kernel::FT::ET, Rational>, "CGAL is compiled with CGAL_USE_GMPXX");

Kernel::Point_2 kernel_point(const Point& p) { return {Kernel::FT(p.x), Kernel::FT(p.y)}; }

Point exact_point(const Kernel::Point_2& p) { return {CGAL::exact(p.x()), CGAL::exact(p.y())}; }

/// Where curves of different summands meet, computed by us: CGAL 5.5.1 intersects lines in intervals
/// and reads the point even where those overflow and there is none. Few curves meet, since the
/// first proper crossing ends the sweep.
class Traits : public NonCrossingTraits<Kernel> {
  using Base = NonCrossingTraits<Kernel>;

 public:
  class Intersect_2 {
   public:
    template <typename OutputIterator>
    OutputIterator operator()(const X_monotone_curve_2& a, const X_monotone_curve_2& b,
                              OutputIterator out) const {
      if (a.chain() == b.chain() && a.chain() != no_chain) return out;
      if (!CGAL::do_intersect(Kernel::Segment_2(a), Kernel::Segment_2(b))) return out;
      const Segment s{exact_point(a.source()), exact_point(a.target())};
      const Segment t{exact_point(b.source()), exact_point(b.target())};
      const std::vector<Point> common = intersection(s, t);
      OPLUS_ENSURES(common.size() == 1, "strands do not overlap");
      *out++ = std::pair<Point_2, Multiplicity>(kernel_point(common.front()), 1);
      return out;
    }
  };
  Intersect_2 intersect_2_object() const { return {}; }
};

/// How the boundary of a summand runs along a strand: whether in its direction, and which chain.
struct Run {
  bool along;
  std::size_t chain;
};

/// For each summand, how it runs along a strand, if it does.
using Runs = std::array<std::optional<Run>, 2>;

/// Told by CGAL's sweep what it meets; stops it at the first common interior.
class Visitor : public CGAL::Surface_sweep_2::Default_visitor<Visitor, Traits> {
  using Base = CGAL::Surface_sweep_2::Default_visitor<Visitor, Traits>;

 public:
  using typename Base::Event;
  using typename Base::Status_line_iterator;
  using typename Base::Subcurve;

  Visitor(const std::vector<Runs>& runs_along_strand, TouchedChains& touched)
      : runs_along_strand_(runs_along_strand), touched_(touched) {}

  bool interiors_meet() const { return interiors_meet_; }

  using Base::update_event;
  /// The interiors of two curves intersect. They are not of one summand, and each has the interior
  /// of its own on one side, all along.
  void update_event(Event*, Subcurve*, Subcurve*, bool) { interiors_meet_ = true; }

  bool after_handle_event(Event* event, Status_line_iterator, bool) {
    interiors_meet_ = interiors_meet_ || meet_at(*event);
    if (interiors_meet_) stop_sweep();
    return true;  // the sweep may forget the event
  }

 private:
  const Runs& runs(const Subcurve* curve) const {
    return runs_along_strand_[curve->last_curve().strand()];
  }

  /// The order in which the sweep keeps the curves of an event is their order around it.
  bool meet_at(Event& event) {
    rays_.clear();
    std::array<bool, 2> has_ray{false, false};
    const auto add = [&](const Subcurve* curve, bool to_the_right) {
      InteriorSides& sides = rays_.emplace_back();
      for (const std::size_t of : {0U, 1U}) {
        const std::optional<Run>& run = runs(curve)[of];
        if (!run) continue;
        sides[of] = run->along == to_the_right;
        has_ray[of] = true;
      }
    };
    for (auto curve = event.right_curves_begin(); curve != event.right_curves_end(); ++curve)
      add(*curve, true);
    for (auto curve = event.left_curves_rbegin(); curve != event.left_curves_rend(); ++curve)
      add(*curve, false);
    if (!has_ray[0] || !has_ray[1]) return false;
    remember_chains(event);
    return !OPLUS_MUTANT(
               "sweep-ignores-weak-intersections",
               "boundaries that meet without a proper crossing are taken to touch only, by the sweep") &&
           is_sector_inside_both(rays_);
  }

  void remember_chains(Event& event) {
    const auto remember = [&](const Subcurve* curve) {
      for (const std::size_t of : {0U, 1U})
        if (const std::optional<Run>& run = runs(curve)[of]) touched_[of][run->chain] = true;
    };
    std::for_each(event.left_curves_begin(), event.left_curves_end(), remember);
    std::for_each(event.right_curves_begin(), event.right_curves_end(), remember);
  }

  const std::vector<Runs>& runs_along_strand_;
  TouchedChains& touched_;
  std::vector<InteriorSides> rays_;  ///< of one event; kept for its memory
  bool interiors_meet_ = false;
};

/// The slope of a segment, as a vector to the right or up.
Vector slope_of(const Segment& s) {
  return s.source < s.target ? direction_of(s) : -direction_of(s);
}

struct BySlope {
  bool operator()(const Vector& a, const Vector& b) const { return sign(cross(a, b)) > 0; }
};

/// Which of the pieces are parallel to some of the others, so that they may overlap one.
std::vector<bool> parallel_to_some(const SegmentTree& pieces, const SegmentTree& others) {
  std::set<Vector, BySlope> slopes;
  for (std::size_t i = 0; i < others.size(); ++i) slopes.insert(slope_of(others[i]));
  std::vector<bool> parallel;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    parallel.push_back(slopes.contains(slope_of(pieces[i])));
  return parallel;
}

class SweepCollision : public CollisionTest {
 public:
  SweepCollision(const Region& p, const Region& q)
      : boundaries_{SummandBoundary(p), SummandBoundary(reflected(q))},
        may_overlap_{parallel_to_some(boundaries_[0].pieces, boundaries_[1].pieces),
                     parallel_to_some(boundaries_[1].pieces, boundaries_[0].pieces)} {}

  bool interiors_meet_at(const Point& x) override {
    find_curves(x);
    if (some_overlap_shows_common_interior()) return true;
    TouchedChains touched = untouched(boundaries_[0], boundaries_[1]);
    Visitor visitor(runs_along_strand_, touched);
    CGAL::Surface_sweep_2::Surface_sweep_2<Visitor> sweep(&visitor);
    sweep.sweep(curves_.begin(), curves_.end());
    return visitor.interiors_meet() ||
           one_contains_untouched_chain(boundaries_[0], boundaries_[1], x, touched);
  }

 private:
  /// Finds the strands of both boundaries. Slopes do not depend on x, so only pieces that have a
  /// parallel one in the other boundary are looked at together.
  void find_curves(const Point& x) {
    runs_along_strand_.clear();
    curves_.clear();
    std::vector<Segment> parallel;
    std::vector<std::pair<std::size_t, std::size_t>> whose;  // summand and chain
    for (const std::size_t of : {0U, 1U}) {
      const SummandBoundary& boundary = boundaries_[of];
      for (std::size_t i = 0; i < boundary.pieces.size(); ++i) {
        const Segment piece = of == 0 ? boundary.pieces[i] : translated(boundary.pieces[i], x);
        if (may_overlap_[of][i]) {
          parallel.push_back(piece);
          whose.emplace_back(of, boundary.chain_of[i]);
        } else {
          Runs runs;
          runs[of] = {piece.source < piece.target, boundary.chain_of[i]};
          add_curve(piece, runs);
        }
      }
    }
    for (const Strand& strand : strands(parallel)) {
      Runs runs;
      const auto add_runs = [&](const std::vector<std::uint32_t>& pieces, bool along) {
        for (const std::uint32_t i : pieces) {
          const auto& [of, chain] = whose[i];
          runs[of] = {along, chain};
        }
      };
      add_runs(strand.along, true);
      add_runs(strand.against, false);
      add_curve(strand.segment, runs);
    }
  }

  /// A strand of one summand is a part of a translated chain, as far as the traits care: it does
  /// not cross any other strand of that summand. One of both crosses nothing.
  void add_curve(const Segment& strand, const Runs& runs) {
    const TranslatedChain label = runs[0] && runs[1] ? no_chain : runs[0] ? 1 : 2;
    curves_.emplace_back(
        CGAL::Arr_segment_2<Kernel>(kernel_point(strand.source), kernel_point(strand.target)),
        label, static_cast<std::uint32_t>(runs_along_strand_.size()));
    runs_along_strand_.push_back(runs);
  }

  /// Where the summands run in one direction, both interiors are to the left.
  bool some_overlap_shows_common_interior() const {
    return std::any_of(runs_along_strand_.begin(), runs_along_strand_.end(), [](const Runs& runs) {
      return runs[0] && runs[1] &&
             (runs[0]->along == runs[1]->along ||
              OPLUS_MUTANT(
                  "sweep-forgets-overlap-direction",
                  "edges that overlap in opposite directions are taken for common interior"));
    });
  }

  std::array<SummandBoundary, 2> boundaries_;  ///< of P and of -Q
  std::array<std::vector<bool>, 2> may_overlap_;
  // Of one query; kept for their memory.
  std::vector<Runs> runs_along_strand_;
  std::vector<Traits::X_monotone_curve_2> curves_;
};

}  // namespace

std::unique_ptr<CollisionTest> sweep_collision(const Region& p, const Region& q) {
  return std::make_unique<SweepCollision>(p, q);
}

}  // namespace oplus
