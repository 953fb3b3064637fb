// SPDX-License-Identifier: MIT
#pragma once

#include <numeric>
#include <optional>

#include "checked/arithmetic/set_integer.hpp"
#include "checked/slide/fraction.hpp"
#include "checked/slide/integer_summands.hpp"
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

/// x(t), ordered as in the plane. Coordinates are reduced to lowest terms only when they are put into a
/// point: several pieces end in most of them.
template <typename Numbers>
class ExactPoint {
 public:
  ExactPoint() = default;
  ExactPoint(const IntegerSegment<Numbers>& segment, const Fraction<Numbers>& t)
      : point_{coordinate(segment.source.x, segment.direction.x, t),
               coordinate(segment.source.y, segment.direction.y, t)} {}

  /// Coordinates in units of 2^shift, off by less than one in 2^50.
  double near_x(const Scaling& scaling) const { return near(point_.x, scaling); }
  double near_y(const Scaling& scaling) const { return near(point_.y, scaling); }

  void put_into(Point& point, const Scaling& scaling) const {
    point = point_;
    point.x.canonicalize();
    point.y.canonicalize();
    scaling.put_back(point);
  }

  Point in_the_plane(const Scaling& scaling) const {
    Point point;
    put_into(point, scaling);
    return point;
  }

  bool has_x_of(const ExactPoint& other) const { return cmp(point_.x, other.point_.x) == 0; }

  friend bool operator==(const ExactPoint& a, const ExactPoint& b) {
    return a.has_x_of(b) && cmp(a.point_.y, b.point_.y) == 0;
  }
  friend bool operator<(const ExactPoint& a, const ExactPoint& b) {
    const int order = cmp(a.point_.x, b.point_.x);
    return order != 0 ? order < 0 : cmp(a.point_.y, b.point_.y) < 0;
  }

 private:
  using Value = typename Numbers::Value;

  /// source + t direction, not in lowest terms.
  static Rational coordinate(const Value& source, const Value& direction,
                             const Fraction<Numbers>& t) {
    Rational result = rational(source);
    if (t.numerator() == 0 || direction == 0) return result;
    Rational more = rational(direction);
    const Rational n = rational(t.numerator()), d = rational(t.denominator());
    if (n != d) {
      more.get_num() *= n.get_num() * d.get_den();
      more.get_den() *= n.get_den() * d.get_num();
    }
    result.get_num() *= more.get_den();
    result.get_num() += more.get_num() * result.get_den();
    result.get_den() *= more.get_den();
    return result;
  }

  static double near(Rational coordinate, const Scaling& scaling) {
    mpq_div_2exp(coordinate.get_mpq_t(), coordinate.get_mpq_t(), scaling.shift);
    return coordinate.get_d();
  }

  Point point_;
};

template <>
class ExactPoint<SmallNumbers> {
 public:
  ExactPoint() = default;
  ExactPoint(const IntegerSegment<SmallNumbers>& segment, const Fraction<SmallNumbers>& t) {
    Value n = t.numerator(), d = t.denominator();
    if (d != 1) {
      const Value common = std::gcd(n, d);
      n /= common;
      d /= common;
    }
    x_ = coordinate(segment.source.x, segment.direction.x, n, d);
    y_ = coordinate(segment.source.y, segment.direction.y, n, d);
  }

  double near_x(const Scaling& /*has no shift*/) const { return x_.near(); }
  double near_y(const Scaling& /*has no shift*/) const { return y_.near(); }

  /// The point in the plane, without a point to be allocated.
  void put_into(Point& point, const Scaling& scaling) const {
    x_.put_into(point.x);
    y_.put_into(point.y);
    if (!scaling.is_trivial()) scaling.put_back(point);
  }

  Point in_the_plane(const Scaling& scaling) const {
    Point point;
    put_into(point, scaling);
    return point;
  }

  bool has_x_of(const ExactPoint& other) const { return x_ == other.x_; }

  friend bool operator==(const ExactPoint& a, const ExactPoint& b) {
    return a.x_ == b.x_ && a.y_ == b.y_;
  }
  friend bool operator<(const ExactPoint& a, const ExactPoint& b) {
    return a.x_ == b.x_ ? a.y_ < b.y_ : a.x_ < b.x_;
  }

  /// Whether x is on the segment from a to b; no answer where one of them has a denominator.
  static std::optional<bool> lies_between_integers(const ExactPoint& x, const ExactPoint& a,
                                                   const ExactPoint& b) {
    for (const ExactPoint* point : {&x, &a, &b})
      if (point->x_.denominator != 1 || point->y_.denominator != 1) return std::nullopt;
    const Product ux = b.x_.numerator - a.x_.numerator, uy = b.y_.numerator - a.y_.numerator;
    const Product vx = x.x_.numerator - a.x_.numerator, vy = x.y_.numerator - a.y_.numerator;
    if (ux * vy != uy * vx) return false;
    const Product along = ux * vx + uy * vy;
    return along >= 0 && along <= ux * ux + uy * uy;
  }

 private:
  using Value = SmallNumbers::Value;
  using Product = SmallNumbers::Product;

  struct Coordinate {
    Product numerator = 0;
    Value denominator = 1;

    friend bool operator==(const Coordinate&, const Coordinate&) = default;
    /// By what is before the point, then by what is behind it: a product of both numbers of different
    /// coordinates may not fit.
    bool operator<(const Coordinate& other) const {
      const Product before = floor(), other_before = other.floor();
      if (before != other_before) return before < other_before;
      return (numerator - before * denominator) * other.denominator <
             (other.numerator - other_before * other.denominator) * denominator;
    }

    Product floor() const {
      const Product towards_zero = numerator / denominator;
      return towards_zero * denominator > numerator ? towards_zero - 1 : towards_zero;
    }

    double near() const {
      if (const auto value = static_cast<Value>(numerator); value == numerator && denominator == 1)
        return static_cast<double>(value);
      return static_cast<double>(numerator) / static_cast<double>(denominator);
    }

    void put_into(Rational& value) const {
      set_integer(value.get_num_mpz_t(), numerator);
      set_integer(value.get_den_mpz_t(), denominator);
    }
  };

  /// source + direction n / d, where n and d have no common factor.
  static Coordinate coordinate(Value source, Value direction, Value n, Value d) {
    if (d == 1) return {source + Product(direction) * n, 1};
    const Value common = std::gcd(direction, d);
    d /= common;
    return {Product(source) * d + Product(direction / common) * n, d};
  }

  Coordinate x_;
  Coordinate y_;
};

/// Whether x is on the segment from a to b.
template <typename Numbers>
bool lies_between(const ExactPoint<Numbers>& x, const ExactPoint<Numbers>& a,
                  const ExactPoint<Numbers>& b, const Scaling& scaling) {
  if constexpr (is_small<Numbers>) {
    if (const auto answer = ExactPoint<Numbers>::lies_between_integers(x, a, b)) return *answer;
  }
  return lies_on(x.in_the_plane(scaling), {a.in_the_plane(scaling), b.in_the_plane(scaling)});
}

template <typename Numbers>
Segment in_the_plane(const ReducedSegment<Numbers>& segment, const Scaling& scaling) {
  return {ExactPoint<Numbers>(segment.exact, {0, 1}).in_the_plane(scaling),
          ExactPoint<Numbers>(segment.exact, {1, 1}).in_the_plane(scaling)};
}

}  // namespace oplus::slide
