// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter4/vertex_edge_events.hpp"

#include <algorithm>

namespace oplus {

const std::vector<TableRow>& table_rows() {
  constexpr bool up = true, down = false, on = true, off = false, reflex = true, convex = false;
  static const std::vector<TableRow> rows = {
      // Table 4.3
      {{Summand::P, down, on, convex}, +1, +1, +1},
      {{Summand::Q, down, on, convex}, -1, -1, -1},
      {{Summand::P, up, on, convex}, -1, -1, -1},
      {{Summand::Q, up, on, convex}, +1, +1, +1},
      // in no table: nothing changes but the boundary of a component
      {{Summand::P, down, off, convex}, 0, 0, 0},
      {{Summand::Q, down, off, convex}, 0, 0, 0},
      {{Summand::P, up, off, convex}, 0, 0, 0},
      {{Summand::Q, up, off, convex}, 0, 0, 0},
      // Table 4.4, and Table 4.6 for 𝒞′
      {{Summand::P, down, off, reflex}, 0, -1, -1},
      {{Summand::Q, down, off, reflex}, 0, +1, +1},
      {{Summand::P, up, off, reflex}, 0, +1, +1},
      {{Summand::Q, up, off, reflex}, 0, -1, -1},
      // Table 4.5; 𝒞′ has no segment there
      {{Summand::P, down, on, reflex}, +1, 0, 0},
      {{Summand::Q, down, on, reflex}, -1, 0, 0},
      {{Summand::P, up, on, reflex}, -1, 0, 0},
      {{Summand::Q, up, on, reflex}, +1, 0, 0},
  };
  return rows;
}

const TableRow& row_of(const VertexEdgeEvent& event) {
  return *std::find_if(table_rows().begin(), table_rows().end(),
                       [&](const TableRow& row) { return row.event == event; });
}

VertexEdgeEvent event_of(const Vector& edge, Summand edge_of, const Corner& vertex) {
  const bool upwards_in_its_summand = sign(edge.y) > 0;
  return {other(edge_of), edge_of == Summand::P ? upwards_in_its_summand : !upwards_in_its_summand,
          in_tangent_set({edge, edge_of}, vertex), is_reflex(vertex)};
}

}  // namespace oplus
