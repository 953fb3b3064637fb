// SPDX-License-Identifier: MIT
#pragma once

#include <numeric>
#include <optional>

#include "checked/arithmetic/set_integer.hpp"
#include "checked/slide/fraction.hpp"
#include "checked/slide/integer_summands.hpp"
#include "checked/slide/leading_edge.hpp"
#include "reference/definitions/segment.hpp"

namespace oplus::slide {

template <typename Value>
Rational rational(const Value& value) {
  if constexpr (std::is_same_v<Value, boost::multiprecision::mpq_rational>)
    return Rational(value.backend().data());
  else if constexpr (std::is_same_v<Value, WideNumbers::Value>) {
    Rational result;
    set_integer(result.get_num_mpz_t(), value);
    return result;
  } else
    return mpz_class(boost::multiprecision::mpz_int(value).backend().data());
}

template <typename Numbers>
Rational rational(const Fraction<Numbers>& t) {
  return rational(t.numerator()) / rational(t.denominator());
}

namespace detail {

/// source + t direction, a coordinate of x(t), in GMP. Reduced to lowest terms only when it is put into a
/// point: several pieces end in most of them.
template <typename Numbers>
class Coordinate {
 public:
  using Value = typename Numbers::Value;

  Coordinate() = default;
  Coordinate(const Value& source, const Value& direction, const Fraction<Numbers>& t)
      : value_(rational(source)) {
    if (t.numerator() == 0 || direction == 0) return;
    Rational more = rational(direction);
    const Rational n = rational(t.numerator()), d = rational(t.denominator());
    if (n != d) {
      more.get_num() *= n.get_num() * d.get_den();
      more.get_den() *= n.get_den() * d.get_num();
    }
    value_.get_num() *= more.get_den();
    value_.get_num() += more.get_num() * value_.get_den();
    value_.get_den() *= more.get_den();
  }

  friend bool operator==(const Coordinate& a, const Coordinate& b) { return order(a, b) == 0; }
  friend bool operator<(const Coordinate& a, const Coordinate& b) { return order(a, b) < 0; }

  /// Without a scaling, off by at most 2^-50 of its size.
  NearNumber leading() const { return near_number(value_.get_mpq_t()); }

  double near(const Scaling& scaling) const {
    Rational moved;
    mpq_div_2exp(moved.get_mpq_t(), value_.get_mpq_t(), static_cast<mp_bitcnt_t>(scaling.shift));
    return moved.get_d();
  }

  void put_into(Rational& value) const { value = value_; }

 private:
  static int order(const Coordinate& a, const Coordinate& b) {
    const int certain = certain_order(a.leading(), b.leading());
    return certain != 0 ? certain : cmp(a.value_, b.value_);
  }

  Rational value_;
};

/// The same, not in lowest terms either, in integers of fixed width, which need not be allocated.
template <>
class Coordinate<WideNumbers> {
 public:
  /// A product of the numerator of one and the denominator of another has at most 317 bits.
  using Integer = FixedInteger<320>;
  using Value = WideNumbers::Value;

  Coordinate() = default;
  Coordinate(const Value& source, const Value& direction, const Fraction<WideNumbers>& t)
      : numerator(source) {
    if (t.numerator() == 0 || direction == 0) return;
    if (t.numerator() == t.denominator()) {
      numerator = source + direction;
    } else {
      denominator = t.denominator();
      numerator = Integer(source) * denominator + Integer(direction) * Integer(t.numerator());
    }
  }

  friend bool operator==(const Coordinate& a, const Coordinate& b) {
    if (a.denominator == b.denominator) return a.numerator == b.numerator;
    return a.numerator * Integer(b.denominator) == b.numerator * Integer(a.denominator);
  }
  friend bool operator<(const Coordinate& a, const Coordinate& b) {
    return a.numerator * Integer(b.denominator) < b.numerator * Integer(a.denominator);
  }

  double near(const Scaling& scaling) const {
    return std::ldexp(to_double(numerator) / to_double(denominator),
                      -static_cast<int>(scaling.shift));
  }

  void put_into(Rational& value) const {
    const auto& words = numerator.backend();
    set_integer(value.get_num_mpz_t(), words.limbs(), words.size(), words.sign());
    set_integer(value.get_den_mpz_t(), denominator);
  }

  Integer numerator = 0;
  Value denominator = 1;
};

/// In lowest terms, so that equal ones have equal numbers.
template <>
class Coordinate<SmallNumbers> {
 public:
  using Value = SmallNumbers::Value;
  using Integer = SmallNumbers::Product;

  Coordinate() = default;
  /// Requires: t in lowest terms.
  Coordinate(Value source, Value direction, const Fraction<SmallNumbers>& t)
      : denominator(t.denominator()) {
    if (denominator == 1) {
      numerator = source + Integer(direction) * t.numerator();
    } else {
      const Value common = std::gcd(direction, denominator);
      denominator /= common;
      numerator = Integer(source) * denominator + Integer(direction / common) * t.numerator();
    }
  }

  friend bool operator==(const Coordinate&, const Coordinate&) = default;
  /// By what is before the point, then by what is behind it: a product of both numbers of different
  /// coordinates may not fit.
  bool operator<(const Coordinate& other) const {
    const Integer before = floor(), other_before = other.floor();
    if (before != other_before) return before < other_before;
    return (numerator - before * denominator) * other.denominator <
           (other.numerator - other_before * other.denominator) * denominator;
  }

  Integer floor() const {
    const Integer towards_zero = numerator / denominator;
    return towards_zero * denominator > numerator ? towards_zero - 1 : towards_zero;
  }

  double near(const Scaling& /*has no shift*/) const {
    if (const auto value = static_cast<Value>(numerator); value == numerator && denominator == 1)
      return static_cast<double>(value);
    return static_cast<double>(numerator) / static_cast<double>(denominator);
  }

  void put_into(Rational& value) const {
    set_integer(value.get_num_mpz_t(), numerator);
    set_integer(value.get_den_mpz_t(), denominator);
  }

  Integer numerator = 0;
  Value denominator = 1;
};

}  // namespace detail

/// x(t), ordered as in the plane.
template <typename Numbers>
class ExactPoint {
 public:
  ExactPoint() = default;
  ExactPoint(const IntegerSegment<Numbers>& segment, const Fraction<Numbers>& t) {
    if constexpr (is_small<Numbers>) {
      if (t.denominator() != 1) {
        const std::int64_t common = std::gcd(t.numerator(), t.denominator());
        set(segment, {t.numerator() / common, t.denominator() / common});
        return;
      }
    }
    set(segment, t);
  }

  /// Coordinates in units of 2^shift, off by less than one in 2^50.
  double near_x(const Scaling& scaling) const { return x_.near(scaling); }
  double near_y(const Scaling& scaling) const { return y_.near(scaling); }

  /// The point in the plane, without a point to be allocated.
  void put_into(Point& point, const Scaling& scaling) const {
    x_.put_into(point.x);
    y_.put_into(point.y);
    if (!is_small<Numbers> || !scaling.is_trivial()) scaling.put_back(point);
  }

  Point in_the_plane(const Scaling& scaling) const {
    Point point;
    put_into(point, scaling);
    return point;
  }

  bool has_x_of(const ExactPoint& other) const { return x_ == other.x_; }
  bool has_y_of(const ExactPoint& other) const { return y_ == other.y_; }

  friend bool operator==(const ExactPoint& a, const ExactPoint& b) = default;
  friend bool operator<(const ExactPoint& a, const ExactPoint& b) {
    return a.x_ == b.x_ ? a.y_ < b.y_ : a.x_ < b.x_;
  }

  /// Whether x is on the segment from a to b; no answer where one of them has a denominator.
  static std::optional<bool> lies_between_integers(const ExactPoint& x, const ExactPoint& a,
                                                   const ExactPoint& b) requires
      has_fixed_width<Numbers> {
    for (const ExactPoint* point : {&x, &a, &b})
      if (point->x_.denominator != 1 || point->y_.denominator != 1) return std::nullopt;
    using Integer = typename detail::Coordinate<Numbers>::Integer;
    const Integer ux = b.x_.numerator - a.x_.numerator, uy = b.y_.numerator - a.y_.numerator;
    const Integer vx = x.x_.numerator - a.x_.numerator, vy = x.y_.numerator - a.y_.numerator;
    if (ux * vy != uy * vx) return false;
    const Integer along = ux * vx + uy * vy;
    return along >= 0 && along <= ux * ux + uy * uy;
  }

  /// Whether leading digits tell that x is not on the segment from a to b.
  static bool is_certainly_beside(const ExactPoint& x, const ExactPoint& a,
                                  const ExactPoint& b) requires(!has_fixed_width<Numbers>) {
    const auto near = [](const ExactPoint& p) {
      return NearVector{p.x_.leading(), p.y_.leading()};
    };
    const NearVector s = near(a), t = near(b), p = near(x);
    const auto is_beyond = [](const NearNumber& c, const NearNumber& from, const NearNumber& to) {
      return certain_order(c, from) * certain_order(c, to) > 0;
    };
    if (is_beyond(p.x, s.x, t.x) || is_beyond(p.y, s.y, t.y)) return true;
    const auto is_beside = [&](const NearVector& of) {
      const NearNumber error =
          NearNumber{1, -46} * ((abs(t.x) + abs(s.x)) * (abs(p.y) + abs(of.y)) +
                                (abs(t.y) + abs(s.y)) * (abs(p.x) + abs(of.x)));
      return error < abs((t.x - s.x) * (p.y - of.y) - (t.y - s.y) * (p.x - of.x));
    };
    return is_beside(s) || is_beside(t);
  }

 private:
  void set(const IntegerSegment<Numbers>& segment, const Fraction<Numbers>& t) {
    x_ = {segment.source.x, segment.direction.x, t};
    y_ = {segment.source.y, segment.direction.y, t};
  }

  detail::Coordinate<Numbers> x_, y_;
};

/// Whether x is on the segment from a to b.
template <typename Numbers>
bool lies_between(const ExactPoint<Numbers>& x, const ExactPoint<Numbers>& a,
                  const ExactPoint<Numbers>& b, const Scaling& scaling) {
  if constexpr (has_fixed_width<Numbers>) {
    if (const auto answer = ExactPoint<Numbers>::lies_between_integers(x, a, b)) return *answer;
  } else if (ExactPoint<Numbers>::is_certainly_beside(x, a, b)) {
    return false;
  }
  return lies_on(x.in_the_plane(scaling), {a.in_the_plane(scaling), b.in_the_plane(scaling)});
}

template <typename Numbers>
Segment in_the_plane(const ReducedSegment<Numbers>& segment, const Scaling& scaling) {
  return {ExactPoint<Numbers>(segment.exact, {0, 1}).in_the_plane(scaling),
          ExactPoint<Numbers>(segment.exact, {1, 1}).in_the_plane(scaling)};
}

}  // namespace oplus::slide
