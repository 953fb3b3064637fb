// SPDX-License-Identifier: MIT
#include "checked/operations/winding_sweep.hpp"

#include <algorithm>
#include <utility>

#include "reference/chains/plane_sweep.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

/// What is known of the piece of an edge that the sweep is passing.
struct Passing {
  Point from;
  int left = 0, right = 0, forth = 0, back = 0;
  bool is_of_segment = false;
  bool is_first = false;  ///< of those that overlap
};

}  // namespace

void SweptSets::add(const Chain& chain) {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Point& from = chain[i];
    const Point& to = chain[next(i, chain.size())];
    if (from < to) edges.push_back({{from, to}, 1, 0});
    if (to < from) edges.push_back({{to, from}, 0, 1});
  }
}

void SweptSets::add(const PlanarSet& sum, const Vector& moved_by) {
  for (const std::vector<Chain>* chains : {&sum.outer, &sum.holes})
    for (const Chain& chain : *chains) add(translated(chain, moved_by));
}

void SweptSets::subtract(const PlanarSet& sum, const Vector& moved_by) {
  const std::size_t before = edges.size();
  add(sum, moved_by);
  for (std::size_t i = before; i < edges.size(); ++i) std::swap(edges[i].forth, edges[i].back);
}

void SweptSets::add_both_ways(const Segment& edge, int times) {
  edges.push_back({edge.source < edge.target ? edge : reversed(edge), times, times});
}

void SweptSets::merge(bool keep_balanced) {
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.segment < b.segment; });
  std::size_t merged = 0;
  for (std::size_t i = 0; i < edges.size();) {
    Edge edge = std::move(edges[i++]);
    for (; i < edges.size() && edges[i].segment == edge.segment; ++i) {
      edge.forth += edges[i].forth;
      edge.back += edges[i].back;
    }
    if (keep_balanced || edge.forth != edge.back) edges[merged++] = std::move(edge);
  }
  edges.resize(merged);
}

void sweep_windings(const SweptSets& sets, const std::function<void(const SweptPiece&)>& see_piece,
                    const std::function<void(const SweptPoint&)>& see_point) {
  SweptEdges swept;
  for (const SweptSets::Edge& e : sets.edges) swept.add(e.segment);
  for (const Segment& s : sets.segments) swept.add(s);
  const std::size_t first_given = swept.points.size();
  for (const Point& p : sets.points) swept.add(p);

  std::vector<Passing> passing(swept.edges.size());
  const auto forward = [&](std::uint32_t e) -> const Point& {
    const auto [source, target] = swept.edges[e];
    return *swept.points[swept.runs_right(e) ? target : source];
  };
  sweep(swept, [&](const SweptPlace& place) {
    const int below = place.below ? passing[*place.below].left : sets.around;
    SweptPoint point{place.point, below, below, 0, !place.left.empty() || !place.right.empty(),
                     false};
    const auto see = [&](const Passing& piece) {
      point.least = std::min({point.least, piece.left, piece.right});
      point.most = std::max({point.most, piece.left, piece.right});
      point.ends += piece.forth + piece.back;
    };
    for (const std::uint32_t e : place.left) {
      Passing& piece = passing[e];
      if (!piece.is_first) continue;
      see(piece);
      see_piece({{std::move(piece.from), place.point},
                 piece.left,
                 piece.right,
                 piece.forth,
                 piece.back,
                 piece.is_of_segment});
    }
    int winding = below;
    for (std::size_t i = 0; i < place.right.size();) {
      Passing piece{place.point, 0, winding, 0, 0, false, true};
      const std::size_t first = i;
      const Point& to = forward(place.right[i]);
      for (; i < place.right.size() &&
             (i == first || orientation(place.point, to, forward(place.right[i])) == 0);
           ++i) {
        const std::uint32_t e = place.right[i];
        if (e < sets.edges.size()) {
          piece.forth += sets.edges[e].forth;
          piece.back += sets.edges[e].back;
        } else {
          piece.is_of_segment = true;
        }
      }
      // What is to the left of an edge that runs to the right is above it.
      winding += piece.forth - piece.back;
      piece.left = winding;
      see(piece);
      for (std::size_t j = first; j < i; ++j) {
        passing[place.right[j]] = piece;
        piece.is_first = false;
      }
    }
    point.is_given = !place.points.empty() && place.points.back() >= first_given;
    see_point(point);
    return true;
  });
}

PlanarSet closed_set(SweptSets sets) {
  sets.merge(false);
  BoundaryFeatures features;
  const auto is_inside = [](int winding) {
    return OPLUS_MUTANT("overlaps-are-no-part-of-unions", "a union lacks what two regions share")
               ? winding % 2 != 0
               : winding > 0;
  };
  sweep_windings(
      sets,
      [&](const SweptPiece& piece) {
        if (is_inside(piece.left) != is_inside(piece.right))
          features.edges.push_back(is_inside(piece.left) ? piece.segment : reversed(piece.segment));
        else if (piece.is_of_segment &&
                 (piece.left == 0 ||
                  OPLUS_MUTANT("segments-inside-dangle",
                               "a union keeps those of its segments that are inside its regions")))
          features.dangling_edges.push_back(piece.segment);
      },
      [&](const SweptPoint& point) {
        if (point.is_given && !point.is_on_edge &&
            (point.most == 0 ||
             OPLUS_MUTANT("points-inside-are-isolated",
                          "a union keeps those of its points that are inside its regions")))
          features.isolated_vertices.push_back(point.point);
      });
  PlanarSet result = canonical_sum(features);
  result.is_unbounded = sets.around > 0;
  return result;
}

}  // namespace oplus
