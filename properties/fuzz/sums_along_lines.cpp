// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/sums_along_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "properties/fuzz/along_lines/interiors_meet.hpp"
#include "properties/fuzz/along_lines/line_walk.hpp"

namespace oplus {

namespace along_lines {
namespace {

template <typename T>
class Sums {
 public:
  Sums(const Region& p, const Region& q, const Frame& frame)
      : frame_(frame), sums_(vertex_sums<T>(p, q, frame)), tracks_(tracks(sums_)) {}

  SumsAlongLines sums() {
    const FoundAlongLines found = found_along_lines(sums_, tracks_, frame_);
    SumsAlongLines result;
    result.closed = result.open = canonical_sum({found.boundary, {}, {}});
    decide_dangling(found, result.open);
    decide_isolated(found, result.open);
    result.origins_of_closed = origins(edges(result.closed), false);
    result.origins_of_open = result.origins_of_closed;
    for (std::vector<Origin>& of_edge : origins(result.open.dangling_edges, true))
      result.origins_of_open.push_back(std::move(of_edge));
    return result;
  }

 private:
  bool meet_at(const Point& x) const { return interiors_meet_at(sums_, frame_.in(x), frame_.bits); }

  void decide_dangling(const FoundAlongLines& found, MinkowskiSum& open) const {
    std::vector<Segment> dangling;
    for (const Segment& piece : found.may_dangle)
      if (!meet_at(midpoint(piece.source, piece.target))) dangling.push_back(piece);
    open.dangling_edges = maximal_segments(std::move(dangling));
  }

  void decide_isolated(const FoundAlongLines& found, MinkowskiSum& open) const {
    std::vector<Point> points;
    for (const Point& x : found.may_be_isolated)
      if (!meet_at(x)) points.push_back(x);
    for (const std::uint32_t k : found.isolated_sums)
      if (!interiors_meet_at(sums_, sums_.at[k], frame_.bits)) {
        const Point in_frame = exact(k);
        points.push_back(frame_.back(in_frame.x, in_frame.y));
      }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    for (const Point& x : points)
      if (!lies_on_one(x, found.boundary) && !lies_on_one(x, open.dangling_edges))
        open.isolated_vertices.push_back(x);
  }

  /// An edge of the sum in the frame. Differences of its coordinates and integers are multiples of a step.
  struct EdgeInFrame {
    Segment exact;
    Vec<double> source, target;
    double step;
  };

  EdgeInFrame in_frame(const Segment& edge) const {
    const Point source = frame_.in(edge.source), target = frame_.in(edge.target);
    mpz_class denominator = lcm(source.x.get_den(), source.y.get_den());
    denominator = lcm(denominator, lcm(target.x.get_den(), target.y.get_den()));
    return {{source, target},
            {source.x.get_d(), source.y.get_d()},
            {target.x.get_d(), target.y.get_d()},
            1 / denominator.get_d()};
  }

  /// Whether more than a point of the track is on the edge.
  bool runs_along(const Track& track, const EdgeInFrame& edge, bool either_way) const {
    const Vec<double>& a = sums_.near[track.source];
    const Vec<double> d = sums_.near[track.target] - a;
    const Vec<double> source = edge.source - a, target = edge.target - a;
    const double error = sums_.largest * sums_.largest * 1e-14;
    if (std::abs(skew(d, source)) > error || std::abs(skew(d, target)) > error) return false;
    const double from = scalar(d, source), to = scalar(d, target);
    // All these are multiples of a step, so what is smaller than one is zero.
    if (2 * error < edge.step)
      return (either_way || from < to) && std::min(from, to) < scalar(d, d) - error &&
             std::max(from, to) > error;
    const Segment s{exact(track.source), exact(track.target)};
    return (either_way || sign(dot(direction_of(s), direction_of(edge.exact))) > 0) &&
           overlap(s, edge.exact);
  }

  /// The tracks of the reduced convolution along each edge.
  Origins origins(const std::vector<Segment>& of_sum, bool either_way) const {
    Origins result(of_sum.size());
    for (std::size_t e = 0; e < of_sum.size(); ++e) {
      const EdgeInFrame edge = in_frame(of_sum[e]);
      for (const Track& track : tracks_)
        if (track.is_reduced && runs_along(track, edge, either_way))
          result[e].push_back(track.origin);
      std::sort(result[e].begin(), result[e].end());
    }
    return result;
  }

  Point exact(std::uint32_t sum) const {
    return {Rational(as_mpz(sums_.at[sum].x)), Rational(as_mpz(sums_.at[sum].y))};
  }

  const Frame& frame_;
  VertexSums<T> sums_;
  std::vector<Track> tracks_;
};

}  // namespace
}  // namespace along_lines

SumsAlongLines sums_along_lines(const Region& p, const Region& q) {
  using namespace along_lines;
  if (p.components.empty() || q.components.empty()) return {};
  const Frame frame = frame_of(p, q);
  // Positions are compared in products of 5 bits + 9.
  if (frame.bits <= 10) return Sums<std::int64_t>(p, q, frame).sums();
  if (frame.bits <= 23) return Sums<Int128>(p, q, frame).sums();
  return Sums<mpz_class>(p, q, frame).sums();
}

}  // namespace oplus
