// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <boost/polygon/polygon.hpp>
#include <vector>

#include "properties/compare/peers/integer_scale.hpp"

namespace oplus {

/// The library's own version of its Minkowski example: a parallelogram for each pair of edges, and
/// each summand at a vertex of the other; the polygon set's union is the sum.
struct BoostPolygonMethod {
  using Vertex = boost::polygon::point_data<int>;
  using Polygon = boost::polygon::polygon_with_holes_data<int>;
  using PolygonSet = boost::polygon::polygon_set_data<int>;

  using Part = PolygonSet;
  struct Input {
    PolygonSet p;
    PolygonSet q;
    IntegerScale scale = {1};
  };
  using Sum = std::vector<Polygon>;
  static constexpr bool rounds = true;

  /// Differences of two such coordinates are still an int.
  static constexpr long most = 0x3FFFFFFF;

  static IntegerScale scale_of(const std::vector<Region>& regions) {
    return IntegerScale::of(regions, most, most);
  }
  Part part(const Region& region, const IntegerScale& scale) const { return set_of(region, scale); }
  Input paired(const Part& p, const Part& q) const { return {p, q}; }
  Input converted(const Summands& pair) const {
    const IntegerScale scale = scale_of({pair.p, pair.q});
    return {part(pair.p, scale), part(pair.q, scale), scale};
  }

  std::vector<Polygon> sum(const Input& pair) const {
    PolygonSet set;
    boost::polygon::detail::minkowski_offset<int>::convolve_two_polygon_sets(set, pair.p, pair.q);
    std::vector<Polygon> polygons;
    set.get(polygons);
    return polygons;
  }

  ReturnedChains chains(const Input& pair, const std::vector<Polygon>& sum) const {
    ReturnedChains chains;
    for (const Polygon& polygon : sum) {
      chains.push_back(oriented(chain_of(polygon, pair.scale), 1));
      for (auto hole = boost::polygon::begin_holes(polygon);
           hole != boost::polygon::end_holes(polygon); ++hole)
        chains.push_back(oriented(chain_of(*hole, pair.scale), -1));
    }
    return chains;
  }

 private:
  static std::vector<Vertex> vertices_of(const Chain& chain, const IntegerScale& scale) {
    std::vector<Vertex> vertices;
    for (const Point& p : chain)
      vertices.emplace_back(static_cast<int>(scale.scaled(p.x)),
                            static_cast<int>(scale.scaled(p.y)));
    return vertices;
  }

  static PolygonSet set_of(const Region& region, const IntegerScale& scale) {
    PolygonSet set;
    for (const Component& component : region.components) {
      Polygon polygon;
      const std::vector<Vertex> outer = vertices_of(component.outer, scale);
      boost::polygon::set_points(polygon, outer.begin(), outer.end());
      std::vector<boost::polygon::polygon_data<int>> holes;
      for (const Chain& hole : component.holes) {
        const std::vector<Vertex> vertices = vertices_of(hole, scale);
        holes.emplace_back(vertices.begin(), vertices.end());
      }
      boost::polygon::set_holes(polygon, holes.begin(), holes.end());
      set.insert(polygon);
    }
    set.clean();
    return set;
  }

  template <typename Ring>
  static Chain chain_of(const Ring& ring, const IntegerScale& scale) {
    Chain chain;
    for (const Vertex& v : ring) chain.push_back(scale.point(v.x(), v.y()));
    // Some of its rings repeat the first vertex at their end.
    if (chain.size() > 1 && chain.front() == chain.back()) chain.pop_back();
    return chain;
  }

  /// Orientation is not fixed in what Boost.Polygon returns.
  static Chain oriented(Chain chain, int wanted) {
    if (sign(twice_area(chain)) == -wanted) std::reverse(chain.begin(), chain.end());
    return chain;
  }
};

}  // namespace oplus
