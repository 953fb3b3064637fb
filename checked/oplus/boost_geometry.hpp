// SPDX-License-Identifier: MIT
#pragma once

#include <boost/geometry/core/access.hpp>
#include <boost/geometry/core/closure.hpp>
#include <boost/geometry/core/coordinate_dimension.hpp>
#include <boost/geometry/core/coordinate_system.hpp>
#include <boost/geometry/core/coordinate_type.hpp>
#include <boost/geometry/core/cs.hpp>
#include <boost/geometry/core/exterior_ring.hpp>
#include <boost/geometry/core/interior_rings.hpp>
#include <boost/geometry/core/interior_type.hpp>
#include <boost/geometry/core/mutable_range.hpp>
#include <boost/geometry/core/point_order.hpp>
#include <boost/geometry/core/point_type.hpp>
#include <boost/geometry/core/ring_type.hpp>
#include <boost/geometry/core/tag.hpp>
#include <boost/geometry/core/tags.hpp>
#include <boost/range/begin.hpp>
#include <boost/range/end.hpp>
#include <boost/range/size.hpp>
#include <boost/range/value_type.hpp>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>

#include "checked/oplus/number_types.hpp"
#include "checked/oplus/oplus.hpp"

/// @file
/// Whatever Boost.Geometry takes for a ring, a polygon or a multi-polygon, by its traits: its own
/// types, and types that users have registered.
namespace oplus {

/// What the functions of this header are made of.
namespace boost_adapter {

namespace bg = ::boost::geometry;

template <typename BoostPoint>
Point point_of(const BoostPoint& p) {
  static_assert(bg::dimension<BoostPoint>::value == 2, "oplus: points of the plane only");
  static_assert(std::is_same_v<typename bg::cs_tag<BoostPoint>::type, bg::cartesian_tag>,
                "oplus: Cartesian coordinates only");
  using Coordinate = typename bg::coordinate_type<BoostPoint>::type;
  static_assert(NumberConversion<Coordinate>::is_rational,
                "oplus: the coordinate type is not one of rational numbers, or unknown: see "
                "oplus::NumberConversion");
  using Conversion = NumberConversion<Coordinate>;
  return {Conversion::exact(bg::get<0>(p)), Conversion::exact(bg::get<1>(p))};
}

template <typename Ring>
Chain chain_of(const Ring& ring) {
  Chain chain;
  chain.reserve(boost::size(ring));
  for (auto p = boost::begin(ring); p != boost::end(ring); ++p) chain.push_back(point_of(*p));
  if (chain.size() > 1 && chain.front() == chain.back()) chain.pop_back();
  return chain;
}

template <typename Polygon>
void add_polygon(const Polygon& polygon, Region& region) {
  Component component{chain_of(bg::exterior_ring(polygon)), {}};
  const auto& holes = bg::interior_rings(polygon);
  for (auto hole = boost::begin(holes); hole != boost::end(holes); ++hole)
    component.holes.push_back(chain_of(*hole));
  if (!component.outer.empty() || !component.holes.empty())
    region.components.push_back(std::move(component));
}

template <typename Ring>
void set_ring(Ring& ring, const Chain& chain, bool is_clockwise) {
  using BoostPoint = typename bg::point_type<Ring>::type;
  using Conversion = NumberConversion<typename bg::coordinate_type<BoostPoint>::type>;
  static_assert(Conversion::is_rational, "oplus: see from_boost");
  const auto push_back = [&](const Point& p) {
    BoostPoint point;
    bg::set<0>(point, Conversion::nearest(p.x));
    bg::set<1>(point, Conversion::nearest(p.y));
    bg::traits::push_back<Ring>::apply(ring, point);
  };
  bg::traits::clear<Ring>::apply(ring);
  // The first vertex stays the first, whichever way the ring is turned.
  for (std::size_t i = 0; i < chain.size(); ++i)
    push_back(chain[is_clockwise ? (chain.size() - i) % chain.size() : i]);
  if (bg::closure<Ring>::value == bg::closed) push_back(chain.front());
}

template <typename Polygon>
void set_polygon(Polygon& polygon, const Component& component) {
  using Ring = typename bg::ring_type<Polygon>::type;
  // Our outer chains are counterclockwise, our holes clockwise: both are turned, or neither.
  const bool is_clockwise = bg::point_order<Ring>::value == bg::clockwise;
  auto&& outer = bg::exterior_ring(polygon);
  set_ring<Ring>(outer, component.outer, is_clockwise);
  auto&& holes = bg::interior_rings(polygon);
  bg::traits::resize<std::remove_reference_t<decltype(holes)>>::apply(holes,
                                                                      component.holes.size());
  auto hole = boost::begin(holes);
  for (const Chain& chain : component.holes) set_ring<Ring>(*hole++, chain, is_clockwise);
}

}  // namespace boost_adapter

/// Returns the region of a ring, a polygon or a multi-polygon, its coordinates exactly. Rings may be
/// turned either way, whatever their type says; a last point that equals the first is left out. What
/// has no points is the empty region. Throws InvalidInput where the region is invalid, and for
/// infinite coordinates and what is not a number. Compiles for Cartesian points of the plane whose
/// coordinates are rational (NumberConversion). Cost: that of ValidRegion's constructor.
template <typename Geometry>
ValidRegion from_boost(const Geometry& geometry) {
  namespace bg = ::boost::geometry;
  using Tag = typename bg::tag<Geometry>::type;
  Region region;
  if constexpr (std::is_same_v<Tag, bg::ring_tag>) {
    if (boost::size(geometry) != 0)
      region.components.push_back({boost_adapter::chain_of(geometry), {}});
  } else if constexpr (std::is_same_v<Tag, bg::polygon_tag>) {
    boost_adapter::add_polygon(geometry, region);
  } else {
    static_assert(std::is_same_v<Tag, bg::multi_polygon_tag>,
                  "oplus: rings, polygons and multi-polygons of Boost.Geometry only");
    for (auto polygon = boost::begin(geometry); polygon != boost::end(geometry); ++polygon)
      boost_adapter::add_polygon(*polygon, region);
  }
  return ValidRegion(std::move(region));
}

/// Returns a polygon per component, turned and closed as the type of multi-polygon wants it. Exact
/// where the coordinate type is; with floating-point coordinates each is the nearest double, and the
/// result may be invalid. Throws std::domain_error where coordinates are integers and cannot hold
/// the value: a fraction, or too large. Cost: the size.
///
/// Example: to_boost<MultiPolygon>(sum).
template <typename MultiPolygon>
MultiPolygon to_boost(const ValidRegion& region) {
  namespace bg = ::boost::geometry;
  static_assert(std::is_same_v<typename bg::tag<MultiPolygon>::type, bg::multi_polygon_tag>,
                "oplus: multi-polygons of Boost.Geometry only");
  if (is_unbounded(region))
    throw std::invalid_argument("oplus: no multi-polygon is unbounded, as this region is");
  MultiPolygon result;
  bg::traits::resize<MultiPolygon>::apply(result, region.components().size());
  auto polygon = boost::begin(result);
  for (const Component& component : region.components())
    boost_adapter::set_polygon(*polygon++, component);
  return result;
}

/// The same of a sum's components(). An open sum's dangling edges and isolated vertices are not in it.
template <typename MultiPolygon>
MultiPolygon to_boost(const ValidSet& sum) {
  return to_boost<MultiPolygon>(sum.region());
}

}  // namespace oplus
