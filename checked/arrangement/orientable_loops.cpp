// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/orientable_loops.hpp"

#include <cstdint>
#include <optional>

#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

using Halfedge = ConvolutionArrangement::Halfedge;

/// Whether segments run along a halfedge and none against it.
bool is_directed(const ConvolutionArrangement& arrangement, Halfedge h) {
  return !arrangement.along(h).empty() &&
         arrangement.along(ConvolutionArrangement::twin(h)).empty();
}

/// Best_Direction: the outgoing halfedge that makes the largest clockwise turn, that is, the first
/// counterclockwise from where h came from; going around clockwise, the last.
std::optional<Halfedge> clockwise_most(const ConvolutionArrangement& arrangement, Halfedge h) {
  const Halfedge back = ConvolutionArrangement::twin(h);
  std::optional<Halfedge> best;
  for (Halfedge out = arrangement.clockwise(back); out != back; out = arrangement.clockwise(out)) {
    if (!is_directed(arrangement, out)) continue;
    best = out;
    if (OPLUS_MUTANT("loops-go-straight-on",
                     "where loops meet, tracing goes on along the same segment") &&
        arrangement.strand(out) == arrangement.strand(h))
      break;
    if (OPLUS_MUTANT("loops-turn-counterclockwise-most",
                     "where loops meet, tracing takes the wrong way out of the vertex"))
      break;
  }
  return best;
}

/// Record_Loop: the loop that an edge is on.
OrientableLoop loop_of(const ConvolutionArrangement& arrangement, Halfedge first) {
  OrientableLoop loop;
  Halfedge h = first;
  do {
    loop.push_back(h);
    h = *clockwise_most(arrangement, h);
  } while (h != first);
  return loop;
}

}  // namespace

std::vector<OrientableLoop> orientable_loops(const ConvolutionArrangement& arrangement) {
  constexpr std::uint32_t unvisited = 0;
  std::vector<std::uint32_t> id(2 * arrangement.edge_count(), unvisited);
  std::uint32_t current = unvisited;
  std::vector<OrientableLoop> loops;
  for (Halfedge start = 0; start < id.size(); ++start) {
    if (id[start] != unvisited || !is_directed(arrangement, start)) continue;
    ++current;
    id[start] = current;
    std::optional<Halfedge> h = clockwise_most(arrangement, start);
    while (h && id[*h] == unvisited) {
      id[*h] = current;
      h = clockwise_most(arrangement, *h);
    }
    if (h && id[*h] == current) loops.push_back(loop_of(arrangement, *h));
  }
  return loops;
}

}  // namespace oplus
