// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "checked/slide/covered_cells.hpp"
#include "checked/slide/low_dimensional_features.hpp"
#include "checked/slide/sum_in.hpp"
#include "reference/arithmetic/interval.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus::slide {

/// The edges of a summand in doubles, as they are in the plane, in the order of their numbers.
class NearEdges {
 public:
  explicit NearEdges(const Region& region) {
    for (const Segment& e : edges(region)) {
      const IntervalSegment s = interval(e);
      const double x = s.source.x.low, y = s.source.y.low;
      all_.push_back({x, y, s.target.x.low - x, s.target.y.low - y});
      low_x = std::min(low_x, x);
      low_y = std::min(low_y, y);
      high_x = std::max(high_x, x);
      high_y = std::max(high_y, y);
    }
  }

  const NearSegment& operator[](std::uint32_t edge) const { return all_[edge]; }
  std::span<const NearSegment> all() const { return all_; }
  double largest() const { return std::max({-low_x, -low_y, high_x, high_y}); }

  double low_x = std::numeric_limits<double>::infinity(), low_y = low_x, high_x = -low_x,
         high_y = -low_x;

 private:
  std::vector<NearSegment> all_;
};

template <typename Numbers>
std::vector<Segment> nearest_in(const Region& p, const Region& q, const Scaling& scaling) {
  ReducedSegments<Numbers> segments(p, q, scaling);
  const RaysOfBoth<Numbers> rays = rays_of(segments.summands());
  const bool all_ways = !right_is_enough(rays);
  const NearEdges of_p(p), of_q(q);
  // A sum is off by less; where squares are too small or too large for doubles, nothing is known of it.
  const double largest = of_p.largest() + of_q.largest();
  const bool has_squares = largest > 0x1p-400 && largest < 0x1p400;
  const double error = has_squares ? largest * 0x1p-30 : std::numeric_limits<double>::infinity();
  const auto near = [&](std::uint32_t i) -> NearSegment {
    const auto [edge_p, edge_q] = segments[i].contact[1];
    const NearSegment &a = of_p[edge_p], &b = of_q[edge_q];
    const NearSegment& along = segments.origin(i).edge_of == Summand::P ? a : b;
    return {a.x + b.x, a.y + b.y, along.dx, along.dy};
  };
  const auto least = [&](double distance) { return distance > error ? distance - error : 0; };
  const auto least_of = [&](const FreePiece<Numbers>& piece) {
    return least(
        near_distance(near(piece.segment), piece.piece.from.near(), piece.piece.to.near()));
  };

  // More than the distance of some place that is not in the open sum; first of one beside its box.
  double most = std::min({-(of_p.low_x + of_q.low_x), of_p.high_x + of_q.high_x,
                          -(of_p.low_y + of_q.low_y), of_p.high_y + of_q.high_y}) +
                error;
  if (!has_squares) most = error;
  struct Next {
    double least;
    std::uint32_t segment;
  };
  std::vector<Next> order;
  for (std::uint32_t i = 0; i < segments.size(); ++i)
    order.push_back({least(near_distance(near(i))), i});
  const auto sort_from = [&](std::size_t k) {
    std::sort(order.begin() + static_cast<std::ptrdiff_t>(k), order.end(),
              [](const Next& a, const Next& b) { return a.least < b.least; });
  };
  sort_from(0);
  FreePieces<Numbers> search(segments.summands());
  OpenPlaces<Numbers> open(segments.summands(), rays);
  std::vector<FreePiece<Numbers>> found;
  constexpr std::size_t tried_first = 8;
  for (std::size_t k = 0; k < order.size() && order[k].least <= most; ++k) {
    if (k == tried_first && has_squares) {
      const double radius =
          std::min(most * (1 + 0x1p-20) + error, 2 * order[(k + order.size()) / 2].least + error);
      const CoveredCells cells(of_p.all(), of_q.all(), radius, error);
      for (auto next = order.begin() + tried_first; next != order.end(); ++next)
        next->least = std::max(next->least, cells.least_uncovered(near(next->segment)));
      sort_from(k);
      if (!(order[k].least <= most)) break;
    }
    const std::uint32_t i = order[k].segment;
    const auto add = [&](Piece<Numbers> piece) {
      found.push_back({i, std::move(piece)});
      most = std::min(most, least_of(found.back()) + 2 * error);
    };
    if (all_ways || is_to_the_right(segments.direction(i)))
      open.find(search, i, segments[i], add);
    else
      search.find(segments[i], add);
  }
  const auto is_too_far = [&](const FreePiece<Numbers>& piece) { return least_of(piece) > most; };
  for (auto* pieces : {&found, &open.found.pieces, &open.found.points})
    std::erase_if(*pieces, is_too_far);
  auto [dangling, isolated] = low_dimensional_features(
      segments, rays, low_dimensional_candidates(segments, rays, std::move(open.found), 1),
      NamedEnds<Numbers>{}, scaling, 1);
  std::vector<Segment> result = std::move(dangling);
  if (OPLUS_MUTANT("nearest-boundary-misses-exact-fits",
                   "no dangling edge or isolated vertex is near the origin")) {
    result.clear();
    isolated.clear();
  }
  for (const FreePiece<Numbers>& one : found) {
    const auto end = [&](const Fraction<Numbers>& t) {
      return ExactPoint<Numbers>(segments.exact(one.segment), t).in_the_plane(scaling);
    };
    result.push_back({end(one.piece.from), end(one.piece.to)});
  }
  for (const Point& x : isolated) result.push_back({x, x});
  return result;
}

}  // namespace oplus::slide
