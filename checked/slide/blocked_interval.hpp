// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "checked/slide/fraction.hpp"
#include "checked/slide/integer_vector.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus::slide {

/// Open.
template <typename Numbers>
struct BlockedInterval {
  Fraction<Numbers> from;
  Fraction<Numbers> to;

  /// Whether the whole segment, its ends too, is inside.
  bool contains_segment() const {
    return from.numerator() < 0 && to.denominator() < to.numerator();
  }
};

/// Whether x(t) is shifted by an infinitesimal to the segment's right before it is asked whether it
/// is blocked.
enum class Shift { none, to_the_right };

namespace detail {

/// What strips of the plane leave of a line, as Result has it.
template <typename Numbers, typename Result>
class Strips {
 public:
  using Value = typename Numbers::Value;

  /// Cuts to where 0 < constant + t slope < limit. `nudge` is the sign of what a shift adds to the
  /// constant; it matters only where the line is parallel to the strip. Returns whether something
  /// may be left.
  bool cut(const Value& constant, const Value& slope, const Value& limit, int nudge) {
    if (slope == 0) {
      if (constant == 0) return nudge > 0;
      if (constant == limit) return nudge < 0;
      return constant > 0 && constant < limit;
    }
    if (slope > 0) return cut({-constant, slope}, {limit - constant, slope});
    return cut({constant - limit, -slope}, {constant, -slope});
  }

  std::optional<BlockedInterval<Result>>& left() { return left_; }

 private:
  bool cut(const Fraction<Result>& from, const Fraction<Result>& to) {
    if (!left_) {
      left_ = {from, to};
      return true;
    }
    if (left_->from < from) left_->from = from;
    if (to < left_->to) left_->to = to;
    return left_->from < left_->to;
  }

  std::optional<BlockedInterval<Result>> left_;
};

/// Segments whose x, and whose y, are multiplied by the common denominator of theirs: so no quotient of
/// skew products changes. Integers are faster than rationals, which are reduced after each operation.
template <std::size_t n>
const std::array<IntegerSegment<AnyNumbers>, n>& with_common_denominators(
    const std::array<const IntegerSegment<RationalNumbers>*, n>& segments) {
  using Integer = AnyNumbers::Value;
  // Kept, since it would take as long to allocate the numbers as to compute them.
  thread_local std::array<IntegerSegment<AnyNumbers>, n> result;
  const auto scale = [&](auto coordinate_of) {
    const auto each = [&](const auto& visit) {
      for (std::size_t i = 0; i < n; ++i) {
        visit(coordinate_of(segments[i]->source), coordinate_of(result[i].source));
        visit(coordinate_of(segments[i]->direction), coordinate_of(result[i].direction));
      }
    };
    Integer common = 1;
    mpz_ptr multiple = common.backend().data();
    each([&](const RationalNumbers::Value& value, const Integer&) {
      mpz_lcm(multiple, multiple, mpq_denref(value.backend().data()));
    });
    each([&](const RationalNumbers::Value& value, Integer& scaled) {
      mpq_srcptr quotient = value.backend().data();
      mpz_ptr product = scaled.backend().data();
      mpz_divexact(product, multiple, mpq_denref(quotient));
      mpz_mul(product, product, mpq_numref(quotient));
    });
  };
  scale([](auto& v) -> auto& { return v.x; });
  scale([](auto& v) -> auto& { return v.y; });
  return result;
}

}  // namespace detail

/// The places on the line of a segment at which an edge of P and one of -Q + x(t) cross properly:
/// where x(t), shifted, is inside the sum of the edge of P and that of Q, a parallelogram. It is one
/// open interval, or empty; of infinitesimal length counts as empty.
template <typename Numbers, typename Result = Numbers>
requires(!is_rational<Numbers>) std::optional<BlockedInterval<Result>> blocked_interval(
    const IntegerSegment<Numbers>& segment, const IntegerSegment<Numbers>& of_p,
    const IntegerSegment<Numbers>& of_q, Shift shift) {
  using Value = typename Numbers::Value;
  // x = of_p.source + of_q.source + a u + b w, where 0 < a < 1 and 0 < b < 1 inside.
  const auto& u = of_p.direction;
  const auto& w = of_q.direction;
  const auto& d = segment.direction;
  Value area = cross(u, w);
  if (area == 0) return std::nullopt;
  const bool mirrored = area < 0;
  if (mirrored) area = -area;
  const auto from_corner = segment.source - of_p.source - of_q.source;
  const auto turned = [&](const Value& value) { return mirrored ? Value(-value) : value; };
  // The right normal n has [n, w] = d w and [u, n] = -d u.
  const auto nudge = [&](const IntegerVector<Numbers>& along, int which) {
    if (shift == Shift::none) return 0;
    const int inwards = which * sign_of(dot(d, along)) * (mirrored ? -1 : 1);
    return OPLUS_MUTANT("slide-shifts-to-the-left",
                        "the infinitesimal shift is to the left of the segment")
               ? -inwards
               : inwards;
  };
  detail::Strips<Numbers, Result> strips;
  const Value slope_a = cross(d, w);
  if (!strips.cut(turned(cross(from_corner, w)), turned(slope_a), area,
                  slope_a == 0 ? nudge(w, 1) : 0))
    return std::nullopt;
  const Value slope_b = cross(u, d);
  if (!strips.cut(turned(cross(u, from_corner)), turned(slope_b), area,
                  slope_b == 0 ? nudge(u, -1) : 0))
    return std::nullopt;
  return std::move(strips.left());
}

inline std::optional<BlockedInterval<RationalNumbers>> blocked_interval(
    const IntegerSegment<RationalNumbers>& segment, const IntegerSegment<RationalNumbers>& of_p,
    const IntegerSegment<RationalNumbers>& of_q, Shift shift) {
  const std::array all{&segment, &of_p, &of_q};
  const auto& scaled = detail::with_common_denominators(all);
  return blocked_interval<AnyNumbers, RationalNumbers>(scaled[0], scaled[1], scaled[2], shift);
}

}  // namespace oplus::slide
