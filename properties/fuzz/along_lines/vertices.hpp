// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "properties/fuzz/along_lines/frame.hpp"
#include "properties/fuzz/along_lines/integers.hpp"

namespace oplus::along_lines {

/// The vertices of a summand, chain after chain.
template <typename T>
struct Vertices {
  std::vector<Vec<T>> at;
  std::vector<Vec<double>> near;
  std::vector<std::size_t> next, before;
  std::vector<VertexIndex> name;
  std::vector<bool> is_touched;  ///< the edge that leaves it, by another vertex inside it

  Vec<T> edge(std::size_t i) const { return at[next[i]] - at[i]; }
  std::size_t size() const { return at.size(); }
};

template <typename T>
Vertices<T> vertices_of(const Region& region, const Point& first, const Frame& frame) {
  Vertices<T> result;
  const std::vector<Chain> all = chains(region);
  for (std::size_t c = 0; c < all.size(); ++c) {
    const std::size_t start = result.size(), n = all[c].size();
    for (std::size_t i = 0; i < n; ++i) {
      const Rational x = (all[c][i].x - first.x) * frame.factor;
      const Rational y = (all[c][i].y - first.y) * frame.factor;
      result.at.push_back({from_mpz<T>(x.get_num()), from_mpz<T>(y.get_num())});
      result.near.push_back({as_double(result.at.back().x), as_double(result.at.back().y)});
      result.next.push_back(start + (i + 1) % n);
      result.before.push_back(start + (i + n - 1) % n);
      result.name.push_back({c, i});
    }
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Vec<T> d = result.edge(i);
    const T length = scalar(d, d);
    bool touched = false;
    for (std::size_t k = 0; k < result.size() && !touched; ++k) {
      const Vec<T> to = result.at[k] - result.at[i];
      if (sign_of(skew(d, to)) != 0) continue;
      const T along = scalar(d, to);
      touched = along > 0 && along < length;
    }
    result.is_touched.push_back(touched);
  }
  return result;
}

/// Both summands, and the sums of their vertices.
template <typename T>
struct VertexSums {
  Vertices<T> p, q;
  std::vector<Vec<T>> at;         ///< of vertex i of P and vertex j of Q: at index(i, j)
  std::vector<Vec<double>> near;  ///< the same
  double largest = 1;             ///< of their coordinates

  std::uint32_t index(std::size_t i, std::size_t j) const {
    return static_cast<std::uint32_t>(i * q.size() + j);
  }
  std::uint32_t size() const { return static_cast<std::uint32_t>(at.size()); }
};

template <typename T>
VertexSums<T> vertex_sums(const Region& p, const Region& q, const Frame& frame) {
  VertexSums<T> sums{vertices_of<T>(p, frame.first_of_p, frame),
                     vertices_of<T>(q, frame.first_of_q, frame),
                     {},
                     {}};
  for (const Vec<T>& a : sums.p.at)
    for (const Vec<T>& b : sums.q.at) {
      sums.at.push_back(a + b);
      sums.near.push_back({as_double(sums.at.back().x), as_double(sums.at.back().y)});
      const auto& [x, y] = sums.near.back();
      sums.largest = std::max({sums.largest, std::abs(x), std::abs(y)});
    }
  return sums;
}

}  // namespace oplus::along_lines
