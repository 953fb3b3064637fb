// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "checked/distance/nearest_points.hpp"
#include "checked/layouts/layout.hpp"

namespace oplus {

/// What a layout must keep to. None is negative.
struct LayoutRules {
  Rational spacing;    ///< parts are at least that far from each other,
  Rational margin;     ///< and from what is outside of the container and from its defects
  Rational tolerance;  ///< an overlap that so short a move ends is forgiven
};

/// Two sets whose interiors meet.
struct OverlapFound {
  Point witness;  ///< an inner point of both
  Rational area;  ///< of what they have in common
  std::optional<Overlap>
      way_out;  ///< of the part; none: it fits nowhere in the container, as it is turned
};

struct LayoutFault {
  /// The part before it, or none: what is outside of the container, and its defects.
  std::optional<std::size_t> other;
  std::size_t part;  ///< from zero
  /// They overlap, or they are nearer than they must be: then `on_q` is on the part.
  std::variant<OverlapFound, NearestPoints> what;
};

struct SheetVerdict {
  std::vector<LayoutFault> faults;  ///< sorted; those of the container first
  std::size_t forgiven = 0;         ///< overlaps that are not deeper than the tolerance
  Rational used_area;               ///< of all parts
  /// Of the container, without defects; if there is none, of the smallest rectangle around all parts whose sides are
  /// parallel to the axes.
  Rational area;

  bool is_right() const { return faults.empty(); }
};

/// Decides, exactly, whether parts overlap in no inner point, lie in the container and on no defect that they must not
/// lie on, and keep their distances. Touching is allowed. A forgiven overlap counts as a contact: at distance zero.
/// Cost: near-linear for parts that do not overlap, by experience; for each fault that of a no-fit polygon.
SheetVerdict check(const Sheet& sheet, const LayoutRules& rules, unsigned threads);

}  // namespace oplus
