// SPDX-License-Identifier: MIT
#pragma once

#include <CGAL/MP_Float.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <ranges>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "checked/oplus/number_types.hpp"
#include "checked/oplus/oplus.hpp"

/// @file
/// CGAL's polygons, of any kernel with rational coordinates. It includes packages of CGAL under the
/// LGPL only.
namespace oplus {

/// CGAL's numbers of unlimited length without a division; exact.
template <>
struct NumberConversion<CGAL::MP_Float> {
  /// Each is a finite binary number.
  static constexpr bool is_rational = true;

  /// Returns the number, exactly.
  static Rational exact(const CGAL::MP_Float& value) {
    mpz_class digits = 0;
    for (auto limb = value.v.rbegin(); limb != value.v.rend(); ++limb) {
      digits <<= 16;
      digits += static_cast<int>(*limb);
    }
    const auto shift = static_cast<mp_bitcnt_t>(16 * std::abs(value.exp));
    Rational result = digits;
    if (value.exp < 0)
      result >>= shift;
    else
      result <<= shift;
    return result;
  }

  /// Returns the integer. Throws std::domain_error for another number.
  static CGAL::MP_Float nearest(const Rational& value) {
    if (value.get_den() != 1)
      throw std::domain_error("coordinate " + value.get_str() + ": not an integer");
    CGAL::MP_Float result = 0;
    for (const char c : value.get_num().get_str())
      if (c != '-') result = result * CGAL::MP_Float(10) + CGAL::MP_Float(c - '0');
    return value < 0 ? -result : result;
  }
};

/// What the functions of this header are made of.
namespace cgal_adapter {

template <typename Polygon>
Chain chain_of(const Polygon& polygon) {
  using CgalPoint = typename Polygon::Point_2;
  static_assert(
      !requires(const CgalPoint& p) { p.z(); }, "oplus: points of the plane only");
  using Coordinate = std::decay_t<decltype(std::declval<const CgalPoint&>().x())>;
  static_assert(
      NumberConversion<Coordinate>::is_rational,
      "oplus: this kernel's number type is not one of rational numbers (a type with roots, "
      "intervals, long double), or unknown: see oplus::NumberConversion");
  using Conversion = NumberConversion<Coordinate>;
  Chain chain;
  chain.reserve(polygon.size());
  for (auto p = polygon.vertices_begin(); p != polygon.vertices_end(); ++p)
    chain.push_back({Conversion::exact(p->x()), Conversion::exact(p->y())});
  return chain;
}

template <typename K, typename C>
Component component_of(const CGAL::Polygon_2<K, C>& polygon, std::size_t number) {
  if (polygon.is_empty())
    throw InvalidInput({"polygon " + std::to_string(number), 0, 0}, "it has no outer boundary",
                       "a bounded polygon");
  return {chain_of(polygon), {}};
}

template <typename K, typename C>
Component component_of(const CGAL::Polygon_with_holes_2<K, C>& polygon, std::size_t number) {
  Component component = component_of(polygon.outer_boundary(), number);
  for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
    component.holes.push_back(chain_of(*hole));
  return component;
}

template <typename T>
inline constexpr bool is_polygon = false;
template <typename K, typename C>
inline constexpr bool is_polygon<CGAL::Polygon_2<K, C>> = true;
template <typename K, typename C>
inline constexpr bool is_polygon<CGAL::Polygon_with_holes_2<K, C>> = true;

template <typename K>
CGAL::Polygon_2<K> polygon_of(const Chain& chain) {
  using Conversion = NumberConversion<typename K::FT>;
  static_assert(Conversion::is_rational, "oplus: see from_cgal");
  static_assert(!std::numeric_limits<typename K::FT>::is_integer,
                "oplus: this kernel's numbers are integers, which cannot hold every sum");
  CGAL::Polygon_2<K> polygon;
  for (const Point& p : chain)
    polygon.push_back(typename K::Point_2(Conversion::nearest(p.x), Conversion::nearest(p.y)));
  return polygon;
}

}  // namespace cgal_adapter

/// Returns the region of a polygon, its coordinates exactly. The polygon may be turned either way.
/// Throws InvalidInput where it has no vertices, where it is not simple, and for infinite
/// coordinates and what is not a number. Compiles for rational number types only (NumberConversion).
/// Cost: that of ValidRegion's constructor. Threads: lazy numbers (CGAL::Epeck) are evaluated, which
/// is as safe as CGAL makes it.
template <typename K, typename C>
ValidRegion from_cgal(const CGAL::Polygon_2<K, C>& polygon) {
  return ValidRegion(Region{{cgal_adapter::component_of(polygon, 1)}});
}

/// The same of a polygon with holes. One without an outer boundary is the plane without its holes.
template <typename K, typename C>
ValidRegion from_cgal(const CGAL::Polygon_with_holes_2<K, C>& polygon) {
  if (polygon.is_unbounded()) {
    Region holes;
    for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
      holes.components.push_back({cgal_adapter::chain_of(*hole), {}});
    return complement(ValidRegion(std::move(holes)));
  }
  return ValidRegion(Region{{cgal_adapter::component_of(polygon, 1)}});
}

/// The same of a range of polygons, with or without holes: its components. They may touch each other
/// in points; InvalidInput is thrown where they overlap, or one has no outer boundary.
template <std::ranges::input_range Range>
requires cgal_adapter::is_polygon<std::ranges::range_value_t<Range>> ValidRegion
from_cgal(const Range& polygons) {
  Region region;
  for (const auto& polygon : polygons)
    region.components.push_back(cgal_adapter::component_of(polygon, region.components.size() + 1));
  return ValidRegion(std::move(region));
}

/// Returns a polygon per component: outer boundaries counterclockwise, holes clockwise. Exact where
/// the kernel's number type is; with floating-point kernels each coordinate is the nearest double,
/// and the polygons may be invalid. Throws nothing but std::bad_alloc. Cost: the size.
///
/// Example: to_cgal<CGAL::Epeck>(sum).
template <typename K>
std::vector<CGAL::Polygon_with_holes_2<K>> to_cgal(const ValidRegion& region) {
  std::vector<CGAL::Polygon_with_holes_2<K>> polygons;
  for (const Component& component : region.components()) {
    polygons.emplace_back(cgal_adapter::polygon_of<K>(component.outer));
    for (const Chain& hole : component.holes)
      polygons.back().add_hole(cgal_adapter::polygon_of<K>(hole));
  }
  return polygons;
}

/// The same of a sum's components(). An open sum's dangling edges and isolated vertices are not in it.
template <typename K>
std::vector<CGAL::Polygon_with_holes_2<K>> to_cgal(const ValidSet& sum) {
  return to_cgal<K>(sum.region());
}

}  // namespace oplus
