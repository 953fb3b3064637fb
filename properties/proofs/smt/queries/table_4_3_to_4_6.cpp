// SPDX-License-Identifier: GPL-3.0-or-later
// How the number of components changes in each row of the tables. (How winding numbers do follows from
// the row's parameters alone: a segment of the convolution is crossed, or none is.) All is seen from the vertex, as P and -Q have it: the
// corner's sector there, and the other's half plane, whose border passes the vertex. While the half
// plane contains the vertex, it contains each ray from there up to some point, and intersects the
// sector in one component. While it does not, it contains a ray from some point on if the ray
// points to the left of the edge, and no point of it otherwise: so there are as many components as
// there are arcs of directions in the sector and to the left of the edge. Edges parallel to those
// of the corner are turned apart by the tie rule: definition-2.2.7.tie-rule.
#include "properties/proofs/smt/built_regions.hpp"
#include "properties/proofs/smt/sectors.hpp"
#include "properties/statements/chapter4/euler_characteristic.hpp"
#include "properties/statements/chapter4/vertex_edge_events.hpp"

namespace oplus::smt {

namespace {

Summand edge_of(const TableRow& row) { return other(row.event.vertex_of); }

/// As its own summand has it.
const Vectors e = direction("e");

/// As P or -Q has it.
Vectors placed(const Vectors& v, Summand of) { return of == Summand::P ? v : opposite(v); }

/// Unknown directions and arcs of those in the sector and to the left of the edge.
class Arcs {
 public:
  explicit Arcs(const TableRow& row)
      : edge_(placed(e, edge_of(row))),
        corner_{placed(direction("in"), row.event.vertex_of),
                placed(direction("out"), row.event.vertex_of)} {
    for (const std::string name : {"d1", "d2", "d3", "d4", "d5"})
      unknown_.push_back(direction(name));
  }

  /// That there is this number of arcs. "None" and "no more" mean that no unknown directions show
  /// the contrary.
  Claim are(int count) const {
    switch (count) {
      case 0:
        return negation(has(unknown_[0]));
      case 1:
        return all_of({one_is_in(candidates(), [&](const Vectors& d) { return has(d); }),
                       negation(alternate(3, unknown_))});
      case 2: {
        const Vectors back = opposite(corner_.in);
        return all_of({alternate(3, {sum(edge_, back), back, sum(opposite(edge_), corner_.out)}),
                       negation(alternate(5, unknown_))});
      }
      default:
        return fact(false);
    }
  }

 private:
  Claim has(const Vectors& d) const {
    return all_of({is_left(edge_, d), is_in_sector(d, corner_)});
  }

  /// That directions to the left of the edge follow each other counterclockwise, the first in an arc,
  /// the second in none, and so on.
  Claim alternate(std::size_t count, const std::vector<Vectors>& d) const {
    std::vector<Claim> parts;
    for (std::size_t i = 0; i < count; ++i) {
      parts.push_back(is_left(edge_, d[i]));
      const Claim inside = is_in_sector(d[i], corner_);
      parts.push_back(i % 2 == 0 ? inside : negation(inside));
      if (i > 0) parts.push_back(is_left(d[i - 1], d[i]));
    }
    return all_of(parts);
  }

  /// An arc's ends are among the edge's directions and the corner's. Between two ends, less than π
  /// apart, is their sum; an arc of π has the vector to the left of the edge.
  std::vector<Vectors> candidates() const {
    const Vectors back = opposite(corner_.in), ahead = edge_, behind = opposite(edge_);
    return {sum(ahead, corner_.out), sum(ahead, back),       sum(behind, corner_.out),
            sum(behind, back),       sum(corner_.out, back), leftwards(edge_)};
  }

  Vectors edge_;
  Corners corner_;
  std::vector<Vectors> unknown_;
};

Claim goes_as_named(const TableRow& row) {
  return executed([edge = placed(e, edge_of(row)), row](const Values& values) {
    return sign(edge(values).y) == (row.event.edge_upwards ? 1 : -1);
  });
}

/// Whether the other's half plane has the vertex before the event, not after it, as -Q moves left:
/// -Q's half plane was farther right, or its vertex was.
Claim half_plane_has_vertex_before(const TableRow& row) {
  const int side = edge_of(row) == Summand::P ? 1 : -1;
  return executed([edge = placed(e, edge_of(row)), side](const Values& values) {
    return sign(cross(edge(values), TermVector{1, 0})) == side;
  });
}

Claim are_as_in_row(const TableRow& row) {
  const Arcs arcs(row);
  return if_then_else(half_plane_has_vertex_before(row), arcs.are(1 + row.components),
                      arcs.are(1 - row.components));
}

/// The pair as regions, moved through the event: whether other numbers of components are counted.
bool moves_otherwise(const Model& model, const TableRow& row) {
  const Vector edge = direction_in(model, "e");
  const Corner corner = corner_in(model);
  Rational size = 1;
  for (const Vector& v : {edge, corner.in, corner.out}) size += abs(v.x);
  const Region with_edge = region_with_edge(edge, 1000 * size * size);
  const Region with_corner = region_with_corner(corner);
  const Summands pair = edge_of(row) == Summand::P ? Summands{with_edge, with_corner}
                                                   : Summands{with_corner, with_edge};
  const Rational little(1, 1'000'000'007);
  // A horizontal edge is passed on the way up or down, into its half plane.
  const Point before = sign(edge.y) != 0 ? Point{little, 0} : Point{0, -sign(edge.x) * little};
  const IntersectionCounter counter(pair);
  const bool has_vertex_before = half_plane_has_vertex_before(row)(Values(model)).value().value();
  return counter.at(before).euler_characteristic() !=
             (has_vertex_before ? 1 : 1 - row.components) ||
         counter.at(-before).euler_characteristic() != (has_vertex_before ? 1 + row.components : 1);
}

std::string name_of(const TableRow& row) {
  const auto& [vertex_of, up, on, reflex] = row.event;
  return std::string(vertex_of == Summand::P ? "p" : "q") +
         (row.components == 0 ? ""
          : up                ? "-up"
                              : "-down") +
         (on ? "-on" : "-off") + (reflex ? "-reflex" : "-convex");
}

std::vector<Unknown> unknowns_for(const TableRow& row) {
  std::vector<Unknown> all = {any_direction("e"), any_direction("in"), any_direction("out")};
  const int looked_at = row.components == 0 ? 3 : 5;  // by Arcs::are
  for (int i = 1; i <= looked_at; ++i) all.push_back(any_direction("d" + std::to_string(i)));
  return all;
}

/// Only those that are needed: a corner that turns back is neither in the convolution nor reflex, and
/// where the number of components stays, it does so whichever way e goes.
std::vector<Hypothesis> hypotheses_for(const TableRow& row) {
  const auto& [vertex_of, up, on, reflex] = row.event;
  std::vector<Hypothesis> all = {
      {"convolution",
       {std::string("e is ") + (on ? "" : "not ") + "in the tangent set of the corner",
        same(fact(on), is_in_tangent_set(e, edge_of(row), corner()))}},
      {"vertex",
       {std::string("the corner is ") + (reflex ? "" : "not ") + "reflex",
        same(fact(reflex), is_a_reflex_vertex(corner()))}}};
  if (row.components != 0)
    all.push_back({"way",
                   {std::string("e goes ") + (up ? "up" : "down") + ", as P or -Q has it",
                    goes_as_named(row)}});
  if (!on)
    all.push_back(
        {"apart",
         {"e is parallel to neither edge of the corner",
          negation(any_of({are_parallel(e, corner().in), are_parallel(e, corner().out)}))}});
  if (!on && !reflex)
    all.push_back(
        {"turns", {"the corner of in and out does not turn back", negation(turns_back(corner()))}});
  return all;
}

Query query_for(const TableRow& row) {
  return {
      .id = "table-4.3-to-4.6." + name_of(row),
      .unknowns = unknowns_for(row),
      .hypotheses = hypotheses_for(row),
      .conclusion = {"the number of components grows by " + std::to_string(row.components),
                     are_as_in_row(row)},
      .is_false_by_definition = [&row](const Model& model) { return moves_otherwise(model, row); }};
}

/// One for two rows that differ in the way of e only, if it does not matter.
std::vector<Query> queries_of_rows() {
  std::vector<Query> all;
  for (const TableRow& row : table_rows())
    if (row.components != 0 || row.event.edge_upwards) all.push_back(query_for(row));
  return all;
}

const RegisteredQueries registered(queries_of_rows());

}  // namespace

}  // namespace oplus::smt
