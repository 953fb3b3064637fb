// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "checked/collision/segment_tree.hpp"
#include "checked/verify/verdict.hpp"
#include "reference/definitions/claimed_sum.hpp"
#include "reference/definitions/planar_set.hpp"

namespace oplus {

/// Twice the area to the left of a boundary.
Rational twice_area_inside(const std::vector<Segment>& boundary);

/// A given sum's chains and the right sum's, laid over each other. Near-linear in their edges and their
/// intersections.
class Overlay {
 public:
  /// Low-dimensional features are left out.
  Overlay(const ClaimedSum& given, const PlanarSet& right);

  /// Faces in which the two differ, connected ones together.
  struct Difference {
    Reason reason;                  ///< without a witness and details
    std::vector<Segment> boundary;  ///< of the largest of the faces
  };

  std::vector<Difference> differences() const;

  /// A point inside both; empty where no face is in both.
  std::optional<Point> common_point() const;

  /// What is at a point. A point on the boundary of a set is not in it.
  struct Place {
    Location of_given;
    Location of_right;
  };

  /// O(log n) by experience.
  Place locate(const Point& p) const;

  /// A piece of a chain of the given sum that is no simple boundary of its set.
  struct Unsimple {
    Segment piece;      ///< a point, where all of a chain is one
    bool in_given;      ///< whether the set is on both sides, or on neither; where one only:
    bool is_boundary;   ///< the set is on one side,
    std::size_t times;  ///< the number of chains that run there; one: it crosses another, or itself
  };

  /// All such pieces, those in line and connected as one; no point twice.
  std::vector<Unsimple> unsimple_pieces() const;

  /// The boundary of the given set, the set to the left, however its chains are turned.
  std::vector<Segment> boundary_of_given() const { return boundary_of_given_; }

 private:
  struct Face {
    bool in_given = false;
    bool in_right = false;
    std::uint32_t part_of_given = 0;  ///< the connected part of the set or its complement
    std::uint32_t part_of_right = 0;
    std::uint32_t difference = 0;  ///< the connected part of where both are the same
    std::uint32_t first_edge = 0;  ///< in edges_of_faces_; those before the next face's
  };
  /// Places by their numbers, the smaller one first.
  struct Edge {
    std::uint32_t source, target;
    std::uint32_t left_face, right_face;
  };

  Segment segment(const Edge& e) const { return {places_[e.source], places_[e.target]}; }
  std::span<const std::uint32_t> edges_of(std::size_t face) const;
  /// The face to the left; from its smallest vertex to the right. Requires: it is bounded.
  std::vector<Segment> boundary_of(std::size_t face) const;
  Rational twice_area_of(std::size_t face) const;

  /// The face that a point is in. Requires: it is on no edge.
  const Face& face_around(const Point& p) const;

  std::vector<Point> places_;
  std::vector<Edge> edges_;  ///< sorted
  std::vector<Face> faces_;  ///< the unbounded one first
  std::vector<std::uint32_t>
      edges_of_faces_;  ///< what has the same face on both sides is there twice
  mutable std::optional<SegmentTree> tree_;  ///< of these, once it is needed
  std::vector<Unsimple> unsimple_;
  std::vector<Unsimple> unsimple_points_;
  std::vector<Segment> boundary_of_given_;
};

}  // namespace oplus
