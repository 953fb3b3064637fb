// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "reference/definitions/region.hpp"

namespace oplus {

/// The collision test of two fixed regions P and Q by the definition (collision.hpp), asked at many
/// placements. A proper crossing of two edges that certified intervals show is enough for a yes;
/// everything else is the definition's own answer.
class Placements {
 public:
  /// Requires: p and q are valid (validity.hpp).
  Placements(const Region& p, const Region& q);
  ~Placements();

  /// Whether the interiors of P and -Q+x meet, so that x is in the open sum.
  bool interiors_meet_at(const Point& x) const;

  /// A point of P that is one of -Q+x: an inner point of both, or, where their interiors do not
  /// meet, of both boundaries; empty where P and -Q+x are disjoint.
  std::optional<Point> common_point_at(const Point& x) const;

 private:
  struct Certified;

  const Region p_;
  const Region minus_q_;
  std::unique_ptr<const Certified> certified_;
};

}  // namespace oplus
