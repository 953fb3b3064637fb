// SPDX-License-Identifier: MIT
#include "checked/slide/scaling.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "checked/slide/number_types.hpp"
#include "reference/definitions/common_denominator.hpp"

namespace oplus::slide {

namespace {

/// As much longer than each number a common denominator may be.
constexpr std::size_t many_times = 4;

/// Coordinates that are longer stay where they are.
constexpr std::size_t most_moved_bits = 256;

std::size_t bits(const mpz_class& value) {
  // Without a call.
  if (mpz_size(value.get_mpz_t()) == 1) return std::bit_width(mpz_getlimbn(value.get_mpz_t(), 0));
  return mpz_sizeinbase(value.get_mpz_t(), 2);
}

/// The middle of the smallest and the largest coordinates.
Scaling::Offset middle(const Extent& extent, const Scaling& scaling) {
  const auto between = [&](const Rational& a, const Rational& b) {
    return mpz_class((scaled(a, scaling, 0) + scaled(b, scaling, 0)) / 2);
  };
  return {between(extent.low.x, extent.high.x), between(extent.low.y, extent.high.y)};
}

std::size_t largest_bits(const Extent& extent, const Scaling& scaling,
                         const Scaling::Offset& offset) {
  std::size_t largest = 1;
  for (const Point* corner : {&extent.low, &extent.high})
    largest = std::max({largest, bits(scaled(corner->x, scaling, offset.x)),
                        bits(scaled(corner->y, scaling, offset.y))});
  return largest;
}

}  // namespace

void Scaling::put_back(Point& point) const {
  const auto put_back = [&](Rational& c, const mpz_class& first, const mpz_class& second) {
    if (is_moved)
      for (const mpz_class* offset : {&first, &second})
        mpz_addmul(c.get_num_mpz_t(), c.get_den_mpz_t(), offset->get_mpz_t());
    if (!is_one(denominator)) c.get_den() *= denominator;
    if (!is_one(c.get_den())) c.canonicalize();
  };
  put_back(point.x, of_p.x, of_q.x);
  put_back(point.y, of_p.y, of_q.y);
}

mpz_class scaled(const Rational& coordinate, const Scaling& scaling, const mpz_class& offset) {
  mpz_class value;
  mpz_divexact(value.get_mpz_t(), scaling.denominator.get_mpz_t(), coordinate.get_den_mpz_t());
  value *= coordinate.get_num();
  value -= offset;
  return value;
}

Extent extent_of(const Region& region, Denominators denominators) {
  Extent extent;
  bool is_first = true;
  each_vertex(region, [&](const Point& v) {
    if (std::exchange(is_first, false)) extent.low = extent.high = v;
    for (const auto c : {&Point::x, &Point::y}) {
      if (v.*c < extent.low.*c) extent.low.*c = v.*c;
      if (extent.high.*c < v.*c) extent.high.*c = v.*c;
      if (const mpz_class& denominator = (v.*c).get_den(); !is_one(denominator))
        extent.longest = std::max({extent.longest, bits((v.*c).get_num()), bits(denominator)});
    }
  });
  const std::size_t most_bits = denominators == Denominators::any
                                    ? std::numeric_limits<std::size_t>::max()
                                    : many_times * extent.longest;
  extent.is_unlike = !add_denominators(extent.denominator, region, most_bits);
  return extent;
}

bool has_unlike_denominators(const Extent& p, const Extent& q) {
  if (p.is_unlike || q.is_unlike) return true;
  mpz_class common;
  mpz_lcm(common.get_mpz_t(), p.denominator.get_mpz_t(), q.denominator.get_mpz_t());
  return bits(common) > many_times * std::max(p.longest, q.longest);
}

Scaling scaling_of(const Extent& p, const Extent& q) {
  Scaling scaling;
  mpz_lcm(scaling.denominator.get_mpz_t(), p.denominator.get_mpz_t(), q.denominator.get_mpz_t());
  const auto largest = [&] {
    return std::max(largest_bits(p, scaling, scaling.of_p), largest_bits(q, scaling, scaling.of_q));
  };
  scaling.bits = largest();
  if (scaling.bits > SmallNumbers::bits) {
    scaling.of_p = middle(p, scaling);
    scaling.of_q = middle(q, scaling);
    scaling.is_moved = true;
    const std::size_t bits_unmoved = std::exchange(scaling.bits, largest());
    if (scaling.bits > most_moved_bits) {
      // Small coordinates would be as long as large ones.
      scaling.of_p = scaling.of_q = {};
      scaling.is_moved = false;
      scaling.bits = bits_unmoved;
    }
  }
  scaling.shift = scaling.bits > 60 ? scaling.bits - 60 : 0;
  return scaling;
}

std::size_t bits_of_integers(const Region& region) {
  std::size_t largest = 1;
  each_vertex(region, [&](const Point& v) {
    for (const Rational* c : {&v.x, &v.y})
      largest = largest == 0 || !is_one(c->get_den()) ? 0 : std::max(largest, bits(c->get_num()));
  });
  return largest;
}

Scaling scaling_of_rationals(const Region& p, const Region& q) {
  constexpr long bits_wanted = 62;
  long bits_now = std::numeric_limits<long>::min();
  for (const Region* region : {&p, &q})
    each_vertex(*region, [&](const Point& v) {
      for (const Rational* c : {&v.x, &v.y})
        if (*c != 0)
          bits_now = std::max(bits_now, static_cast<long>(bits(c->get_num())) -
                                            static_cast<long>(bits(c->get_den())) + 1);
    });
  Scaling scaling;
  const long more = std::max(0L, bits_wanted - bits_now);
  scaling.denominator <<= static_cast<mp_bitcnt_t>(more);
  scaling.bits = static_cast<std::size_t>(bits_now + more);
  scaling.shift = scaling.bits - 60;
  return scaling;
}

}  // namespace oplus::slide
