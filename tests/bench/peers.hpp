// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "properties/generators/family.hpp"

namespace oplus {

/// A sum by CGAL, its input converted beforehand, so that only the sum is measured.
class CgalSum {
 public:
  /// Requires: both summands are simple polygons.
  explicit CgalSum(const Summands& summands);
  CgalSum(const CgalSum&) = delete;
  CgalSum& operator=(const CgalSum&) = delete;
  ~CgalSum();

  /// Computes P ⊕ Q by CGAL's minkowski_sum_by_reduced_convolution_2. Returns its number of holes.
  std::size_t by_reduced_convolution() const;

 private:
  struct Polygons;
  Polygons* polygons_;
};

}  // namespace oplus
