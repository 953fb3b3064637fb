// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "reference/families/family.hpp"

namespace oplus {

/// Kinds of degeneracy of a pair. Cheap: looks at the summands only.
struct Classification {
  bool holes = false;               ///< a summand has a hole
  bool several_components = false;  ///< a summand has more than one component
  bool reflex_vertices = false;     ///< both summands have one
  bool parallel_edges = false;      ///< an edge of P and one of Q have equal or opposite directions
  bool collinear_vertices = false;  ///< a vertex inside a straight line
  bool overlapping_segments = false;  ///< two segments of the reduced convolution overlap
};
Classification classify(const Summands& summands);

/// Returns the names and values above, for counting and for reports.
std::map<std::string, bool> named(const Classification& classification);

}  // namespace oplus
