// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "properties/fuzz/along_lines/vertices.hpp"

/// Whether the interiors of P and -Q + x meet, in integers: what most vertex sums show at once.
namespace oplus::along_lines {

/// Of three points on a line.
template <typename T>
bool is_between(const Vec<T>& a, const Vec<T>& v, const Vec<T>& b) {
  return scalar(v - a, v - b) < 0;
}

/// Of two segments on a line: equally directed, with more than a point in common.
template <typename T>
bool overlap_alike(const Vec<T>& a, const Vec<T>& b, const Vec<T>& c, const Vec<T>& d) {
  const Vec<T> ab = b - a;
  if (scalar(ab, d - c) <= 0) return false;
  return scalar(ab, d - a) > 0 && scalar(ab, c - b) < 0;
}

/// Whether two edges certainly cross properly. x is in the frame of the sums. False says nothing.
template <typename T>
bool doubles_see_them_meet(const VertexSums<T>& sums, const Vec<double>& x) {
  const double error = sums.largest * sums.largest * 1e-13;
  const auto side = [&](const Vec<double>& a, const Vec<double>& b, const Vec<double>& c) {
    return certain_sign(skew(b - a, c - a), error);
  };
  const Vertices<T>&p = sums.p, &q = sums.q;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.is_touched[i]) continue;
    const Vec<double>& a = p.near[i];
    const Vec<double>& b = p.near[p.next[i]];
    for (std::size_t j = 0; j < q.size(); ++j) {
      const Vec<double> c = x - q.near[j], d = x - q.near[q.next[j]];
      if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0 &&
          !q.is_touched[j])
        return true;
    }
  }
  return false;
}

/// Whether pairs of edges show that they meet. False says nothing.
template <typename T>
bool edges_show_them_meet(const VertexSums<T>& sums, const Vec<T>& x) {
  const Vertices<T>&p = sums.p, &q = sums.q;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec<T>& a = p.at[i];
    const Vec<T>& b = p.at[p.next[i]];
    const Vec<T> ab = b - a;
    for (std::size_t j = 0; j < q.size(); ++j) {
      const Vec<T> c = x - q.at[j], d = x - q.at[q.next[j]];
      // Apart in x?
      if ((a.x <= c.x && a.x <= d.x && b.x <= c.x && b.x <= d.x) ||
          (a.x >= c.x && a.x >= d.x && b.x >= c.x && b.x >= d.x)) {
        if (!(a.x == b.x && c.x == d.x && a.x == c.x)) continue;
      }
      const int side_of_c = sign_of(skew(ab, c - a));
      const int side_of_d = sign_of(skew(ab, d - a));
      if (side_of_c == 0 && side_of_d == 0) {
        if (overlap_alike(a, b, c, d)) return true;
        continue;
      }
      // An edge that leaves a point inside another to the left has its own left side there.
      const bool c_enters = side_of_c == 0 && side_of_d > 0,
                 d_enters = side_of_d == 0 && side_of_c > 0;
      if ((c_enters || d_enters) && !p.is_touched[i] && is_between(a, c_enters ? c : d, b))
        return true;
      if (side_of_c * side_of_d > 0 || q.is_touched[j]) continue;
      const Vec<T> cd = d - c;
      const int side_of_a = sign_of(skew(cd, a - c)), side_of_b = sign_of(skew(cd, b - c));
      const bool a_enters = side_of_a == 0 && side_of_b > 0,
                 b_enters = side_of_b == 0 && side_of_a > 0;
      if ((a_enters || b_enters) && is_between(c, a_enters ? a : b, d)) return true;
      if (side_of_c * side_of_d < 0 && side_of_a * side_of_b < 0 && !p.is_touched[i]) return true;
    }
  }
  return false;
}

/// Whether a vertex, or the middle of an edge, of one summand is inside the other. Both times 1 or -1, moved.
template <typename T>
bool enters(const Vertices<T>& a, int times_a, const Vec<T>& by_a, const Vertices<T>& b,
            int times_b, const Vec<T>& by_b) {
  const auto twice = [](const Vec<T>& v, const Vec<T>& w, int times, const Vec<T>& by) {
    return Vec<T>{T(times * (v.x + w.x) + 2 * by.x), T(times * (v.y + w.y) + 2 * by.y)};
  };
  for (std::size_t i = 0; i < a.size(); ++i)
    for (const std::size_t k : {i, a.next[i]}) {
      const Vec<T> at = twice(a.at[i], a.at[k], times_a, by_a);
      int winding = 0;
      bool is_on_one = false;
      for (std::size_t j = 0; j < b.size() && !is_on_one; ++j) {
        const Vec<T> source = twice(b.at[j], b.at[j], times_b, by_b) - at;
        const Vec<T> target = twice(b.at[b.next[j]], b.at[b.next[j]], times_b, by_b) - at;
        const int side = sign_of(skew(source, target));
        is_on_one = side == 0 && scalar(source, target) <= 0;
        if ((source.y <= 0) == (target.y <= 0)) continue;
        if (source.y <= 0 && side > 0) ++winding;
        if (target.y <= 0 && side < 0) --winding;
      }
      if (!is_on_one && winding > 0) return true;
    }
  return false;
}

template <typename T>
bool one_is_inside_the_other(const VertexSums<T>& sums, const Vec<T>& x) {
  const Vec<T> here = {T(0), T(0)};
  return enters(sums.p, 1, here, sums.q, -1, x) || enters(sums.q, -1, x, sums.p, 1, here);
}

}  // namespace oplus::along_lines
