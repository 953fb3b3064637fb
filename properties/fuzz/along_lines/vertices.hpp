// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
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
  /// The edges, from vertex to vertex, cut where another vertex touches them.
  std::vector<std::pair<std::size_t, std::size_t>> pieces;

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
      result.at.push_back({number<T>(x.get_num()), number<T>(y.get_num())});
      result.near.push_back({as_double(result.at.back().x), as_double(result.at.back().y)});
      result.next.push_back(start + (i + 1) % n);
      result.before.push_back(start + (i + n - 1) % n);
      result.name.push_back({c, i});
    }
  }
  std::vector<std::size_t> on_edge;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Vec<T>&source = result.at[i], &target = result.at[result.next[i]];
    const Vec<T> d = target - source;
    on_edge.assign({i, result.next[i]});
    for (std::size_t k = 0; k < result.size(); ++k) {
      const Vec<T> to = result.at[k] - source;
      if (sign_of(skew(d, to)) == 0 && scalar(to, result.at[k] - target) < 0) on_edge.push_back(k);
    }
    if (on_edge.size() > 2)
      std::sort(on_edge.begin(), on_edge.end(), [&](std::size_t a, std::size_t b) {
        return scalar(d, result.at[a] - result.at[b]) < 0;
      });
    for (std::size_t k = 0; k + 1 < on_edge.size(); ++k)
      if (scalar(d, result.at[on_edge[k + 1]] - result.at[on_edge[k]]) > 0)
        result.pieces.emplace_back(on_edge[k], on_edge[k + 1]);
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
