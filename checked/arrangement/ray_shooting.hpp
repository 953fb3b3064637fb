// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "reference/definitions/segment.hpp"

namespace oplus {

/// Winding numbers with respect to the full convolution by ray shooting (thesis, Section 5.2). An
/// interval tree over the segments' heights tells which of them a horizontal ray can meet:
/// O(log K + k) for k of K segments at the height of the ray.
class RayShooting {
 public:
  /// Requires: the segments form closed cycles.
  explicit RayShooting(std::vector<Segment> convolution);
  ~RayShooting();

  /// The winding number of the points directly to the right of the middle of a segment, which may
  /// be a part of the convolution's segments, cross some, or be another segment.
  int winding_number_right_of(const Segment& edge) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace oplus
