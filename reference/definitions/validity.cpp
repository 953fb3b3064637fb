// SPDX-License-Identifier: MIT
#include "reference/definitions/validity.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

namespace oplus {

namespace {

/// The chains as chains(region) has them, not copied: a region may have millions of vertices.
using Chains = std::vector<const Chain*>;

Chains chains_in(const Region& region) {
  Chains result;
  for (const Component& component : region.components) {
    result.push_back(&component.outer);
    for (const Chain& hole : component.holes) result.push_back(&hole);
  }
  return result;
}

struct NamedEdge {
  const Point* source;
  const Point* target;
  VertexIndex index;
  std::size_t chain_length;
  const Rational* min_x;
  const Rational* max_x;

  Segment segment() const { return {*source, *target}; }
};

bool are_apart_in_y(const NamedEdge& a, const NamedEdge& b) {
  const auto [low_a, high_a] = std::minmax(a.source->y, a.target->y);
  const auto [low_b, high_b] = std::minmax(b.source->y, b.target->y);
  return high_a < low_b || high_b < low_a;
}

bool adjacent(const NamedEdge& a, const NamedEdge& b) {
  return a.index.chain == b.index.chain &&
         (next(a.index.vertex, a.chain_length) == b.index.vertex ||
          next(b.index.vertex, b.chain_length) == a.index.vertex);
}

std::optional<Defect> defect_of_chain(const Chain& chain, std::size_t index) {
  if (chain.size() < 3)
    return Defect{
        DefectKind::too_few_vertices, {index, 0}, {index, 0}, chain.empty() ? Point{} : chain[0]};
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const std::size_t j = next(i, chain.size());
    if (chain[i] == chain[j])
      return Defect{DefectKind::zero_length_edge, {index, i}, {index, j}, chain[i]};
  }
  std::vector<std::size_t> sorted(chain.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  std::sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) {
    const auto compared = chain[a] <=> chain[b];
    return compared != 0 ? compared < 0 : a < b;
  });
  // Of equal vertices, the first two in the chain's order.
  std::optional<Defect> found;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const std::size_t first = sorted[i - 1], second = sorted[i];
    if (chain[first] == chain[second] && (!found || second < found->second.vertex))
      found = Defect{DefectKind::repeated_vertex, {index, first}, {index, second}, chain[second]};
  }
  return found;
}

/// A defect of two edges; empty if there is no defect. Touching points of different chains go into `touching`.
std::optional<Defect> defect_of_pair(const NamedEdge& a, const NamedEdge& b,
                                     std::map<VertexIndex, std::vector<Point>>& touching) {
  const std::vector<Point> common = intersection(a.segment(), b.segment());
  if (common.empty()) return std::nullopt;
  const bool same_chain = a.index.chain == b.index.chain;
  const auto defect = [&](DefectKind kind) {
    return Defect{kind, std::min(a.index, b.index), std::max(a.index, b.index), common.front()};
  };
  if (common.size() == 2)
    return defect(same_chain ? DefectKind::self_overlap : DefectKind::chains_overlap);
  if (cross_properly(a.segment(), b.segment()))
    return defect(same_chain ? DefectKind::self_crossing : DefectKind::chains_cross);
  if (same_chain) {
    if (!adjacent(a, b)) return defect(DefectKind::self_touching);
    return std::nullopt;
  }
  touching[a.index].push_back(common.front());
  touching[b.index].push_back(common.front());
  return std::nullopt;
}

/// Compares all pairs of edges whose boxes meet, by a sweep over x.
std::optional<Defect> defect_of_edges(const Chains& all,
                                      std::map<VertexIndex, std::vector<Point>>& touching) {
  std::vector<NamedEdge> named;
  std::size_t count = 0;
  for (const Chain* chain : all) count += chain->size();
  named.reserve(count);
  for (std::size_t c = 0; c < all.size(); ++c) {
    const Chain& chain = *all[c];
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const Point& source = chain[i];
      const Point& target = chain[next(i, chain.size())];
      const auto [min_x, max_x] = std::minmax(source.x, target.x);
      named.push_back({&source, &target, {c, i}, chain.size(), &min_x, &max_x});
    }
  }
  std::sort(named.begin(), named.end(),
            [](const NamedEdge& a, const NamedEdge& b) { return *a.min_x < *b.min_x; });
  for (std::size_t i = 0; i < named.size(); ++i) {
    for (std::size_t j = i + 1; j < named.size() && *named[j].min_x <= *named[i].max_x; ++j) {
      if (are_apart_in_y(named[i], named[j])) continue;
      if (const auto defect = defect_of_pair(named[i], named[j], touching)) return defect;
    }
  }
  return std::nullopt;
}

struct Box {
  Point low;
  Point high;

  explicit Box(const Chain& chain) : low(chain[0]), high(chain[0]) {
    for (const Point& p : chain) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }

  bool is_apart_from(const Box& other) const {
    return high.x <= other.low.x || other.high.x <= low.x || high.y <= other.low.y ||
           other.high.y <= low.y;
  }
};

struct Side {
  bool inside = false, outside = false;
  VertexIndex edge;
  Point where;
};

/// On which sides of the polygon `around` the chain runs, as far as it does not touch it.
Side side_of(const Chain& chain, std::size_t index, const Chain& around,
             const std::map<VertexIndex, std::vector<Point>>& touching) {
  Region inner = polygon(around);
  if (sign(twice_area(around)) < 0)
    std::reverse(inner.components[0].outer.begin(), inner.components[0].outer.end());
  Side side;
  const std::vector<Segment> of_chain = edges(chain);
  for (std::size_t i = 0; i < of_chain.size(); ++i) {
    const auto touched = touching.find({index, i});
    const bool representative = i == 0 || touched != touching.end();
    if (!representative) continue;
    for (const Segment& piece :
         cut(of_chain[i], touched == touching.end() ? std::vector<Point>{} : touched->second)) {
      const bool is_inside =
          locate(midpoint(piece.source, piece.target), inner) == Location::inside;
      const bool changes_side =
          is_inside ? side.outside && !side.inside : side.inside && !side.outside;
      if (changes_side) {
        side.edge = {index, i};
        side.where = piece.source;
      }
      (is_inside ? side.inside : side.outside) = true;
    }
  }
  return side;
}

VertexIndex edge_through(const Point& p, const Chain& chain, std::size_t index) {
  const std::vector<Segment> of_chain = edges(chain);
  const auto edge = std::find_if(of_chain.begin(), of_chain.end(),
                                 [&](const Segment& e) { return lies_on(p, e); });
  return {index, static_cast<std::size_t>(edge - of_chain.begin())};
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
  const Chains all = chains_in(region);
  for (std::size_t c = 0; c < all.size(); ++c) {
    if (const auto defect = defect_of_chain(*all[c], c)) return defect;
  }
  std::map<VertexIndex, std::vector<Point>> touching;
  if (const auto defect = defect_of_edges(all, touching)) return defect;

  std::vector<std::size_t> outer_of;
  for (const Component& component : region.components)
    outer_of.insert(outer_of.end(), 1 + component.holes.size(), outer_of.size());
  std::vector<Box> boxes;
  for (const Chain* chain : all) boxes.emplace_back(*chain);
  std::vector<std::vector<bool>> is_inside(all.size(), std::vector<bool>(all.size(), false));
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = 0; b < all.size(); ++b) {
      if (a == b || boxes[a].is_apart_from(boxes[b])) continue;
      const Side side = side_of(*all[a], a, *all[b], touching);
      if (side.inside && side.outside)
        return Defect{DefectKind::chains_cross, side.edge, edge_through(side.where, *all[b], b),
                      side.where};
      is_inside[a][b] = side.inside;
    }
  }
  const auto defect = [&](DefectKind kind, std::size_t a, std::size_t b) {
    return Defect{kind, {a, 0}, {b, 0}, (*all[a])[0]};
  };
  const auto is_outer = [&](std::size_t c) { return outer_of[c] == c; };
  for (std::size_t a = 0; a < all.size(); ++a) {
    if (!is_outer(a) && !is_inside[a][outer_of[a]])
      return defect(DefectKind::hole_outside, a, outer_of[a]);
    for (std::size_t b = 0; b < all.size(); ++b) {
      if (a == b || !is_inside[a][b]) continue;
      if (!is_outer(a) && !is_outer(b) && outer_of[a] == outer_of[b])
        return defect(DefectKind::holes_nested, a, b);
      if (!is_outer(a) || !is_outer(b)) continue;
      bool in_a_hole = false;
      for (std::size_t h = 0; h < all.size(); ++h)
        in_a_hole = in_a_hole || (outer_of[h] == b && h != b && is_inside[a][h]);
      if (!in_a_hole) return defect(DefectKind::components_overlap, a, b);
    }
  }
  return std::nullopt;
}

}  // namespace oplus
