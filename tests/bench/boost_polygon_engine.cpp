// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/polygon/polygon.hpp>

#include "tests/bench/integer_pair.hpp"

namespace oplus {

namespace {

namespace bp = boost::polygon;
using Vertex = bp::point_data<int>;
using Polygon = bp::polygon_with_holes_data<int>;
using PolygonSet = bp::polygon_set_data<int>;

/// Differences of two such coordinates are still an int.
constexpr long most = 0x3FFFFFFF;

struct SetPair {
  IntegerScale scale;
  PolygonSet p;
  PolygonSet q;
};

std::vector<Vertex> vertices_of(const Chain& chain, const IntegerScale& scale) {
  std::vector<Vertex> vertices;
  for (const Point& p : chain)
    vertices.emplace_back(static_cast<int>(scale.scaled(p.x)), static_cast<int>(scale.scaled(p.y)));
  return vertices;
}

PolygonSet set_of(const Region& region, const IntegerScale& scale) {
  PolygonSet set;
  for (const Component& component : region.components) {
    Polygon polygon;
    const std::vector<Vertex> outer = vertices_of(component.outer, scale);
    bp::set_points(polygon, outer.begin(), outer.end());
    std::vector<bp::polygon_data<int>> holes;
    for (const Chain& hole : component.holes) {
      const std::vector<Vertex> vertices = vertices_of(hole, scale);
      holes.emplace_back(vertices.begin(), vertices.end());
    }
    bp::set_holes(polygon, holes.begin(), holes.end());
    set.insert(polygon);
  }
  set.clean();
  return set;
}

template <typename Ring>
Chain chain_of(const Ring& ring, const IntegerScale& scale) {
  Chain chain;
  for (const Vertex& v : ring) chain.push_back(scale.point(v.x(), v.y()));
  // Some of its rings repeat the first vertex at their end.
  if (chain.size() > 1 && chain.front() == chain.back()) chain.pop_back();
  return chain;
}

/// Orientation is not fixed in what Boost.Polygon returns.
Chain oriented(Chain chain, int wanted) {
  if (sign(twice_area(chain)) == -wanted) std::reverse(chain.begin(), chain.end());
  return chain;
}

/// The library's own version of its Minkowski example: a parallelogram for each pair of edges, and
/// each summand at a vertex of the other; the polygon set's union is the sum.
struct BoostPolygon {
  using Input = SetPair;
  using Sum = std::vector<Polygon>;
  static constexpr Arithmetic arithmetic = Arithmetic::rounding;

  SetPair converted(const Summands& pair) const {
    const IntegerScale scale = IntegerScale::of(pair, most);
    return {scale, set_of(pair.p, scale), set_of(pair.q, scale)};
  }

  std::vector<Polygon> sum(const SetPair& pair) const {
    PolygonSet set;
    bp::detail::minkowski_offset<int>::convolve_two_polygon_sets(set, pair.p, pair.q);
    std::vector<Polygon> polygons;
    set.get(polygons);
    return polygons;
  }

  ReturnedChains chains(const SetPair& pair, const std::vector<Polygon>& sum) const {
    ReturnedChains chains;
    for (const Polygon& polygon : sum) {
      chains.push_back(oriented(chain_of(polygon, pair.scale), 1));
      for (auto hole = bp::begin_holes(polygon); hole != bp::end_holes(polygon); ++hole)
        chains.push_back(oriented(chain_of(*hole, pair.scale), -1));
    }
    return chains;
  }
};

}  // namespace

std::unique_ptr<PreparedPairs> prepare_boost_polygon(const std::vector<Summands>& pairs) {
  return sums_by(BoostPolygon{}, pairs);
}

}  // namespace oplus
