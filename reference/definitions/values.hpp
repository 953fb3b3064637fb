// SPDX-License-Identifier: MIT
#pragma once

#include <gmpxx.h>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace oplus {

/// Every coordinate and every number derived from one: an exact rational in lowest terms.
using Rational = mpq_class;

/// A point of the plane and, equally, its radius vector: Minkowski sums add points.
struct Point {
  Rational x;  ///< to the right
  Rational y;  ///< upwards

  friend bool operator==(const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; }

  /// Cheaper than by way of a third point, which would be allocated.
  friend void swap(Point& a, Point& b) noexcept {
    a.x.swap(b.x);
    a.y.swap(b.y);
  }

  /// Lexicographic: by x, then by y.
  friend std::strong_ordering operator<=>(const Point& a, const Point& b) {
    const int by_x = cmp(a.x, b.x);
    return (by_x != 0 ? by_x : cmp(a.y, b.y)) <=> 0;
  }
};

using Vector = Point;  ///< A point, where it is used as a vector.

/// A directed segment (thesis, Definition 2.1.7).
struct Segment {
  Point source;  ///< where it starts
  Point target;  ///< where it ends

  friend bool operator==(const Segment&, const Segment&) = default;
  friend std::strong_ordering operator<=>(const Segment&, const Segment&) = default;
};

/// A closed polygonal chain (thesis, Definition 2.1.3), the last vertex joined to the first.
using Chain = std::vector<Point>;

/// An outer chain, counterclockwise, with holes, clockwise: the interior is to the left of each
/// edge.
struct Component {
  Chain outer;               ///< counterclockwise
  std::vector<Chain> holes;  ///< clockwise, each inside `outer`

  friend bool operator==(const Component&, const Component&) = default;
};

/// A general polygonal set (thesis, Definition 2.1.17). No component at all is the empty set. A valid
/// region has simple chains that may touch each other in points, but neither cross nor overlap.
///
/// A region may be unbounded, where that is said: the outer chain of one component is then empty, and the
/// component is the plane without its holes.
struct Region {
  std::vector<Component> components;  ///< in any order

  friend bool operator==(const Region&, const Region&) = default;
};

/// Where a point lies with respect to a region or a sum.
enum class Location { outside, boundary, inside };

/// The two polygons that are summed.
enum class Summand : std::uint8_t { P, Q };

/// closed: the regularized sum of the closed regions. open: the sum of their interiors, an open set
/// whose complement may have dangling edges and isolated vertices (thesis, Section 3.2.4).
enum class Boundary { closed, open };

/// A Minkowski sum as a value, in one canonical form, so that equal sums are ==:
///  1. each chain is a part of the boundary of one face of the complement, the sum to its left, and
///     turns clockwise most at a vertex it meets more than once (thesis, Definition 3.2.1);
///  2. it starts at its lexicographically smallest vertex and has no vertex inside a straight line;
///  3. `outer` chains are counterclockwise, `holes` clockwise; both are sorted;
///  4. dangling edges are maximal, directed from their smaller end, and sorted; so are isolated
///     vertices. Both are empty for the sum of closed regions.
///
/// Other sets are values of the same form: where a set is closed, dangling edges and isolated vertices
/// belong to it, as its parts without inner points; where it is open, to its complement.
struct PlanarSet {
  std::vector<Chain> outer;              ///< around components of the sum, counterclockwise
  std::vector<Chain> holes;              ///< around holes of the sum, clockwise
  std::vector<Segment> dangling_edges;   ///< of the open sum's complement
  std::vector<Point> isolated_vertices;  ///< likewise
  bool is_unbounded = false;             ///< whether the face around all chains belongs to it

  friend bool operator==(const PlanarSet&, const PlanarSet&) = default;
};

/// A vertex of a region, and the edge that leaves it: vertex `vertex` of chain `chain`, both from
/// zero; chains are counted component by component, the outer one, then the holes.
struct VertexIndex {
  std::size_t chain = 0;   ///< of the region, from zero
  std::size_t vertex = 0;  ///< of the chain, from zero

  friend auto operator<=>(const VertexIndex&, const VertexIndex&) = default;
};

/// The sum of an edge of one summand and a vertex of the other, named by their indices.
struct Origin {
  Summand edge_of;     ///< whose edge; the vertex is the other summand's
  VertexIndex edge;    ///< the edge that leaves this vertex
  VertexIndex vertex;  ///< of the other summand

  friend auto operator<=>(const Origin&, const Origin&) = default;
};

/// For each edge of a sum (of the outer chains, of the holes, then the dangling ones) the segments
/// of the reduced convolution that run along it: those that share more than a point with it and
/// have its direction (for a dangling edge, either). Sorted.
using Origins = std::vector<std::vector<Origin>>;

/// A sum from any source, as it was written down. Nothing is required: chains may have the wrong
/// orientation, cross, overlap, touch or repeat each other and themselves.
///
/// The set it stands for: a point on no chain belongs to it iff some component's outer chain winds
/// around it, in either direction, and none of that component's holes does; the set is the closure
/// of these points, for Boundary::open its interior without dangling edges and isolated vertices.
struct ClaimedSum {
  Region region;                         ///< chains as they were written down
  std::vector<Segment> dangling_edges;   ///< likewise
  std::vector<Point> isolated_vertices;  ///< likewise

  friend bool operator==(const ClaimedSum&, const ClaimedSum&) = default;
};

}  // namespace oplus
