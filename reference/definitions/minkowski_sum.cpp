// SPDX-License-Identifier: MIT
#include "reference/definitions/minkowski_sum.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

/// Whether, turning counterclockwise from the way back along `in`, a is met before b: then a is
/// the larger clockwise turn (thesis, Definition 3.2.1).
bool turns_more_clockwise(const Vector& in, const Vector& a, const Vector& b) {
  return counterclockwise_between({a, Summand::P}, {-in, Summand::P}, {b, Summand::P});
}

/// Follows edges to closed chains, turning clockwise most at each vertex.
std::vector<Chain> stitch(std::vector<Segment> edges) {
  std::sort(edges.begin(), edges.end());
  const auto best_direction = [&](const Segment& edge) {
    const auto leaving =
        std::equal_range(edges.begin(), edges.end(), Segment{edge.target, {}},
                         [](const Segment& a, const Segment& b) { return a.source < b.source; });
    OPLUS_REQUIRES(leaving.first != leaving.second, "Observation 3.2.4");
    return std::max_element(leaving.first, leaving.second, [&](const Segment& a, const Segment& b) {
      const bool b_first =
          turns_more_clockwise(direction_of(edge), direction_of(b), direction_of(a));
      return b_first !=
             OPLUS_MUTANT(
                 "chains-turn-counterclockwise-most",
                 "where the boundary touches itself, its chains go round faces of the sum");
    });
  };
  std::vector<Chain> stitched;
  std::vector<bool> visited(edges.size(), false);
  for (auto first = edges.begin(); first != edges.end(); ++first) {
    Chain chain;
    auto edge = first;
    for (; !visited[edge - edges.begin()]; edge = best_direction(*edge)) {
      visited[edge - edges.begin()] = true;
      chain.push_back(edge->source);
    }
    OPLUS_REQUIRES(chain.empty() || edge == first, "Observation 3.2.4");
    if (!chain.empty()) stitched.push_back(std::move(chain));
  }
  return stitched;
}

Chain without_collinear_vertices(const Chain& chain) {
  Chain corners;
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

/// Takes a chain that touches itself apart into chains that do not.
std::vector<Chain> simple_chains(const Chain& chain) {
  std::vector<Chain> simple;
  Chain open;
  // A chain may pass straight through a point that it touches elsewhere.
  for (const Segment& piece : cut_edges(chain, chain)) {
    const auto met = std::find(open.begin(), open.end(), piece.source);
    if (met != open.end()) {
      simple.push_back(without_collinear_vertices({met, open.end()}));
      open.erase(met, open.end());
    }
    open.push_back(piece.source);
  }
  simple.push_back(without_collinear_vertices(open));
  return simple;
}

/// Whether a hole is inside an outer chain. They may touch in points, so that one of the hole's
/// pieces between the outer chain's vertices decides.
bool is_inside(const Chain& hole, const Chain& outer) {
  for (const Segment& piece : cut_edges(hole, outer)) {
    const Location where = locate(midpoint(piece.source, piece.target), polygon(outer));
    if (where != Location::boundary) return where == Location::inside;
  }
  return false;
}

}  // namespace

std::size_t start_of_smallest_rotation(const Chain& chain) {
  const auto rotated = [&](std::size_t start) {
    Chain result(chain.begin() + static_cast<std::ptrdiff_t>(start), chain.end());
    result.insert(result.end(), chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(start));
    return result;
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const auto compared = chain[i] <=> chain[best];
    if (compared < 0 || (compared == 0 && rotated(i) < rotated(best))) best = i;
  }
  return best;
}

MinkowskiSum canonical_sum(const BoundaryFeatures& features) {
  MinkowskiSum sum;
  for (const Chain& stitched : stitch(features.edges)) {
    Chain chain = without_collinear_vertices(stitched);
    std::rotate(chain.begin(),
                chain.begin() + static_cast<std::ptrdiff_t>(start_of_smallest_rotation(chain)),
                chain.end());
    (sign(twice_area(chain)) > 0 ? sum.outer : sum.holes).push_back(std::move(chain));
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

MinkowskiSum canonical_sum(const Region& region) {
  return canonical_sum(BoundaryFeatures{boundary_pieces(region), {}, {}});
}

Region region_of(const MinkowskiSum& sum) {
  Region region;
  std::vector<Chain> holes;
  for (const std::vector<Chain>* of_sum : {&sum.outer, &sum.holes}) {
    for (const Chain& chain : *of_sum) {
      for (Chain& simple : simple_chains(chain)) {
        if (sign(twice_area(simple)) > 0)
          region.components.push_back({std::move(simple), {}});
        else
          holes.push_back(std::move(simple));
      }
    }
  }
  for (Chain& hole : holes) {
    // Of the outer chains around it, the smallest.
    Component* around = nullptr;
    for (Component& component : region.components) {
      if (is_inside(hole, component.outer) &&
          (around == nullptr || twice_area(component.outer) < twice_area(around->outer)))
        around = &component;
    }
    OPLUS_REQUIRES(around != nullptr, "Observation 3.1.4");
    around->holes.push_back(std::move(hole));
  }
  return region;
}

Rational area(const MinkowskiSum& sum) {
  Rational twice = 0;
  for (const Chain& chain : sum.outer)
    if (!OPLUS_MUTANT("area-is-of-the-first-chain",
                      "the area of a sum is that of one outer chain and the holes") ||
        &chain == &sum.outer[0])
      twice += twice_area(chain);
  for (const Chain& hole : sum.holes) twice += twice_area(hole);
  return twice / 2;
}

std::vector<Segment> edges(const MinkowskiSum& sum) {
  std::vector<Segment> result;
  for (const std::vector<Chain>* of_sum : {&sum.outer, &sum.holes}) {
    for (const Chain& chain : *of_sum) {
      const std::vector<Segment> of_chain = edges(chain);
      result.insert(result.end(), of_chain.begin(), of_chain.end());
    }
  }
  result.insert(result.end(), sum.dangling_edges.begin(), sum.dangling_edges.end());
  return result;
}

Origins origins(const MinkowskiSum& sum, const std::vector<ConvolutionSegment>& reduced) {
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
