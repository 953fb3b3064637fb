// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/certificates/triangulation.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <numeric>

#include "checked/certificates/shifted_doubles.hpp"

namespace oplus::certificates {

namespace {

using InDoubles = CGAL::Exact_predicates_inexact_constructions_kernel;
using InRationals = CGAL::Exact_predicates_exact_constructions_kernel;

/// A region's vertices and the ends of its edges, which have the numbers of their sources.
struct Boundary {
  explicit Boundary(const Region& region) {
    for (const Chain& chain : chains(region)) {
      const std::size_t first = points.size();
      points.insert(points.end(), chain.begin(), chain.end());
      for (std::size_t i = 0; i < chain.size(); ++i)
        targets.push_back(static_cast<std::uint32_t>(first + next(i, chain.size())));
    }
  }

  std::vector<Point> points;
  std::vector<std::uint32_t> targets;
};

/// CGAL's filters need numbers whose products are finite (docs/findings.md).
class Coordinates {
 public:
  explicit Coordinates(const Boundary& boundary) : doubles_(boundary.points) {
    are_doubles_ = std::ranges::all_of(boundary.points, [&](const Point& p) {
      return doubles_.near(p.x) == p.x && doubles_.near(p.y) == p.y;
    });
  }

  bool are_doubles() const { return are_doubles_; }

  template <typename Kernel>
  typename Kernel::Point_2 point(const Point& p) const {
    if constexpr (std::is_same_v<Kernel, InDoubles>) {
      const auto [x, y] = doubles_.near(p);
      return {x, y};
    } else {
      return {typename Kernel::FT(shifted(p.x)), typename Kernel::FT(shifted(p.y))};
    }
  }

 private:
  Rational shifted(Rational value) const {
    const long shift = doubles_.shift();
    if (shift > 0) value >>= static_cast<unsigned long>(shift);
    if (shift < 0) value <<= static_cast<unsigned long>(-shift);
    return value;
  }

  ShiftedDoubles doubles_;
  bool are_doubles_ = false;
};

/// The order in which points are inserted: neighbours one after another.
std::vector<std::size_t> spatial_order(const Boundary& boundary, const Coordinates& coordinates) {
  std::vector<std::size_t> order(boundary.points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<InDoubles::Point_2> near;
  for (const Point& p : boundary.points) near.push_back(coordinates.point<InDoubles>(p));
  auto places = CGAL::make_property_map(near);
  CGAL::spatial_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_2<InDoubles, decltype(places)>(places));
  return order;
}

template <typename Kernel>
class Maker {
 public:
  Maker(const Boundary& boundary, const Coordinates& coordinates)
      : boundary_(boundary), vertices_(boundary.points.size()) {
    typename Cdt::Face_handle hint;
    for (const std::size_t place : spatial_order(boundary, coordinates)) {
      const auto i = static_cast<std::uint32_t>(place);
      const std::size_t before = cdt_.number_of_vertices();
      vertices_[i] = cdt_.insert(coordinates.template point<Kernel>(boundary.points[i]), hint);
      hint = vertices_[i]->face();
      std::uint32_t& number = vertices_[i]->info();
      number = cdt_.number_of_vertices() == before ? std::min(number, i) : i;
    }
    for (std::uint32_t e = 0; e < vertices_.size(); ++e)
      cdt_.insert_constraint(vertices_[e], vertices_[boundary.targets[e]]);
  }

  Triangulation made() {
    number_triangles();
    Triangulation result;
    for (const auto face : faces_) {
      Triangle& triangle = result.triangles.emplace_back();
      for (int k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        triangle.corners[at] = face->vertex(k)->info();
        const int opposite = Cdt::cw(k);  // of the edge that leaves corner k
        triangle.across[at] =
            face->is_constrained(opposite) ? Triangle::none : face->neighbor(opposite)->info();
      }
    }
    for (std::uint32_t e = 0; e < vertices_.size(); ++e) add_points_in(e, result.points);
    return result;
  }

 private:
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
  using FaceBase = CGAL::Triangulation_face_base_with_info_2<
      std::uint32_t, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
  // Constraints are split at vertices that lie on them, and nowhere else.
  using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
      Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
      CGAL::No_constraint_intersection_requiring_constructions_tag>;
  static constexpr std::uint32_t unseen = ~std::uint32_t{0}, outside = unseen - 1;

  /// From the infinite face across the edges of the region, in and out.
  void number_triangles() {
    for (const auto face : cdt_.all_face_handles()) face->info() = unseen;
    std::vector<std::pair<typename Cdt::Face_handle, bool>> open = {{cdt_.infinite_face(), false}};
    while (!open.empty()) {
      const auto [face, is_inside] = open.back();
      open.pop_back();
      if (face->info() != unseen) continue;
      face->info() = outside;
      if (is_inside) {
        face->info() = static_cast<std::uint32_t>(faces_.size());
        faces_.push_back(face);
      }
      for (int k = 0; k < 3; ++k)
        if (face->neighbor(k)->info() == unseen)
          open.push_back({face->neighbor(k), is_inside != face->is_constrained(k)});
    }
  }

  void add_points_in(std::uint32_t edge, std::vector<PointInEdge>& points) const {
    const auto target = vertices_[boundary_.targets[edge]];
    for (auto at = vertices_[edge]; !cdt_.is_edge(at, target);) {
      at = next_on(at, target);
      points.push_back({edge, boundary_.points[at->info()]});
    }
  }

  /// The neighbour of a vertex on the way to another along a constraint.
  typename Cdt::Vertex_handle next_on(typename Cdt::Vertex_handle at,
                                      typename Cdt::Vertex_handle target) const {
    auto around = cdt_.incident_vertices(at);
    while (cdt_.is_infinite(around) ||
           CGAL::orientation(at->point(), around->point(), target->point()) != CGAL::COLLINEAR ||
           !CGAL::collinear_are_strictly_ordered_along_line(at->point(), around->point(),
                                                            target->point()))
      ++around;
    return around;
  }

  const Boundary& boundary_;
  Cdt cdt_;
  std::vector<typename Cdt::Vertex_handle> vertices_;
  std::vector<typename Cdt::Face_handle> faces_;
};

}  // namespace

Triangulation triangulation(const Region& region) {
  const Boundary boundary(region);
  if (boundary.points.empty()) return {};
  const Coordinates coordinates(boundary);
  return coordinates.are_doubles() ? Maker<InDoubles>(boundary, coordinates).made()
                                   : Maker<InRationals>(boundary, coordinates).made();
}

}  // namespace oplus::certificates
