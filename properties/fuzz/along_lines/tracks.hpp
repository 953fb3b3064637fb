// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "properties/fuzz/along_lines/vertices.hpp"
#include "reference/definitions/direction.hpp"

namespace oplus::along_lines {

/// A segment of 𝒞 between two vertex sums.
struct Track {
  std::uint32_t source, target;
  Origin origin;
  bool is_reduced;
};

/// Compares two directions as angles in [0, 2π), of equal ones as the tie rule says (Definition 2.2.7).
template <typename T>
int compare_directions(const Vec<T>& a, Summand of_a, const Vec<T>& b, Summand of_b) {
  static const int p_and_q = compare(Direction{{1, 0}, Summand::P}, Direction{{1, 0}, Summand::Q});
  const auto lower = [](const Vec<T>& v) { return v.y < 0 || (v.y == 0 && v.x < 0); };
  const int halves = int{lower(a)} - int{lower(b)};
  if (halves != 0) return halves;
  const int turn = sign_of(skew(b, a));
  if (turn != 0 || of_a == of_b) return turn;
  return of_a == Summand::P ? p_and_q : -p_and_q;
}

/// Whether an edge's direction is in the tangent set of a vertex of the other (Definitions 2.1.13, 2.2.7).
template <typename T>
bool is_tangent(const Vec<T>& d, Summand of_d, const Vec<T>& in, const Vec<T>& out) {
  const Summand of = other(of_d);
  const bool after_in = compare_directions(in, of, d, of_d) < 0;
  const bool before_out = compare_directions(d, of_d, out, of) < 0;
  const int range = compare_directions(in, of, out, of);
  return range < 0 ? after_in && before_out : range > 0 && (after_in || before_out);
}

/// 𝒞, first the edges of P. O(nm).
template <typename T>
std::vector<Track> tracks(const VertexSums<T>& sums) {
  std::vector<Track> result;
  const auto add = [&](const Vertices<T>& with_edges, const Vertices<T>& with_vertices,
                       Summand edge_of) {
    const auto index = [&](std::size_t edge, std::size_t vertex) {
      return edge_of == Summand::P ? sums.index(edge, vertex) : sums.index(vertex, edge);
    };
    for (std::size_t i = 0; i < with_edges.size(); ++i) {
      const Vec<T> d = with_edges.edge(i);
      for (std::size_t j = 0; j < with_vertices.size(); ++j) {
        const Vec<T> in = with_vertices.edge(with_vertices.before[j]);
        const Vec<T> out = with_vertices.edge(j);
        if (!is_tangent(d, edge_of, in, out)) continue;
        result.push_back({index(i, j),
                          index(with_edges.next[i], j),
                          {edge_of, with_edges.name[i], with_vertices.name[j]},
                          skew(in, out) >= 0});
      }
    }
  };
  add(sums.p, sums.q, Summand::P);
  add(sums.q, sums.p, Summand::Q);
  return result;
}

}  // namespace oplus::along_lines
