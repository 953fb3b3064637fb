// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "checked/certificates/piece_sums.hpp"
#include "checked/collision/segment_tree.hpp"

namespace oplus::certificates {

/// The number of a dangling edge, or of an isolated vertex, in the order of the open set.
struct DanglingEdge {
  std::uint32_t number;
  friend bool operator==(const DanglingEdge&, const DanglingEdge&) = default;
};
struct IsolatedVertex {
  std::uint32_t number;
  friend bool operator==(const IsolatedVertex&, const IsolatedVertex&) = default;
};

/// Shows of a segment inside the closure of an open sum that its points but the ends are in the sum, or on dangling edges
/// and isolated vertices. Points divide it into intervals, one more than there are points.
struct Seam {
  /// Of a point: strictly inside the sum of two pieces, or on an edge, or a vertex. Of an interval: in the sum, and its
  /// middle strictly inside; or on an edge.
  using Place = std::variant<PieceSums::Pair, DanglingEdge, IsolatedVertex>;

  struct Point {
    Rational coordinate;  ///< x if the segment's line a x + b y + c = 0 has |a| <= |b|, else y
    Place place;
  };

  std::vector<Place> intervals;
  std::vector<Point> points;

  /// Whether there is nothing to be written: one interval, in the pair that is tried first.
  bool is_usual() const { return intervals.empty(); }
};

/// Makes seams. Almost all are one interval.
class Seams {
 public:
  using Corner = std::shared_ptr<const CellCorner>;

  /// Of the open set only dangling edges and isolated vertices are taken.
  Seams(PieceSums& sums, const ShiftedDoubles& doubles, const ClaimedSum& open_set);

  /// Of the segment between two points of the line, in the direction that has the positive side to its left; with a
  /// pair that is to be tried first. Throws PointOutsideSum.
  Seam seam(const Corner& from, const Corner& to, const IntegerLine& line,
            const PieceSums::Pair& usual);

 private:
  using Pair = PieceSums::Pair;

  /// An interval of a seam, and where it ends.
  struct Stretch {
    Seam::Place interval;
    Corner end;
  };

  bool is_inside_between(const Pair& pair, const CellCorner& from, const CellCorner& to);
  bool is_inside(const Pair& pair, const CellCorner& corner);
  Corner last_inside(const Pair& pair, const Corner& from, const Corner& to,
                     const IntegerLine& line);
  std::optional<Stretch> longest(const Corner& from, const Corner& to, const IntegerLine& line,
                                 bool starts_inside);
  Stretch along_edge(const Corner& from, const Corner& to, const IntegerLine& line) const;
  Seam::Place feature_at(const Corner& corner) const;
  std::vector<std::uint32_t> features_around(const Point& point) const;

  PieceSums& sums_;
  const ShiftedDoubles& doubles_;
  SegmentTree features_;  ///< dangling edges, then isolated vertices as segments without length
  std::uint32_t edges_;   ///< how many of them are edges
  std::vector<HalfPlane> half_planes_;
};

}  // namespace oplus::certificates
