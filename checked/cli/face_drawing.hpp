// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "checked/arrangement/convolution_arrangement.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// A point and a disk around it that no edge of its face enters.
struct FreeDisk {
  Point centre;
  Rational squared_radius;
};

/// What it takes to draw an arrangement's faces. Evaluates each point once.
class FaceDrawing {
 public:
  using Face = ConvolutionArrangement::Face;
  using Halfedge = ConvolutionArrangement::Halfedge;

  /// Keeps the reference.
  explicit FaceDrawing(const ConvolutionArrangement& arrangement);

  /// The boundaries of a bounded face, which is to their left. They may touch each other and
  /// themselves, and contain an edge in both directions, so this need not be a valid region.
  Component outline(Face face) const;

  /// A large free disk inside a bounded face; empty if the face is lower or narrower than a
  /// hundredth of the arrangement. Its centre is the middle of a piece of a horizontal line, so it
  /// lies in the face, however that is bounded.
  std::optional<FreeDisk> free_disk(Face face) const;

 private:
  /// The halfedges around a face, one boundary after the other.
  std::vector<std::vector<Segment>> boundaries(Face face) const;

  const ConvolutionArrangement& arrangement_;
  std::vector<Point> points_;
  Rational smallest_;  ///< height and width of a face with a disk
};

}  // namespace oplus
