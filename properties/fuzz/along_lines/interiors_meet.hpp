// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "properties/fuzz/along_lines/vertices.hpp"

/// Whether the interiors of P and -Q + x meet, as collision.hpp defines it, in integers.
namespace oplus::along_lines {

template <typename T>
struct Edge {
  Vec<T> source, target;
};

template <typename T>
bool cross_properly(const Edge<T>& e, const Edge<T>& f) {
  const Vec<T>&a = e.source, &b = e.target, &c = f.source, &d = f.target;
  if ((a.x <= c.x && a.x <= d.x && b.x <= c.x && b.x <= d.x) ||
      (a.x >= c.x && a.x >= d.x && b.x >= c.x && b.x >= d.x))
    return false;
  const auto side = [](const Vec<T>& from, const Vec<T>& to, const Vec<T>& v) {
    return sign_of(skew(to - from, v - from));
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/// Whether a piece of a boundary shows common interior: it is inside the region of these edges, or runs
/// along one of them in the same direction. Requires: it has no end of one of them inside it.
template <typename T>
bool shows_common_interior(const Vec<T>& source, const Vec<T>& target,
                           const std::vector<Edge<T>>& edges) {
  const Vec<T> twice_middle = source + target;
  int winding = 0;
  for (const Edge<T>& e : edges) {
    const Vec<T> from = e.source + e.source - twice_middle, to = e.target + e.target - twice_middle;
    const bool up = from.y <= 0 && to.y > 0, down = from.y > 0 && to.y <= 0;
    const bool is_level = from.y == 0 && to.y == 0;
    if (!up && !down && !is_level) continue;
    const int side = sign_of(skew(from, to));
    if (side == 0 && scalar(from, to) <= 0) return scalar(to - from, target - source) > 0;
    if (up && side > 0) ++winding;
    if (down && side < 0) --winding;
  }
  return winding > 0;
}

/// Whether a piece of a's boundary shows common interior.
template <typename T>
bool boundary_enters(const std::vector<Edge<T>>& a, const std::vector<Edge<T>>& b) {
  std::vector<Vec<T>> ends;
  for (const Edge<T>& e : a) {
    const Vec<T> d = e.target - e.source;
    ends.assign({e.source, e.target});
    for (const Edge<T>& f : b) {
      const Vec<T> to = f.source - e.source;
      if (sign_of(skew(d, to)) == 0 && scalar(to, f.source - e.target) < 0)
        ends.push_back(f.source);
    }
    if (ends.size() > 2)
      std::sort(ends.begin(), ends.end(),
                [&](const Vec<T>& v, const Vec<T>& w) { return scalar(d, v - w) < 0; });
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      if ((ends[i].x != ends[i + 1].x || ends[i].y != ends[i + 1].y) &&
          shows_common_interior(ends[i], ends[i + 1], b))
        return true;
  }
  return false;
}

/// Of two regions. Requires: no vertex of one is inside an edge of the same.
template <typename T>
bool interiors_meet(const std::vector<Edge<T>>& a, const std::vector<Edge<T>>& b) {
  for (const Edge<T>& e : a)
    for (const Edge<T>& f : b)
      if (cross_properly(e, f)) return true;
  return boundary_enters(a, b) || boundary_enters(b, a);
}

/// Of P and -Q + x / factor.
template <typename Number, typename T>
bool interiors_meet(const VertexSums<T>& sums, const Vec<Number>& x, const Number& factor) {
  const auto times_factor = [&](const Vec<T>& v) {
    return Vec<Number>{Number(factor * number<Number>(v.x)), Number(factor * number<Number>(v.y))};
  };
  std::vector<Edge<Number>> a, b;
  for (const auto& [from, to] : sums.p.pieces)
    a.push_back({times_factor(sums.p.at[from]), times_factor(sums.p.at[to])});
  for (const auto& [from, to] : sums.q.pieces)
    b.push_back({x - times_factor(sums.q.at[from]), x - times_factor(sums.q.at[to])});
  return interiors_meet(a, b);
}

/// Whether two edges certainly cross properly; false says nothing.
template <typename T>
bool doubles_see_them_meet(const VertexSums<T>& sums, const Vec<double>& x) {
  const double error = sums.largest * sums.largest * 1e-13;
  const auto side = [&](const Vec<double>& a, const Vec<double>& b, const Vec<double>& c) {
    return certain_sign(skew(b - a, c - a), error);
  };
  for (const auto& [from_of_p, to_of_p] : sums.p.pieces) {
    const Vec<double>&a = sums.p.near[from_of_p], &b = sums.p.near[to_of_p];
    for (const auto& [from_of_q, to_of_q] : sums.q.pieces) {
      const Vec<double> c = x - sums.q.near[from_of_q], d = x - sums.q.near[to_of_q];
      if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return true;
    }
  }
  return false;
}

/// The bits of coordinates of which twice the differences have a skew product in 64 and 128 bits.
inline constexpr std::size_t most_bits_in_64 = 27, most_bits_in_128 = 59;

/// At a point of the frame, whose coordinates have at most so many bits.
template <typename T>
bool interiors_meet_at(const VertexSums<T>& sums, const Vec<T>& x, std::size_t bits) {
  const auto in = [&]<typename Number>(Number one) {
    return interiors_meet<Number>(sums, {number<Number>(x.x), number<Number>(x.y)}, one);
  };
  if (bits <= most_bits_in_64) return in(std::int64_t(1));
  if (doubles_see_them_meet(sums, {as_double(x.x), as_double(x.y)})) return true;
  return bits <= most_bits_in_128 ? in(Int128(1)) : in(mpz_class(1));
}

template <typename T>
bool interiors_meet_at(const VertexSums<T>& sums, const Point& x, std::size_t bits) {
  if (doubles_see_them_meet(sums, {x.x.get_d(), x.y.get_d()})) return true;
  const mpz_class factor = lcm(x.x.get_den(), x.y.get_den());
  const Point times_factor = Rational(factor) * x;
  const auto in = [&]<typename Number>(Number /*type*/) {
    return interiors_meet<Number>(
        sums, {number<Number>(times_factor.x.get_num()), number<Number>(times_factor.y.get_num())},
        number<Number>(factor));
  };
  return bits + mpz_sizeinbase(factor.get_mpz_t(), 2) <= most_bits_in_128 ? in(Int128(0))
                                                                          : in(mpz_class(0));
}

}  // namespace oplus::along_lines
