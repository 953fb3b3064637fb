// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <vector>

#include "checked/slide/box_tree.hpp"
#include "checked/slide/integer_vector.hpp"
#include "checked/slide/scaling.hpp"
#include "checked/slide/short_list.hpp"

namespace oplus::slide {

/// A segment in doubles, off by little: see `Margins`.
struct NearSegment {
  double x, y;    ///< of the source
  double dx, dy;  ///< of the direction
};

inline Box box_around(const NearSegment& s) { return box_around(s.x, s.y, s.x + s.dx, s.y + s.dy); }

/// A summand in integers. An edge and the vertex that it leaves have the same number.
template <typename Numbers>
struct IntegerSummand {
  ShortList<IntegerSegment<Numbers>> edges;
  ShortList<NearSegment> near;
  ShortList<std::uint32_t> previous;  ///< the edge that enters the vertex
  ShortList<VertexIndex> names;
  std::vector<std::uint32_t> first_of_component;  ///< its first edge; then the number of all
  std::vector<Box> boxes_of_components;
};

/// More than anything computed in doubles or floats can be off, given the largest coordinate.
struct Margins {
  double coordinate;   ///< sums of boxes and places on segments
  double point;        ///< coordinates of exact points, rounded
  double area;         ///< skew products of sums and differences of at most four coordinates
  bool area_is_exact;  ///< at ends of segments, such products are not off at all
};

inline Margins margins(const Scaling& scaling) {
  const double largest = std::ldexp(1.0, static_cast<int>(scaling.bits - scaling.shift));
  // A float has 24 bits, a double 53; what is shifted out is less than one in 2^60.
  return {largest * 0x1p-20, largest * 0x1p-45, largest * largest * 0x1p-42,
          scaling.bits <= 24 && scaling.shift == 0};
}

template <typename Numbers>
typename Numbers::Value value_of(const Rational& coordinate, const Scaling& scaling,
                                 const mpz_class& offset) {
  if constexpr (is_small<Numbers>) {
    if (scaling.is_trivial()) return coordinate.get_num().get_si();
    return scaled(coordinate, scaling, offset).get_si();
  } else {
    return typename Numbers::Value(
        boost::multiprecision::mpz_int(scaled(coordinate, scaling, offset).get_mpz_t()));
  }
}

template <typename Value>
double near(const Value& value, const Scaling& scaling) {
  if constexpr (std::is_same_v<Value, std::int64_t>)
    return static_cast<double>(value);
  else
    return scaled_down(value, scaling.shift);
}

template <typename Numbers>
NearSegment near(const IntegerSegment<Numbers>& segment, const Scaling& scaling) {
  return {near(segment.source.x, scaling), near(segment.source.y, scaling),
          near(segment.direction.x, scaling), near(segment.direction.y, scaling)};
}

template <typename Numbers>
IntegerSummand<Numbers> integer_summand(const Region& region, const Scaling& scaling,
                                        const Scaling::Offset& offset) {
  IntegerSummand<Numbers> summand;
  const std::size_t size = vertex_count(region);
  summand.edges.reserve(size);
  summand.near.reserve(size);
  summand.previous.reserve(size);
  summand.names.reserve(size);
  std::size_t chain_name = 0;
  const auto add = [&](const Chain& chain) {
    const auto first = static_cast<std::uint32_t>(summand.edges.size());
    const auto length = static_cast<std::uint32_t>(chain.size());
    for (const Point& v : chain)
      summand.edges.push_back(
          {{value_of<Numbers>(v.x, scaling, offset.x), value_of<Numbers>(v.y, scaling, offset.y)},
           {0, 0}});
    for (std::uint32_t i = 0; i < length; ++i) {
      auto& edge = summand.edges[first + i];
      edge.direction = summand.edges[first + (i + 1 == length ? 0 : i + 1)].source - edge.source;
      summand.near.push_back(near(edge, scaling));
      summand.previous.push_back(first + (i == 0 ? length : i) - 1);
      summand.names.push_back({chain_name, i});
    }
    ++chain_name;
  };
  for (const Component& component : region.components) {
    const std::size_t first = summand.edges.size();
    summand.first_of_component.push_back(static_cast<std::uint32_t>(first));
    add(component.outer);
    summand.boxes_of_components.push_back(box_around(summand.near[first]));
    for (std::size_t i = first + 1; i < summand.edges.size(); ++i)
      summand.boxes_of_components.back() =
          around(summand.boxes_of_components.back(), box_around(summand.near[i]));
    for (const Chain& hole : component.holes) add(hole);
  }
  summand.first_of_component.push_back(static_cast<std::uint32_t>(summand.edges.size()));
  return summand;
}

template <typename Numbers>
BoxTree box_tree(const IntegerSummand<Numbers>& summand) {
  std::vector<Box> boxes;
  boxes.reserve(summand.near.size());
  for (const NearSegment& s : summand.near) boxes.push_back(box_around(s));
  return BoxTree(boxes);
}

}  // namespace oplus::slide
