// SPDX-License-Identifier: MIT
#include "checked/pieces/convex_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include "checked/boxes/halving_order.hpp"
#include "checked/pieces/shifted_doubles.hpp"
#include "checked/pieces/triangulation.hpp"

namespace oplus::pieces {

namespace {

/// The edges of triangles, and then of what they are merged into.
class MergedTriangles {
 public:
  using Edge = std::uint32_t;

  MergedTriangles(Triangulation triangles, std::span<const NearPoint> vertices,
                  std::span<const Place> places)
      : vertices_(vertices),
        places_(places),
        source_(std::move(triangles.sources)),
        twin_(std::move(triangles.twins)),
        is_flat_(source_.size(), false),
        is_removed_(source_.size(), false),
        piece_(source_.size() / 3),
        corners_(source_.size() / 3, 3),
        long_sides_(source_.size() / 3, 0) {
    std::iota(piece_.begin(), piece_.end(), 0U);
    for (Edge e = 0; e < source_.size(); ++e) {
      next_.push_back(Triangulation::next(e));
      previous_.push_back(Triangulation::previous(e));
    }
  }

  /// What has many more convex corners than a piece may have is divided in another way: without its longest diagonals it
  /// would be fans and strips of long pieces.
  std::vector<ConvexPiece> pieces(std::uint32_t most_corners) {
    const std::size_t many = std::size_t{4} * most_corners;
    sort_diagonals();
    merge(most_corners);
    std::vector<std::vector<Edge>> parts = boundaries();
    merge(~std::uint32_t{0});
    std::vector<ConvexPiece> result;
    std::vector<bool> is_divided(piece_.size(), false);
    for (const std::vector<Edge>& whole : boundaries()) {
      ConvexRing ring;
      if (whole.size() <= many) continue;
      for (const Edge e : whole) {
        ring.corners.push_back(source_[e]);
        ring.is_flat.push_back(is_flat_[e]);
      }
      if (std::cmp_less_equal(std::ranges::count(ring.is_flat, false), many)) continue;
      is_divided[piece_of(whole.front() / 3)] = true;
      add_balanced_pieces(std::move(ring), most_corners, places_, result);
    }
    for (std::vector<Edge>& part : parts) {
      if (is_divided[piece_of(part.front() / 3)]) continue;
      for (Edge& e : part) e = source_[e];
      result.push_back(std::move(part));
    }
    return result;
  }

 private:
  /// The longest first. One that alone makes both angles convex where the region's is reflex, at either end, counts
  /// as a quarter as long.
  void sort_diagonals() {
    std::vector<std::uint8_t> ends(source_.size(), 0);
    for (Edge e = 0; e < twin_.size(); ++e)
      if (twin_[e] == Triangulation::none) count_where_reflex(e, ends);
    for (Edge e = 0; e < twin_.size(); ++e)
      if (twin_[e] != Triangulation::none && e < twin_[e])
        diagonals_.emplace_back(-std::ldexp(length(e), -2 * (ends[e] + ends[twin_[e]])), e);
    std::ranges::sort(diagonals_);
  }

  void merge(std::uint32_t most_corners) {
    for (const auto& [length, e] : diagonals_)
      if (!is_removed_[e]) merge_across(e, most_corners);
  }

  /// The edges of each piece, from one that leaves a first corner.
  std::vector<std::vector<Edge>> boundaries() const {
    std::vector<std::vector<Edge>> result;
    std::vector<bool> seen(source_.size(), false);
    for (Edge e = 0; e < source_.size(); ++e) {
      if (is_removed_[e] || seen[e]) continue;
      std::vector<Edge>& edges = result.emplace_back();
      const Edge first = first_corner(e);
      Edge at = first;
      do {
        seen[at] = true;
        edges.push_back(at);
        at = next_[at];
      } while (at != first);
    }
    return result;
  }

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
    while (twin_[previous_[last]] != Triangulation::none) last = twin_[previous_[last]];
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

  void merge_across(Edge e, std::uint32_t most_corners) {
    const Edge f = twin_[e];
    const std::uint32_t left = piece_of(e / 3), right = piece_of(f / 3);
    const std::uint32_t corners = corners_[left] + corners_[right] - 2;
    if (corners > most_corners) return;
    const Edge in[] = {previous_[e], previous_[f]}, out[] = {next_[f], next_[e]};
    const int turns[] = {turn(in[0], out[0]), turn(in[1], out[1])};
    if (turns[0] < 0 || turns[1] < 0) return;
    // A flat corner is never merged: the whole one would be larger than π. A new one makes one side of two, which are long
    // if they have several flat corners.
    int long_sides = long_sides_[left] + long_sides_[right];
    for (int end = 0; end < 2; ++end) {
      link(in[end], out[end]);
      is_flat_[out[end]] = turns[end] == 0;
      if (turns[end] != 0) continue;
      const Edge before = in[end], after = next_[out[end]];
      long_sides += (is_flat_[before] || is_flat_[after]) -
                    (is_flat_[before] && is_flat_[previous_[before]]) -
                    (is_flat_[after] && is_flat_[next_[after]]);
    }
    if (long_sides > 1) {
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
    long_sides_[left] = long_sides;
  }

  /// A corner whose triangles with two that follow each other are counterclockwise: neither next to it is
  /// flat. If a side has one flat corner, that is one; else all sides but one have none.
  Edge first_corner(Edge e) const {
    while (is_flat_[next_[e]] || is_flat_[previous_[e]]) e = next_[e];
    return e;
  }

  const std::span<const NearPoint> vertices_;
  const std::span<const Place> places_;
  std::vector<std::uint32_t> source_;
  std::vector<Edge> twin_, next_, previous_;
  std::vector<bool> is_flat_;  ///< the corner that the edge leaves
  std::vector<bool> is_removed_;
  std::vector<std::uint32_t> piece_;    ///< of triangles: another one of its piece, or itself
  std::vector<std::uint32_t> corners_;  ///< of pieces, how many
  std::vector<int> long_sides_;         ///< of pieces, how many with several flat corners
  std::vector<std::pair<double, Edge>> diagonals_;
};

/// The mean of the corners, as a box.
Box centre(const ConvexPiece& piece, const std::vector<Place>& vertices) {
  Place sum;
  for (const std::uint32_t corner : piece) {
    sum.x += vertices[corner].x;
    sum.y += vertices[corner].y;
  }
  const auto corners = static_cast<double>(piece.size());
  const double x = sum.x / corners, y = sum.y / corners;
  return {x, y, x, y};
}

}  // namespace

ConvexPieces convex_pieces(const Region& region, std::uint32_t most_corners) {
  ConvexPieces result;
  SweptEdges boundary;
  for (const Chain& chain : chains(region)) {
    const std::size_t first = result.vertices.size();
    result.vertices.insert(result.vertices.end(), chain.begin(), chain.end());
    for (std::size_t i = 0; i < chain.size(); ++i)
      boundary.edges.push_back({static_cast<std::uint32_t>(first + i),
                                static_cast<std::uint32_t>(first + next(i, chain.size()))});
  }
  const ShiftedDoubles doubles(result.vertices);
  std::vector<NearPoint> near;
  std::vector<Place> places;
  for (const Point& p : result.vertices) {
    boundary.points.push_back(&p);
    near.push_back(near_point(p));
    places.push_back(doubles.near(p));
  }
  Triangulation triangles = triangulation(boundary, near, places);
  result.points = std::move(triangles.points);
  MergedTriangles merged(std::move(triangles), near, places);
  std::vector<ConvexPiece> pieces = merged.pieces(most_corners);

  std::vector<Box> centres;
  for (const ConvexPiece& piece : pieces) centres.push_back(centre(piece, places));
  for (const std::uint32_t i : halving_order(centres))
    result.pieces.push_back(std::move(pieces[i]));
  return result;
}

}  // namespace oplus::pieces
