// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "checked/slide/integer_summands.hpp"

namespace oplus::slide {

/// A vertex of a summand, or an edge without its ends.
struct Feature {
  std::uint32_t number;
  bool is_vertex;

  friend bool operator==(const Feature&, const Feature&) = default;
};

/// A ray along which the boundary of a summand leaves a point.
template <typename Numbers>
struct Ray {
  IntegerVector<Numbers> direction;
  bool interior_is_counterclockwise;  ///< which of its two sides is inside the summand
};

/// How the boundary of a summand runs around its vertices and through its edges, also where several
/// chains touch. To prepare: O(n log n) in practice if there are several chains, else O(n).
template <typename Numbers>
class BoundaryRays {
 public:
  BoundaryRays(const IntegerSummand<Numbers>& summand, const FloatBoxTree& tree)
      : summand_(summand), next_(summand.edges.size()) {
    for (std::uint32_t i = 0; i < next_.size(); ++i) next_[summand.previous[i]] = i;
    if (summand.first_of_chain.size() > 1) find_touching(tree);
  }

  /// The vertex that an edge enters.
  std::uint32_t target(std::uint32_t edge) const { return next_[edge]; }

  /// Calls add(ray) with all rays from a point, that of a vertex or inside an edge. Inside edges:
  /// requires that no other chain touches it there.
  template <typename Add>
  void each_ray(const Feature& feature, const Add& add) const {
    if (!feature.is_vertex) return through(feature.number, add);
    if (const Touching* touching = touching_at(feature.number)) {
      for (const std::uint32_t vertex : touching->vertices) around(vertex, add);
      for (const std::uint32_t edge : touching->edges) through(edge, add);
    } else {
      around(feature.number, add);
    }
  }

  /// The vertices of other chains inside an edge.
  std::span<const std::pair<std::uint32_t, std::uint32_t>> inside(std::uint32_t edge) const {
    const auto [first, last] =
        std::equal_range(inside_.begin(), inside_.end(), std::pair{edge, 0U},
                         [](const auto& a, const auto& b) { return a.first < b.first; });
    return std::span(inside_).subspan(static_cast<std::size_t>(first - inside_.begin()),
                                      static_cast<std::size_t>(last - first));
  }

  /// Whether several chains touch in a vertex.
  bool is_touching_point(const Feature& feature) const {
    return feature.is_vertex && touching_at(feature.number) != nullptr;
  }

  /// A number that is the same for all vertices at one point.
  std::uint32_t name(const Feature& feature) const {
    const std::uint32_t number =
        is_touching_point(feature) ? touching_at(feature.number)->vertices.front() : feature.number;
    return 2 * number + (feature.is_vertex ? 1 : 0);
  }

  /// Whether another chain touches some edge from within.
  bool has_inside() const { return !inside_.empty(); }

  bool has_touching_points() const { return !touching_.empty(); }

  /// One vertex for each point in which chains touch.
  std::vector<std::uint32_t> touching_points() const {
    std::vector<std::uint32_t> points;
    for (const Touching& touching : touching_) points.push_back(touching.vertices.front());
    return points;
  }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  /// A point in which chains touch: their vertices there, and the edges that it is inside of.
  struct Touching {
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint32_t> edges;
  };

  const Touching* touching_at(std::uint32_t vertex) const {
    if (touching_of_.empty() || touching_of_[vertex] == none) return nullptr;
    return &touching_[touching_of_[vertex]];
  }

  // The interior is to the left of an edge: counterclockwise of the ray ahead, clockwise of the one back.
  template <typename Add>
  void around(std::uint32_t vertex, const Add& add) const {
    add(Ray<Numbers>{summand_.edges[vertex].direction, true});
    add(Ray<Numbers>{-summand_.edges[summand_.previous[vertex]].direction, false});
  }
  template <typename Add>
  void through(std::uint32_t edge, const Add& add) const {
    add(Ray<Numbers>{summand_.edges[edge].direction, true});
    add(Ray<Numbers>{-summand_.edges[edge].direction, false});
  }

  void find_touching(const FloatBoxTree& tree) {
    touching_of_.assign(next_.size(), none);
    for (std::uint32_t v = 0; v < next_.size(); ++v) {
      if (touching_of_[v] != none) continue;
      ShortList<std::uint32_t> vertices{v}, edges;
      any_leaf_around(tree, near_source(summand_.near[v]).box(), [&](std::uint32_t edge) {
        if (summand_.chain_of[edge] == summand_.chain_of[v]) return false;
        const auto& along = summand_.edges[edge].direction;
        const auto to = summand_.edges[v].source - summand_.edges[edge].source;
        if (cross(along, to) != 0) return false;
        const auto place = dot(along, to);
        if (place == 0) vertices.push_back(edge);
        // What is at the target is at the source of the next edge.
        if (place > 0 && place < dot(along, along)) edges.push_back(edge);
        return false;
      });
      if (vertices.size() == 1 && edges.empty()) continue;
      for (const std::uint32_t vertex : vertices)
        touching_of_[vertex] = static_cast<std::uint32_t>(touching_.size());
      for (const std::uint32_t edge : edges) inside_.emplace_back(edge, v);
      touching_.push_back({{vertices.begin(), vertices.end()}, {edges.begin(), edges.end()}});
    }
    std::sort(inside_.begin(), inside_.end());
  }

  const IntegerSummand<Numbers>& summand_;
  std::vector<std::uint32_t> next_;
  std::vector<Touching> touching_;
  std::vector<std::uint32_t> touching_of_;  ///< of each vertex; empty if there is only one chain
  std::vector<std::pair<std::uint32_t, std::uint32_t>> inside_;  ///< edges and vertices, sorted
};

/// Of P and of Q.
template <typename Numbers>
using RaysOfBoth = std::array<BoundaryRays<Numbers>, 2>;

template <typename Numbers>
RaysOfBoth<Numbers> rays_of(const IntegerSummands<Numbers>& summands) {
  summands.prepare_boxes();
  return {BoundaryRays<Numbers>(summands.p, summands.tree_of_p),
          BoundaryRays<Numbers>(summands.q, summands.tree_of_q)};
}

}  // namespace oplus::slide
