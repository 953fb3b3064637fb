// SPDX-License-Identifier: MIT
#include "reference/definitions/tangent_count.hpp"

#include "reference/definitions/contract.hpp"
#include "reference/definitions/direction.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/tangent_set.hpp"
#include "reference/definitions/winding_number.hpp"

namespace oplus {

namespace {

int is_before(const Direction& u, const Direction& v) { return compare(u, v) < 0 ? 1 : 0; }

/// The winding number of x with respect to the sum of two edges, a parallelogram.
int winding_of_sum(const Point& x, const Segment& e, const Segment& f) {
  const Point corner = e.source + f.source, after_e = e.target + f.source,
              after_f = e.source + f.target, opposite = e.target + f.target;
  return winding_number(
      x, {{corner, after_e}, {after_e, opposite}, {opposite, after_f}, {after_f, corner}});
}

/// Winding numbers with respect to `around` of x - v, for the vertices v whose tangent set has d.
int vertices_inside(const Point& x, const Region& of, const Region& around, const Direction& d) {
  const std::vector<Segment> around_edges = edges(around);
  int count = 0;
  for (const Chain& chain : chains(of))
    for (std::size_t i = 0; i < chain.size(); ++i)
      if (in_tangent_set(d, corner_at(chain, i)))
        count += winding_number(x - chain[i], around_edges);
  return count;
}

}  // namespace

int tangent_count(const Point& x, const Region& p, const Region& q, const Vector& d) {
  OPLUS_REQUIRES(d != (Vector{0, 0}), "Definition 2.1.7");
  // Compared with P, d is of Q; compared with Q, it is of P: so it is equal to no edge.
  const Direction to_p{d, Summand::Q}, to_q{-d, Summand::P};
  int count = vertices_inside(x, p, q, to_p) + vertices_inside(x, q, p, to_q);
  const int ends = compare_angle(d, -d) < 0 ? 1 : 0;
  for (const Segment& edge_of_p : edges(p))
    for (const Segment& edge_of_q : edges(q)) {
      const Direction e{direction_of(edge_of_p), Summand::P},
          f{direction_of(edge_of_q), Summand::Q};
      const int weight = is_before(e, f) - is_before(e, to_p) + is_before(f, to_q) - ends;
      if (weight == 0) continue;
      const int winding = winding_of_sum(x, edge_of_p, edge_of_q);
      count += OPLUS_MUTANT("crossings-count-with-a-sign",
                            "crossings at which an edge of Q turns clockwise count negative")
                   ? winding
                   : weight * winding;
    }
  return count;
}

}  // namespace oplus
