// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "checked/verify/verify.hpp"
#include "reference/definitions/given_sum.hpp"
#include "reference/definitions/minkowski_sum.hpp"

namespace oplus {

/// A given sum's chains and the right sum's, laid over each other.
class Overlay {
 public:
  /// Low-dimensional features are left out. Witnesses are on none of `avoided`.
  Overlay(const GivenSum& given, const MinkowskiSum& right, std::vector<Segment> avoided = {});

  /// Faces in which the two differ, connected ones together: a reason each, without details.
  std::vector<Reason> differing_faces() const;

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
    std::vector<Segment> boundary;
    bool in_given = false;
    bool in_right = false;
    std::size_t part_of_given = 0;  ///< the connected part of the set or its complement
    std::size_t part_of_right = 0;
    std::size_t difference = 0;  ///< the connected part of where both are the same
  };

  Reason reason_for(const std::vector<std::size_t>& faces) const;

  std::vector<Face> faces_;
  std::vector<std::pair<std::size_t, std::size_t>> neighbours_;  ///< faces on both sides of an edge
  std::vector<Segment> avoided_;
  std::vector<Unsimple> unsimple_;
  std::vector<Unsimple> unsimple_points_;
  std::vector<Segment> boundary_of_given_;
};

}  // namespace oplus
