// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reference/definitions/region.hpp"

namespace oplus {

/// The kinds of contact of two boundaries (thesis, Section 5.1.1), each stronger than those before.
enum class BoundaryContact {
  none,
  weak,      ///< an end of an edge on an edge
  opposite,  ///< edges of opposite directions overlap
  same,      ///< edges of the same direction overlap
  crossing   ///< edges cross in a point interior to both
};

/// Returns the strongest kind of contact that the boundaries of two valid regions have, by
/// comparing all pairs of edges. An edge also ends where another chain of its region touches it.
BoundaryContact strongest_contact(const Region& a, const Region& b);

/// Returns a phrase for a count, such as "with weak intersections only".
std::string describe(BoundaryContact contact);

}  // namespace oplus
