// SPDX-License-Identifier: MIT
#include "reference/chains/validity.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "reference/arithmetic/interval.hpp"
#include "reference/chains/clearly_simple.hpp"
#include "reference/chains/nesting.hpp"

namespace oplus {

namespace {

using Edge = std::uint32_t;

std::optional<Defect> defect_of_chain(const Chain& chain, std::size_t index) {
  if (chain.size() < 3)
    return Defect{
        DefectKind::too_few_vertices, {index, 0}, {index, 0}, chain.empty() ? Point{} : chain[0]};
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const std::size_t j = next(i, chain.size());
    if (chain[i] == chain[j])
      return Defect{DefectKind::zero_length_edge, {index, i}, {index, j}, chain[i]};
  }
  return std::nullopt;
}

bool is_clearly_simple(const Chain& chain) {
  std::vector<NearPoint> points;
  points.reserve(chain.size());
  for (const Point& p : chain) points.push_back(near_point(p));
  return is_clearly_simple(points);
}

/// Of equal vertices, the first two in the chain's order.
std::optional<Defect> repeated_vertex(const Chain& chain, std::size_t index) {
  std::vector<std::size_t> sorted(chain.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  std::sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) {
    const auto compared = chain[a] <=> chain[b];
    return compared != 0 ? compared < 0 : a < b;
  });
  std::optional<Defect> found;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const std::size_t first = sorted[i - 1], second = sorted[i];
    if (chain[first] == chain[second] && (!found || second < found->second.vertex))
      found = Defect{DefectKind::repeated_vertex, {index, first}, {index, second}, chain[second]};
  }
  return found;
}

/// Finds what is wrong at one place of a sweep.
class DefectsAtPlaces {
 public:
  explicit DefectsAtPlaces(const SweptChains& chains)
      : chains_(chains), edges_here_(chains.first_of_chain.size(), 0) {}

  std::optional<Defect> at(const SweptPlace& place) {
    for (std::size_t i = 1; i < place.right.size(); ++i) {
      const Edge a = place.right[i - 1], b = place.right[i];
      if (are_parallel(a, b))
        return defect(chain(a) == chain(b) ? DefectKind::self_overlap : DefectKind::chains_overlap,
                      a, b, place.point);
    }
    if (!chains_.is_touched(place)) return std::nullopt;
    around_.assign(place.right.begin(), place.right.end());
    around_.insert(around_.end(), place.left.rbegin(), place.left.rend());
    std::optional<Defect> found = defect_of_one_chain(place);
    return found ? found : crossing(place);
  }

 private:
  std::uint32_t chain(Edge e) const { return chains_.chain_of[e]; }

  Defect defect(DefectKind kind, Edge a, Edge b, const Point& where) const {
    return {kind, chains_.name(std::min(a, b)), chains_.name(std::max(a, b)), where};
  }

  bool are_parallel(Edge a, Edge b) const {
    const auto points = [&](Edge e) {
      const SweptEdges::Edge& ends = chains_.edges.edges[e];
      return std::pair(chains_.edges.points[ends.source], chains_.edges.points[ends.target]);
    };
    const auto [source_a, target_a] = points(a);
    const auto [source_b, target_b] = points(b);
    const std::optional<int> known = sign(cross(interval(*target_a) - interval(*source_a),
                                                interval(*target_b) - interval(*source_b)));
    return (known ? *known : sgn(cross(*target_a - *source_a, *target_b - *source_b))) == 0;
  }

  /// Two edges meet at a vertex of a chain, or one passes. Where there are more, the chain is not simple.
  std::optional<Defect> defect_of_one_chain(const SweptPlace& place) {
    std::optional<std::uint32_t> wrong;
    for (const Edge e : around_)
      if (++edges_here_[chain(e)] > 2) wrong = chain(e);
    for (const Edge e : around_) edges_here_[chain(e)] = 0;
    if (!wrong) return std::nullopt;
    std::vector<Edge> vertices, passing;
    for (const Edge v : place.points)
      if (chain(v) == *wrong)
        vertices.push_back(v);  // the vertex that an edge leaves has its index
    if (vertices.size() > 1)
      return defect(DefectKind::repeated_vertex, vertices[0], vertices[1], place.point);
    for (const Edge e : place.left)
      if (chain(e) == *wrong && passes(chains_.edges, e, place)) passing.push_back(e);
    if (passing.size() > 1)
      return defect(DefectKind::self_crossing, passing[0], passing[1], place.point);
    return defect(DefectKind::self_touching, passing[0], vertices[0], place.point);
  }

  /// Each chain has two edges around the place, or one that passes it twice: these don't cross where they
  /// are nested like parentheses.
  std::optional<Defect> crossing(const SweptPlace& place) {
    std::vector<Edge> open;
    for (const Edge e : around_) {
      if (!open.empty() && chain(open.back()) == chain(e)) {
        edges_here_[chain(e)] = 0;
        open.pop_back();
      } else if (edges_here_[chain(e)] != 0) {
        return defect(DefectKind::chains_cross, open.back(), e, place.point);
      } else {
        edges_here_[chain(e)] = 1;
        open.push_back(e);
      }
    }
    return std::nullopt;
  }

  const SweptChains& chains_;
  std::vector<std::uint32_t> edges_here_;  // of each chain; zero between places
  std::vector<Edge> around_;               // the place, counterclockwise
};

/// A chain is inside those around it. All is right where directly around each hole is its outer chain, and
/// around each outer chain a hole, or nothing.
std::optional<Defect> defect_of_nesting(const Region& region, const std::vector<const Chain*>& all,
                                        const Nesting& nesting) {
  std::vector<std::size_t> outer_of;
  for (const Component& component : region.components)
    outer_of.insert(outer_of.end(), 1 + component.holes.size(), outer_of.size());
  const auto is_outer = [&](std::size_t c) { return outer_of[c] == c; };
  const auto is_wrong = [&](std::size_t c) {
    const std::optional<std::size_t> around = nesting.around(c);
    return is_outer(c) ? around && is_outer(*around) : around != outer_of[c];
  };
  const auto defect = [&](DefectKind kind, std::size_t a, std::size_t b) {
    return Defect{kind, {a, 0}, {b, 0}, (*all[a])[0]};
  };
  std::size_t c = 0;
  while (c < all.size() && !is_wrong(c)) ++c;
  while (c < all.size()) {
    const std::size_t outer = is_outer(c) ? *nesting.around(c) : outer_of[c];
    // Of the chains around c: the last one before `outer`, a hole of `outer`, and `outer` itself.
    std::size_t before = c;
    std::optional<std::size_t> hole, found;
    for (std::optional<std::size_t> i = nesting.around(c); i; i = nesting.around(*i)) {
      if (!found && *i == outer) found = i;
      if (!found) before = *i;
      if (!hole && *i != outer && outer_of[*i] == outer) hole = i;
    }
    if (!found) return defect(DefectKind::hole_outside, c, outer);
    if (!is_outer(c) && hole) return defect(DefectKind::holes_nested, c, *hole);
    if (is_outer(c) && !hole) return defect(DefectKind::components_overlap, c, outer);
    // Around c and `outer` there is a hole of `outer`, or between them what is wrong itself.
    c = is_outer(c) ? *hole : before;
  }
  return std::nullopt;
}

}  // namespace

std::string describe(DefectKind kind) {
  static constexpr std::array phrases{"a chain has fewer than three vertices",
                                      "an edge has zero length",
                                      "a vertex is repeated",
                                      "two edges of a chain cross",
                                      "two edges of a chain overlap",
                                      "a chain touches itself",
                                      "two chains cross",
                                      "edges of two chains overlap",
                                      "a hole is outside its outer chain",
                                      "a hole is inside another hole",
                                      "two components overlap"};
  return phrases.at(static_cast<std::size_t>(kind));
}

std::optional<Defect> find_defect(const Region& region) {
  const std::vector<const Chain*> all = chains_in(region);
  for (std::size_t c = 0; c < all.size(); ++c) {
    if (const auto defect = defect_of_chain(*all[c], c)) return defect;
  }
  if (all.size() == 1 && is_clearly_simple(*all[0])) return std::nullopt;
  const SweptChains chains(all);
  DefectsAtPlaces defects(chains);
  Nesting nesting(chains);
  std::optional<Defect> found;
  sweep(chains.edges, [&](const SweptPlace& place) {
    found = defects.at(place);
    nesting.pass(place);
    return !found;
  });
  if (!found) return defect_of_nesting(region, all, nesting);
  // A repeated vertex says more than the edges that overlap or cross because of it.
  for (std::size_t c = 0; c < all.size(); ++c) {
    if (const auto defect = repeated_vertex(*all[c], c)) return defect;
  }
  return found;
}

}  // namespace oplus
