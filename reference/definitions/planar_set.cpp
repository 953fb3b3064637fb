// SPDX-License-Identifier: MIT
#include "reference/definitions/planar_set.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/pairwise_sum.hpp"

namespace oplus {

namespace {

/// Edges, which must stay where they are, by the points they leave, counterclockwise around each.
class LeavingEdges {
 public:
  explicit LeavingEdges(const std::vector<Segment>& edges) {
    edges_.reserve(edges.size());
    for (const Segment& e : edges) edges_.push_back(&e);
    std::sort(edges_.begin(), edges_.end(),
              [](const Segment* a, const Segment* b) { return *a < *b; });
    for (auto first = edges_.begin(); first != edges_.end();) {
      auto last = first;
      while (last != edges_.end() && (*last)->source == (*first)->source) ++last;
      if (last - first > 1)
        std::stable_sort(first, last, [](const Segment* a, const Segment* b) {
          return compare_angle(direction_of(*a), direction_of(*b)) < 0;
        });
      first = last;
    }
  }

  std::size_t size() const { return edges_.size(); }
  const Segment& operator[](std::size_t i) const { return *edges_[i]; }

  /// The edge after edge i that turns clockwise most: the first one counterclockwise from the way back
  /// (thesis, Definition 3.2.1).
  std::size_t after(std::size_t i) const {
    const Point& at = edges_[i]->target;
    const auto first = std::partition_point(
        edges_.begin(), edges_.end(), [&](const Segment* e) { return (e->source <=> at) < 0; });
    const auto last = std::partition_point(first, edges_.end(),
                                           [&](const Segment* e) { return e->source == at; });
    OPLUS_REQUIRES(first != last, "Observation 3.2.4");
    if (last - first == 1) return static_cast<std::size_t>(first - edges_.begin());
    const Vector back = -direction_of(*edges_[i]);
    auto next = std::partition_point(
        first, last, [&](const Segment* e) { return compare_angle(direction_of(*e), back) <= 0; });
    if (OPLUS_MUTANT("chains-turn-counterclockwise-most",
                     "where the boundary touches itself, its chains go round faces of the sum"))
      next = (next == first ? last : next) - 1;
    return static_cast<std::size_t>((next == last ? first : next) - edges_.begin());
  }

 private:
  std::vector<const Segment*> edges_;
};

/// Follows edges to closed chains, turning clockwise most at each vertex.
std::vector<Chain> stitch(const std::vector<Segment>& edges) {
  const LeavingEdges leaving(edges);
  std::vector<Chain> stitched;
  std::vector<bool> visited(leaving.size(), false);
  for (std::size_t first = 0; first < leaving.size(); ++first) {
    Chain chain;
    std::size_t edge = first;
    for (; !visited[edge]; edge = leaving.after(edge)) {
      visited[edge] = true;
      chain.push_back(leaving[edge].source);
    }
    OPLUS_REQUIRES(chain.empty() || edge == first, "Observation 3.2.4");
    if (!chain.empty()) stitched.push_back(std::move(chain));
  }
  return stitched;
}

Chain without_collinear_vertices(const Chain& chain) {
  Chain corners;
  corners.reserve(chain.size());
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Point& before = chain[previous(i, chain.size())];
    const Point& after = chain[next(i, chain.size())];
    if (orientation(before, chain[i], after) != 0 ||
        OPLUS_MUTANT("edges-in-line-stay-apart",
                     "chains of a sum keep vertices inside straight lines"))
      corners.push_back(chain[i]);
  }
  return corners;
}

/// Requires: the chain starts at its smallest vertex, and does not cross itself. Of all its edges there, the one
/// furthest clockwise has the outside beside it: to its right, if the chain is counterclockwise.
bool is_counterclockwise(const Chain& chain) {
  Vector outermost;
  bool leaves = false;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (chain[i] != chain[0]) continue;
    for (const bool leaving : {false, true}) {
      const std::size_t other = leaving ? next(i, chain.size()) : previous(i, chain.size());
      Vector way = chain[other] - chain[0];
      const int turn = i == 0 && !leaving ? 1 : sign(cross(way, outermost));
      if (turn < 0 || (turn == 0 && leaving)) continue;
      outermost = std::move(way);
      leaves = leaving;
    }
  }
  OPLUS_ENSURES(leaves == (sign(twice_area(chain)) > 0), "sign of an area");
  return leaves;
}

}  // namespace

std::size_t start_of_smallest_rotation(const Chain& chain) {
  const auto is_smaller = [&](std::size_t a, std::size_t b) {
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const auto compared = chain[a] <=> chain[b];
      if (compared != 0) return compared < 0;
      a = next(a, chain.size());
      b = next(b, chain.size());
    }
    return false;
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < chain.size(); ++i)
    if (is_smaller(i, best)) best = i;
  return best;
}

PlanarSet canonical_sum(const BoundaryFeatures& features) {
  PlanarSet sum;
  for (const Chain& stitched : stitch(features.edges)) {
    Chain chain = without_collinear_vertices(stitched);
    std::rotate(chain.begin(),
                chain.begin() + static_cast<std::ptrdiff_t>(start_of_smallest_rotation(chain)),
                chain.end());
    (is_counterclockwise(chain) ? sum.outer : sum.holes).push_back(std::move(chain));
  }
  std::sort(sum.outer.begin(), sum.outer.end());
  std::sort(sum.holes.begin(), sum.holes.end());
  sum.dangling_edges = maximal_segments(features.dangling_edges);
  sum.isolated_vertices = features.isolated_vertices;
  std::sort(sum.isolated_vertices.begin(), sum.isolated_vertices.end());
  sum.isolated_vertices.erase(
      std::unique(sum.isolated_vertices.begin(), sum.isolated_vertices.end()),
      sum.isolated_vertices.end());
  return sum;
}

PlanarSet regularized(PlanarSet set) {
  set.dangling_edges.clear();
  set.isolated_vertices.clear();
  return set;
}

Rational area(const PlanarSet& sum) {
  PairwiseSum twice;
  for (const Chain& chain : sum.outer)
    if (!OPLUS_MUTANT("area-is-of-the-first-chain",
                      "the area of a sum is that of one outer chain and the holes") ||
        &chain == &sum.outer[0])
      twice.add(twice_area(chain));
  for (const Chain& hole : sum.holes) twice.add(twice_area(hole));
  return twice.total() / 2;
}

std::vector<Segment> edges(const PlanarSet& sum) {
  std::size_t count = sum.dangling_edges.size();
  for (const std::vector<Chain>* of_sum : {&sum.outer, &sum.holes})
    for (const Chain& chain : *of_sum) count += chain.size();
  std::vector<Segment> result;
  result.reserve(count);
  for (const std::vector<Chain>* of_sum : {&sum.outer, &sum.holes})
    for (const Chain& chain : *of_sum)
      for (std::size_t i = 0; i < chain.size(); ++i)
        result.push_back({chain[i], chain[next(i, chain.size())]});
  result.insert(result.end(), sum.dangling_edges.begin(), sum.dangling_edges.end());
  return result;
}

Origins origins(const PlanarSet& sum, const std::vector<ConvolutionSegment>& reduced) {
  const std::vector<Segment> of_sum = edges(sum);
  const std::size_t first_dangling = of_sum.size() - sum.dangling_edges.size();
  Origins result(of_sum.size());
  for (std::size_t i = 0; i < of_sum.size(); ++i) {
    for (const ConvolutionSegment& s : reduced) {
      const bool same = sign(dot(direction_of(s.segment), direction_of(of_sum[i]))) > 0;
      if ((same || i >= first_dangling) && overlap(s.segment, of_sum[i]))
        result[i].push_back(s.origin);
    }
    std::sort(result[i].begin(), result[i].end());
  }
  return result;
}

}  // namespace oplus
