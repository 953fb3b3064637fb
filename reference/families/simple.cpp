// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "reference/families/polygons.hpp"

namespace oplus {

namespace {

// Integers below 2^53 are exact as doubles, and so are this kernel's predicates on them.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
using Triangulation =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;

constexpr int side = 1'000'000;

std::vector<std::pair<int, int>> distinct_points(Random& random, std::size_t count) {
  std::vector<std::pair<int, int>> points;
  std::set<std::pair<int, int>> seen;
  while (points.size() < count) {
    const std::pair<int, int> p{uniform(random, 0, side), uniform(random, 0, side)};
    if (seen.insert(p).second) points.push_back(p);
  }
  return points;
}

/// A triangulated polygon whose boundary moves inwards as triangles are taken away.
class Erosion {
 public:
  explicit Erosion(const std::vector<std::pair<int, int>>& points) : next_(points.size(), none) {
    Triangulation triangulation;
    // One by one and in the order drawn: inserting a range shuffles it first.
    for (std::size_t i = 0; i < points.size(); ++i)
      triangulation
          .insert({static_cast<double>(points[i].first), static_cast<double>(points[i].second)})
          ->info() = i;
    for (const auto face : triangulation.finite_face_handles()) {
      for (int i = 0; i < 3; ++i) {
        apex_[{face->vertex(triangulation.ccw(i))->info(),
               face->vertex(triangulation.cw(i))->info()}] = face->vertex(i)->info();
      }
    }
    if (apex_.empty()) return;  // all points on a line
    for (const auto& [edge, apex] : apex_) {
      if (apex_.contains({edge.second, edge.first})) continue;
      next_[edge.first] = edge.second;
      boundary_.push_back(edge.first);
    }
  }

  std::size_t size() const { return boundary_.size(); }

  /// Takes a triangle away that has two edges on the boundary, so that this loses a vertex, or
  /// one, so that it gains one. Returns false if there is none.
  bool take_ear(Random& random) {
    return take(random, [&](std::size_t u, std::size_t v, std::size_t w) {
      if (next_[v] != w || boundary_.size() == 3) return false;
      next_[u] = w;
      next_[v] = none;
      std::erase(boundary_, v);
      return true;
    });
  }
  bool take_inner(Random& random) {
    return take(random, [&](std::size_t u, std::size_t v, std::size_t w) {
      // With w on the boundary already, it would touch itself there.
      if (next_[w] != none) return false;
      next_[u] = w;
      next_[w] = v;
      boundary_.push_back(w);
      return true;
    });
  }

  /// The vertices in order, counterclockwise.
  std::vector<std::size_t> boundary() const {
    std::vector<std::size_t> result{boundary_.front()};
    for (std::size_t v = next_[result[0]]; v != result[0]; v = next_[v]) result.push_back(v);
    return result;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  /// Tries the triangles at the boundary edges, from a random one on, until one is taken.
  template <typename Try>
  bool take(Random& random, Try try_triangle) {
    const std::size_t count = boundary_.size();
    const std::size_t first = uniform_index(random, count);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t u = boundary_[(first + i) % count];
      const std::size_t v = next_[u];
      if (try_triangle(u, v, apex_.at({u, v}))) return true;
    }
    return false;
  }

  std::map<std::pair<std::size_t, std::size_t>, std::size_t> apex_;  ///< left of a directed edge
  std::vector<std::size_t> next_;      ///< after each vertex on the boundary; none elsewhere
  std::vector<std::size_t> boundary_;  ///< in no particular order
};

std::optional<Chain> eroded(Random& random, std::size_t n) {
  const std::vector<std::pair<int, int>> points = distinct_points(random, n + (n + 9) / 10);
  Erosion erosion(points);
  if (erosion.size() == 0) return std::nullopt;
  while (erosion.size() > n)
    if (!erosion.take_ear(random)) return std::nullopt;
  while (erosion.size() < n)
    if (!erosion.take_inner(random)) return std::nullopt;
  Chain chain;
  for (const std::size_t v : erosion.boundary())
    chain.push_back({points[v].first, points[v].second});
  return chain;
}

}  // namespace

Region simple_polygon(Random& random, std::size_t n) {
  while (true) {
    if (const std::optional<Chain> chain = eroded(random, n)) return polygon(*chain);
  }
}

}  // namespace oplus
