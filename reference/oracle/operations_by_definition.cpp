// SPDX-License-Identifier: MIT
#include "reference/oracle/operations_by_definition.hpp"

#include <algorithm>

#include "reference/definitions/collision.hpp"
#include "reference/oracle/cell_sets.hpp"
#include "reference/oracle/set_by_pieces.hpp"

namespace oplus {

namespace {

/// All x for which Q + x is in a set.
PlanarSet placements_in(const SetByPieces& set, const SetByPieces& q) {
  return set_where(vertex_edge_sum(set, reflected(q)), Boundary::closed,
                   [&](const Point& x) { return is_subset(translated(q, x), set); });
}

/// All x for which x - Q and a set meet: the sums of their points.
PlanarSet sums_of_points(const SetByPieces& set, const SetByPieces& q) {
  const SetByPieces minus_q = reflected(q);
  return set_where(vertex_edge_sum(set, q), Boundary::closed,
                   [&](const Point& x) { return meet(translated(minus_q, x), set); });
}

PlanarSet sum(const Region& p, const Region& q) {
  return sums_of_points(set_by_pieces(p), set_by_pieces(q));
}

PlanarSet path_sum(const Region& p, const Region& q) {
  return sums_of_points(path_and_points(p), set_by_pieces(q));
}

/// Without points of Q: no sum of two points is a cell of the arrangement.
PlanarSet sum_of_paths(const Region& p, const Region& q) {
  SetByPieces of_q = path_and_points(q);
  of_q.points.clear();
  return sums_of_points(path_and_points(p), of_q);
}

PlanarSet nfp(const Region& p, const Region& q) {
  const SetByPieces set = set_by_pieces(p), other = set_by_pieces(q);
  const bool meet_far_away = set.is_unbounded && other.is_unbounded;
  return set_where(vertex_edge_sum(set, reflected(other)), Boundary::open, [&](const Point& x) {
    return meet_far_away || interiors_meet(p, translated(q, x));
  });
}

PlanarSet ifp(const Region& p, const Region& q) {
  return placements_in(set_by_pieces(p), set_by_pieces(q));
}

PlanarSet erode(const Region& p, const Region& q) { return regularized(ifp(p, q)); }

PlanarSet open(const Region& p, const Region& q) {
  return sums_of_points(set_by_pieces(ifp(p, q)), set_by_pieces(q));
}

PlanarSet close(const Region& p, const Region& q) {
  return regularized(placements_in(set_by_pieces(sum(p, q)), set_by_pieces(q)));
}

PlanarSet complement(const Region& p, const Region& /*any*/) {
  return set_where(edges(p), Boundary::closed,
                   [&](const Point& x) { return locate(x, p) != Location::inside; });
}

PlanarSet union_of(const Region& p, const Region& q) {
  std::vector<Segment> all = edges(p);
  for (const Segment& e : edges(q)) all.push_back(e);
  return set_where(all, Boundary::closed, [&](const Point& x) {
    return locate(x, p) != Location::outside || locate(x, q) != Location::outside;
  });
}

}  // namespace

const std::vector<DefinedOperation>& defined_operations() {
  static const std::vector<DefinedOperation> all = {
      {"closed-sum", "all x for which x - Q and P have a point in common", sum},
      {"nfp", "all x for which the interiors of Q + x and P have a point in common", nfp},
      {"ifp", "all x for which Q + x is a subset of P", ifp},
      {"erode", "the closure of the interior of the set of all x for which Q + x is a subset of P",
       erode},
      {"open", "all points of those Q + x that are subsets of P", open},
      {"close",
       "the closure of the interior of the set of all x for which each point of Q + x is the sum "
       "of a point of P and one of Q",
       close},
      {"complement", "all x that are not inside P", complement},
      {"union", "all x that are in P or in Q", union_of},
      {"path-sum", "all sums of a point of Q and one of the path and points made of P", path_sum},
      {"sum-of-paths",
       "all sums of a point of the path made of Q and one of the path and points made of P",
       sum_of_paths},
      {"rounded-sum", "closed-sum, which was rounded to a grid as promised", sum}};
  return all;
}

const DefinedOperation* find_defined_operation(const std::string& name) {
  const std::vector<DefinedOperation>& all = defined_operations();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const DefinedOperation& o) { return o.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace oplus
