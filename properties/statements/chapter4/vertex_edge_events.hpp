// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/definitions/tangent_set.hpp"

namespace oplus {

/// The event that a vertex of one of P and -Q+x passes through the inside of an edge of the other,
/// as -Q+x moves to the left: the case parameters of the thesis's Table 4.1.
struct VertexEdgeEvent {
  Summand vertex_of;      ///< Q for a vertex of -Q+x
  bool edge_upwards;      ///< the edge as P or -Q has it, its interior to the left
  bool in_convolution;    ///< whether vertex and edge make a segment of 𝒞
  bool vertex_is_reflex;  ///< a vertex inside a straight line counts as convex

  friend bool operator==(const VertexEdgeEvent&, const VertexEdgeEvent&) = default;
};

/// A row of the thesis's Tables 4.3 to 4.5, with the winding number of Table 4.6; or one of the
/// cases of convex vertices off the convolution, which the thesis has in the text.
struct TableRow {
  VertexEdgeEvent event;
  int winding_number;  ///< how much that of 𝒞 grows
  int components;      ///< how much the number of components of the intersection grows
  int with_flip_sets;  ///< how much the winding number of 𝒞′ grows
};

/// All 16 rows.
const std::vector<TableRow>& table_rows();

/// The row of an event.
const TableRow& row_of(const VertexEdgeEvent& event);

/// The event of an edge, directed as P or Q has it, and a vertex of the other summand.
/// Requires: the edge is not horizontal.
VertexEdgeEvent event_of(const Vector& edge, Summand edge_of, const Corner& vertex);

}  // namespace oplus
