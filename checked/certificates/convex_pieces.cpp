// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/certificates/convex_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>

#include "checked/certificates/halving_order.hpp"
#include "checked/certificates/shifted_doubles.hpp"
#include "reference/chains/near_point.hpp"

namespace oplus::certificates {

namespace {

/// The edges of triangles, and then of what they are merged into; edge 3 t + k leaves corner k of
/// triangle t.
class MergedTriangles {
 public:
  using Edge = std::uint32_t;

  MergedTriangles(const std::vector<Triangle>& triangles, const std::vector<NearPoint>& vertices,
                  const std::vector<Place>& places, std::uint32_t most_corners)
      : most_corners_(most_corners),
        vertices_(vertices),
        places_(places),
        source_(3 * triangles.size()),
        next_(source_.size()),
        previous_(source_.size()),
        twin_(source_.size(), Triangle::none),
        is_flat_(source_.size(), false),
        is_removed_(source_.size(), false),
        piece_(triangles.size()),
        corners_(triangles.size(), 3) {
    std::iota(piece_.begin(), piece_.end(), 0U);
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const Edge e = 3 * t + k;
        source_[e] = triangles[t].corners[k];
        next_[e] = 3 * t + (k + 1) % 3;
        previous_[e] = 3 * t + (k + 2) % 3;
        const std::uint32_t across = triangles[t].across[k];
        if (across == Triangle::none) continue;
        for (std::uint32_t other = 0; other < 3; ++other)
          if (triangles[across].across[other] == t &&
              triangles[across].corners[other] == triangles[t].corners[(k + 1) % 3])
            twin_[e] = 3 * across + other;
      }
    }
  }

  /// Removes the longest diagonals first. One that alone makes both angles convex where the region's is
  /// reflex, at either end, counts as a quarter as long.
  void merge() {
    std::vector<std::uint8_t> ends(source_.size(), 0);
    for (Edge e = 0; e < twin_.size(); ++e)
      if (twin_[e] == Triangle::none) count_where_reflex(e, ends);
    std::vector<std::pair<double, Edge>> diagonals;
    for (Edge e = 0; e < twin_.size(); ++e)
      if (twin_[e] != Triangle::none && e < twin_[e])
        diagonals.emplace_back(-std::ldexp(length(e), -2 * (ends[e] + ends[twin_[e]])), e);
    std::ranges::sort(diagonals);
    for (const auto& [length, e] : diagonals) merge_across(e);
  }

  std::vector<ConvexPiece> pieces() const {
    std::vector<ConvexPiece> result;
    std::vector<bool> seen(source_.size(), false);
    for (Edge e = 0; e < source_.size(); ++e) {
      if (is_removed_[e] || seen[e]) continue;
      ConvexPiece& piece = result.emplace_back();
      const Edge first = first_corner(e);
      Edge at = first;
      do {
        seen[at] = true;
        piece.push_back(source_[at]);
        at = next_[at];
      } while (at != first);
    }
    return result;
  }

 private:
  Place direction(Edge e) const {
    const auto& [ax, ay] = places_[source_[e]];
    const auto& [bx, by] = places_[source_[next_[e]]];
    return {bx - ax, by - ay};
  }

  double length(Edge e) const {
    const auto [x, y] = direction(e);
    return std::hypot(x, y);
  }

  /// Of the diagonals that leave the vertex which an edge of the region leaves, those that make both angles
  /// convex where that between the edges of the region is reflex. In doubles.
  void count_where_reflex(Edge boundary, std::vector<std::uint8_t>& counts) const {
    const auto turns_left = [](const Place& a, const Place& b) {
      return a.x * b.y - a.y * b.x > 0;
    };
    Edge last = boundary;
    while (twin_[previous_[last]] != Triangle::none) last = twin_[previous_[last]];
    const Place from = direction(boundary), back = direction(previous_[last]);
    const Place to{-back.x, -back.y};
    if (!turns_left(to, from)) return;
    for (Edge e = boundary; e != last;) {
      e = twin_[previous_[e]];
      const Place along = direction(e);
      if (!turns_left(along, from) && !turns_left(to, along)) ++counts[e];
    }
  }

  /// How what runs along `in` and `out`, from where `in` ends, turns.
  int turn(Edge in, Edge out) const {
    return orientation(vertices_[source_[in]], vertices_[source_[out]],
                       vertices_[source_[next_[out]]]);
  }

  std::uint32_t piece_of(std::uint32_t triangle) {
    while (piece_[triangle] != triangle) triangle = piece_[triangle] = piece_[piece_[triangle]];
    return triangle;
  }

  void link(Edge in, Edge out) {
    next_[in] = out;
    previous_[out] = in;
  }

  void merge_across(Edge e) {
    const Edge f = twin_[e];
    const std::uint32_t left = piece_of(e / 3), right = piece_of(f / 3);
    const std::uint32_t corners = corners_[left] + corners_[right] - 2;
    if (corners > most_corners_) return;
    const Edge in[] = {previous_[e], previous_[f]}, out[] = {next_[f], next_[e]};
    const int turns[] = {turn(in[0], out[0]), turn(in[1], out[1])};
    if (turns[0] < 0 || turns[1] < 0) return;
    // A flat corner is never merged: the whole one would be larger than π.
    for (int end = 0; end < 2; ++end) {
      link(in[end], out[end]);
      is_flat_[out[end]] = turns[end] == 0;
    }
    if (has_two_sides_with_flat_corners(out[0])) {
      for (const Edge after : out) is_flat_[after] = false;
      link(in[0], e);
      link(e, out[1]);
      link(in[1], f);
      link(f, out[0]);
      return;
    }
    is_removed_[e] = is_removed_[f] = true;
    piece_[right] = left;
    corners_[left] = corners;
  }

  /// Whether there is more than one side with several flat corners, given an edge of the piece.
  bool has_two_sides_with_flat_corners(Edge first) const {
    int sides = 0;
    Edge e = first;
    do {
      sides += is_flat_[e] && is_flat_[next_[e]] && !is_flat_[previous_[e]];
      e = next_[e];
    } while (e != first);
    return sides > 1;
  }

  /// A corner whose triangles with two that follow each other are counterclockwise: neither next to it is
  /// flat. If a side has one flat corner, that is one; else all sides but one have none.
  Edge first_corner(Edge e) const {
    while (is_flat_[next_[e]] || is_flat_[previous_[e]]) e = next_[e];
    return e;
  }

  const std::uint32_t most_corners_;
  const std::vector<NearPoint>& vertices_;
  const std::vector<Place>& places_;
  std::vector<std::uint32_t> source_;
  std::vector<Edge> next_, previous_, twin_;
  std::vector<bool> is_flat_;  ///< the corner that the edge leaves
  std::vector<bool> is_removed_;
  std::vector<std::uint32_t> piece_;    ///< of triangles: another one of its piece, or itself
  std::vector<std::uint32_t> corners_;  ///< of pieces, how many
};

Place centre(const ConvexPiece& piece, const std::vector<Place>& vertices) {
  Place sum;
  for (const std::uint32_t corner : piece) {
    sum.x += vertices[corner].x;
    sum.y += vertices[corner].y;
  }
  const auto corners = static_cast<double>(piece.size());
  return {sum.x / corners, sum.y / corners};
}

}  // namespace

ConvexPieces convex_pieces(const Region& region, std::uint32_t most_corners) {
  ConvexPieces result;
  for (const Chain& chain : chains(region))
    result.vertices.insert(result.vertices.end(), chain.begin(), chain.end());
  const ShiftedDoubles doubles(result.vertices);
  std::vector<NearPoint> near;
  std::vector<Place> places;
  for (const Point& p : result.vertices) {
    near.push_back(near_point(p));
    places.push_back(doubles.near(p));
  }
  Triangulation triangles = triangulation(region);
  result.points = std::move(triangles.points);
  MergedTriangles merged(triangles.triangles, near, places, most_corners);
  merged.merge();
  std::vector<ConvexPiece> pieces = merged.pieces();

  std::vector<Place> centres;
  for (const ConvexPiece& piece : pieces) centres.push_back(centre(piece, places));
  for (const std::uint32_t i : halving_order(centres))
    result.pieces.push_back(std::move(pieces[i]));
  return result;
}

}  // namespace oplus::certificates
