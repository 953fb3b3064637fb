// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/version.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/variant.hpp>
#include <cstdint>
#include <utility>
#include <variant>

#include "reference/definitions/contract.hpp"

namespace oplus {

/// Of Boost, and from CGAL 6 on of std.
namespace variants {
#if CGAL_VERSION_MAJOR < 6
using boost::variant;
template <typename T, typename... Ts>
const T* get_if(const variant<Ts...>* value) {
  return boost::get<T>(value);
}
#else
using std::get_if;
using std::variant;
#endif
}  // namespace variants

/// Says which translated chain a curve is a part of. Parts of one translated chain never cross: the
/// chain is simple.
using TranslatedChain = std::uint32_t;
inline constexpr TranslatedChain no_chain = 0;

/// Segment traits that never test two parts of one translated chain for an intersection (thesis,
/// Section 7.2.1): they can only meet in a common end, which the sweep sees without a test. Parts
/// keep their labels, so the arrangement needs no history.
/// Requires: curves do not overlap (strands.hpp).
template <typename Kernel>
class NonCrossingTraits : public CGAL::Arr_segment_traits_2<Kernel> {
  using Base = CGAL::Arr_segment_traits_2<Kernel>;
  using BaseCurve = typename Base::X_monotone_curve_2;

 public:
  using typename Base::Multiplicity;
  using typename Base::Point_2;
  using Has_merge_category = CGAL::Tag_false;

  /// A segment, or a part of one, that knows its chain and which strand it is from.
  class X_monotone_curve_2 : public BaseCurve {
   public:
    X_monotone_curve_2() = default;
    explicit X_monotone_curve_2(const BaseCurve& curve, TranslatedChain chain = no_chain,
                                std::uint32_t strand = 0)
        : BaseCurve(curve), chain_(chain), strand_(strand) {}

    TranslatedChain chain() const { return chain_; }
    std::uint32_t strand() const { return strand_; }

   private:
    TranslatedChain chain_ = no_chain;
    std::uint32_t strand_ = 0;
  };
  using Curve_2 = X_monotone_curve_2;

  class Split_2 {
   public:
    explicit Split_2(const Base& base) : base_(base) {}
    void operator()(const X_monotone_curve_2& curve, const Point_2& at, X_monotone_curve_2& left,
                    X_monotone_curve_2& right) const {
      left = right = curve;  // keeps chain and strand
      base_.split_2_object()(curve, at, left, right);
    }

   private:
    const Base& base_;
  };
  Split_2 split_2_object() const { return Split_2(*this); }

  class Intersect_2 {
   public:
    explicit Intersect_2(const Base& base) : base_(base) {}

    template <typename OutputIterator>
    OutputIterator operator()(const X_monotone_curve_2& a, const X_monotone_curve_2& b,
                              OutputIterator out) const {
      if (a.chain() != no_chain && a.chain() == b.chain()) return out;
      using MeetingPoint = std::pair<Point_2, Multiplicity>;
      const auto add = [&](const variants::variant<MeetingPoint, BaseCurve>& meeting) {
        const auto* at = variants::get_if<MeetingPoint>(&meeting);
        OPLUS_REQUIRES(at != nullptr, "strands do not overlap");
        if (at != nullptr) *out++ = *at;
      };
      base_.intersect_2_object()(a, b, boost::make_function_output_iterator(add));
      return out;
    }

   private:
    const Base& base_;
  };
  Intersect_2 intersect_2_object() const { return Intersect_2(*this); }
};

}  // namespace oplus
