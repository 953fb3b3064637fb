// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/definitions/values.hpp"

namespace oplus {

/// Why a given set of points and chains is not a sum. Those of faces first, in the order in which a
/// face that tells the two apart is looked at: a face gets the first that holds.
enum class ReasonKind {
  missing_hole,                ///< all of a hole of the sum is filled
  additional_hole,             ///< a hole where the sum has none
  missing_component,           ///< all of a component of the sum is left out
  additional_component,        ///< a component that meets nothing of the sum
  joined_components,           ///< something that connects components of the sum
  split_component,             ///< something is left out that connects a component of the sum
  not_in_given,                ///< something else is left out
  not_in_sum,                  ///< something else is too much
  wrong_orientation,           ///< a clockwise outer chain, a counterclockwise hole
  unsimple_boundary,           ///< a piece of a chain bounds nothing, or is there more than once
  wrong_boundary,              ///< it is the sum of the other kind of boundary, closed or open
  missing_dangling_edge,       ///< or a part of one
  additional_dangling_edge,    ///< likewise
  missing_isolated_vertex,     ///< an isolated vertex is left out
  additional_isolated_vertex,  ///< an isolated vertex where the sum has none
};

/// Returns the name, in words: "missing hole".
std::string describe(ReasonKind kind);

/// Points of the summands that add up to another.
struct Addends {
  Point p;  ///< of P
  Point q;  ///< of Q
};

/// One difference between a given set and the sum, with a point that shows it.
struct Reason {
  ReasonKind kind;     ///< what is different
  Point witness;       ///< a point that shows it
  bool in_sum;         ///< whether the witness is in P ⊕ Q, of the kind that was asked for
  bool in_given;       ///< whether it is in the given set
  Rational size;       ///< twice the area of a face, the squared length of an edge, or 0
  std::string detail;  ///< a line that says where, for a person
};

/// Whether a given set is the sum, and why not.
struct Verdict {
  /// Whether the given sum is P ⊕ Q: no reasons.
  bool is_sum() const { return reasons.empty(); }

  PlanarSet right;  ///< P ⊕ Q

  /// Differing faces first, then chains, then low-dimensional features; of a sort the larger first,
  /// of equals the one whose witness is lexicographically smaller.
  std::vector<Reason> reasons;
  /// Of the first reason, where its witness is in the sum: p in P, q in Q, p + q the witness. Both
  /// are interior points, or, of a boundary point of the closed sum, boundary points.
  std::optional<Addends> addends;
  /// What is unusual and changes nothing: collinear or repeated vertices, chains that touch
  /// themselves.
  std::vector<std::string> notes;
};

}  // namespace oplus
