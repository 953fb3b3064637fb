// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "checked/slide/float_box_tree.hpp"
#include "checked/slide/fraction.hpp"
#include "checked/slide/integer_vector.hpp"
#include "checked/slide/leading_edge.hpp"
#include "checked/slide/scaling.hpp"
#include "checked/slide/short_list.hpp"

namespace oplus::slide {

/// Around the segment, whose doubles may be rounded.
template <typename Numbers>
FloatBox box_around(const NearSegment& s) {
  if constexpr (is_small<Numbers>) return box_around(s.x, s.y, s.x + s.dx, s.y + s.dy);
  const auto ends = [](double source, double direction) {
    const double error = 0x1p-50 * (std::abs(source) + std::abs(direction)) + 0x1p-400;
    return std::pair(source + std::min(direction, 0.0) - error,
                     source + std::max(direction, 0.0) + error);
  };
  const auto [low_x, high_x] = ends(s.x, s.dx);
  const auto [low_y, high_y] = ends(s.y, s.dy);
  return box_around(low_x, low_y, high_x, high_y);
}

/// The sign of the skew product of two directions where doubles tell it, else 0.
inline int certain_turn(double ax, double ay, double bx, double by) {
  const double left = ax * by, right = ay * bx;
  // Each factor is off by at most 2^-50 of its size or 2^-1074.
  const double error = 0x1p-48 * (std::abs(left) + std::abs(right)) + 0x1p-1000;
  return (left - right > error) - (right - left > error);
}

/// The direction of an edge: doubles tell most turns.
template <typename Numbers>
struct EdgeDirection {
  const IntegerVector<Numbers>& exact;
  const NearSegment& near;

  friend int certain_turn(const EdgeDirection& a, const EdgeDirection& b) {
    const int certain = certain_turn(a.near.dx, a.near.dy, b.near.dx, b.near.dy);
    return certain != 0 ? certain : certain_turn(a.exact, b.exact);
  }
  friend int turn(const EdgeDirection& a, const EdgeDirection& b) {
    const int certain = certain_turn(a, b);
    return certain != 0 ? certain : sign_of(cross(a.exact, b.exact));
  }
  bool is_lower() const { return exact.is_lower(); }
};

/// A summand in integers. An edge and the vertex that it leaves have the same number.
template <typename Numbers>
struct IntegerSummand {
  ShortList<IntegerSegment<Numbers>> edges;
  ShortList<NearSegment> near;  ///< less `place_of_most`
  std::vector<LeadingEdge>
      leading;  ///< where numbers may be out of the range of doubles, else empty
  ShortList<std::uint32_t> previous;            ///< the edge that enters the vertex
  ShortList<std::uint32_t> chain_of;            ///< the number of its chain
  ShortList<std::uint32_t> first_of_chain;      ///< its first edge
  ShortList<std::uint32_t> first_of_component;  ///< its first edge; then the number of all

  VertexIndex name(std::uint32_t vertex) const {
    return {chain_of[vertex], vertex - first_of_chain[chain_of[vertex]]};
  }
  EdgeDirection<Numbers> direction(std::uint32_t edge) const {
    return {edges[edge].direction, near[edge]};
  }
};

/// Whether floats can be exact.
inline bool has_short_numbers(const Scaling& scaling) {
  return scaling.bits <= 24 && scaling.shift == 0;
}

/// Whether numbers, or products of two, may be out of the range of doubles.
inline bool is_far_reaching(const Scaling& scaling) { return scaling.shift > 200; }

/// More than anything computed in doubles can be off, given the largest coordinate.
struct Margins {
  double point;        ///< coordinates of exact points, rounded
  double area;         ///< skew products of sums and differences of at most four coordinates
  bool area_is_exact;  ///< at ends of segments, such products are not off at all
  std::size_t shift;   ///< doubles are near to coordinates divided by 2^shift
};

inline Margins margins(const Scaling& scaling) {
  const double largest = std::ldexp(1.0, static_cast<int>(scaling.bits - scaling.shift));
  // A double has 53 bits; what is shifted out is less than one in 2^60.
  return {largest * 0x1p-45, largest * largest * 0x1p-40, has_short_numbers(scaling),
          scaling.shift};
}

template <typename Numbers>
typename Numbers::Value value_of(const Rational& coordinate, const Scaling& scaling,
                                 const mpz_class& offset) {
  if constexpr (is_small<Numbers>) {
    static_assert(Numbers::bits < 32,
                  "get_si() returns a long, which has 32 bits on some machines");
    if (scaling.is_trivial()) return coordinate.get_num().get_si();
    return scaled(coordinate, scaling, offset).get_si();
  } else if constexpr (is_wide<Numbers>) {
    return boost::multiprecision::mpz_int(scaled(coordinate, scaling, offset).get_mpz_t())
        .template convert_to<std::int64_t>();
  } else if constexpr (is_rational<Numbers>) {
    return typename Numbers::Value(Rational(coordinate * scaling.denominator).get_mpq_t());
  } else {
    return typename Numbers::Value(
        boost::multiprecision::mpz_int(scaled(coordinate, scaling, offset).get_mpz_t()));
  }
}

template <typename Value>
double near(const Value& value, std::size_t shift) {
  if constexpr (std::is_same_v<Value, std::int64_t>)
    return static_cast<double>(value);
  else
    return scaled_down(value, shift);
}

template <typename Numbers>
NearSegment near(const IntegerSegment<Numbers>& segment, const Scaling& scaling) {
  return {near(segment.source.x, scaling.shift), near(segment.source.y, scaling.shift),
          near(segment.direction.x, scaling.shift), near(segment.direction.y, scaling.shift)};
}

/// The median of the coordinates, so that a few vertices that are far from all others do not make
/// floats too coarse for those; the origin where no float is.
template <typename Numbers>
IntegerVector<Numbers> place_of_most(std::span<const IntegerSegment<Numbers>> edges,
                                     const Scaling& scaling) {
  if (has_short_numbers(scaling)) return {0, 0};
  const auto median = [&](const auto& coordinate) {
    std::vector<typename Numbers::Value> all;
    all.reserve(edges.size());
    for (const auto& edge : edges) all.push_back(coordinate(edge.source));
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return *middle;
  };
  return {median([](const auto& v) { return v.x; }), median([](const auto& v) { return v.y; })};
}

template <typename Numbers>
IntegerSummand<Numbers> integer_summand(const Region& region, const Scaling& scaling,
                                        const Scaling::Offset& offset) {
  IntegerSummand<Numbers> summand;
  const std::size_t size = vertex_count(region);
  summand.edges.reserve(size);
  summand.near.reserve(size);
  summand.previous.reserve(size);
  summand.chain_of.reserve(size);
  const auto add = [&](const Chain& chain) {
    const auto first = static_cast<std::uint32_t>(summand.edges.size());
    const auto length = static_cast<std::uint32_t>(chain.size());
    summand.chain_of.insert(summand.chain_of.end(), length,
                            static_cast<std::uint32_t>(summand.first_of_chain.size()));
    summand.first_of_chain.push_back(first);
    for (const Point& v : chain)
      summand.edges.push_back(
          {{value_of<Numbers>(v.x, scaling, offset.x), value_of<Numbers>(v.y, scaling, offset.y)},
           {0, 0}});
    for (std::uint32_t i = 0; i < length; ++i) {
      auto& edge = summand.edges[first + i];
      edge.direction = summand.edges[first + (i + 1 == length ? 0 : i + 1)].source - edge.source;
      summand.previous.push_back(first + (i == 0 ? length : i) - 1);
    }
  };
  for (const Component& component : region.components) {
    summand.first_of_component.push_back(static_cast<std::uint32_t>(summand.edges.size()));
    add(component.outer);
    for (const Chain& hole : component.holes) add(hole);
  }
  const IntegerVector<Numbers> most = place_of_most<Numbers>(span_of(summand.edges), scaling);
  for (const IntegerSegment<Numbers>& edge : summand.edges)
    summand.near.push_back(
        near(IntegerSegment<Numbers>{edge.source - most, edge.direction}, scaling));
  if constexpr (!has_fixed_width<Numbers>)
    if (is_far_reaching(scaling))
      for (const IntegerSegment<Numbers>& edge : summand.edges)
        summand.leading.push_back(LeadingEdge::of(edge));
  summand.first_of_component.push_back(static_cast<std::uint32_t>(summand.edges.size()));
  return summand;
}

template <typename Numbers>
FloatBoxTree float_box_tree(const IntegerSummand<Numbers>& summand, unsigned threads) {
  std::vector<FloatBox> boxes;
  boxes.reserve(summand.near.size());
  for (const NearSegment& s : summand.near) boxes.push_back(box_around<Numbers>(s));
  return FloatBoxTree(boxes, span_of(summand.near), span_of(summand.first_of_chain), threads);
}

/// Around what the nodes of its tree stand for.
template <typename Numbers>
std::vector<LeadingBox> leading_boxes(const IntegerSummand<Numbers>& summand,
                                      const FloatBoxTree& tree) {
  std::vector<LeadingBox> boxes(summand.leading.empty() ? 0 : tree.size());
  for (std::size_t i = boxes.size(); i-- > 0;) {
    const FloatBoxTree::Node& node = tree[static_cast<std::uint32_t>(i)];
    if (node.is_leaf()) {
      const LeadingEdge& edge = summand.leading[node.edge];
      boxes[i] = around(LeadingBox::of(edge.source), LeadingBox::of(edge.target));
    } else {
      boxes[i] = around(boxes[i + 1], boxes[node.right]);
    }
  }
  return boxes;
}

}  // namespace oplus::slide
