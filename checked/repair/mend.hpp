// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "reference/io/invalid_input.hpp"

namespace oplus {

/// What a repair does to a region.
enum class MendKind {
  closed_ring,      ///< the last vertex was not the first one again: an edge joins them
  repeated_vertex,  ///< left out: equal to the one before it
  spike,            ///< a vertex left out at which the chain turns back on itself
  empty_chain,      ///< left out: it encloses nothing, or it is a hole of such a chain
  role,         ///< an outer chain became a hole, or a hole another chain's hole or an outer chain
  orientation,  ///< a chain was turned
  filled        ///< new chains, by a fill rule
};

/// Something that a repair did.
struct Mend {
  MendKind kind;     ///< what was wrong
  Place where;       ///< in the input; without a line for a region from code
  std::string what;  ///< in one line: the chain, the vertex and what was done
};

/// Which points chains enclose, by their winding number: where it is odd, or where it is not zero.
enum class FillRule { even_odd, nonzero };

}  // namespace oplus
