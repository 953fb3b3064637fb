// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace oplus {

/// Which set on the grid is asked for.
enum class Side {
  nearest,    ///< each point of the boundary moves by at most half a step in x and in y
  contain,    ///< a set that contains the given one
  contained,  ///< a set that is contained in the given one
};

/// What rounding did to components, those of the interior, and holes, the bounded components of the complement of the closed
/// set. All zero where each of them is still one.
struct TopologyChanges {
  std::size_t vanished_components = 0;  ///< nothing is left of them
  std::size_t joined_components = 0;    ///< they became one with others
  std::size_t split_components = 0;     ///< they came apart
  std::size_t new_components =
      0;  ///< around edges and points of a closed set; or cut off from an unbounded component
  std::size_t closed_holes =
      0;  ///< nothing is left of them; of an open set, edges and points may be
  std::size_t joined_holes = 0;  ///< they became one with others
  std::size_t split_holes = 0;   ///< they came apart
  std::size_t opened_holes = 0;  ///< they became one with the outside
  std::size_t new_holes =
      0;  ///< parts of the outside that were cut off; around edges and points of an open set
  std::size_t lost_edges_and_points =
      0;  ///< dangling edges and isolated vertices of which nothing is left

  friend bool operator==(const TopologyChanges&, const TopologyChanges&) = default;
};

}  // namespace oplus
