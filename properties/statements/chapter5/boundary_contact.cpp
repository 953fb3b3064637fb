// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/statements/chapter5/boundary_contact.hpp"

#include <algorithm>
#include <stdexcept>

#include "reference/chains/touching_points.hpp"

namespace oplus {

namespace {

BoundaryContact contact_of(const Segment& s, const Segment& t) {
  if (cross_properly(s, t)) return BoundaryContact::crossing;
  if (overlap(s, t)) {
    return sign(dot(direction_of(s), direction_of(t))) > 0 ? BoundaryContact::same
                                                           : BoundaryContact::opposite;
  }
  return intersection(s, t).empty() ? BoundaryContact::none : BoundaryContact::weak;
}

}  // namespace

BoundaryContact strongest_contact(const Region& a, const Region& b) {
  // An edge also ends where another chain of its region touches it.
  const std::vector<Segment> edges_of_b = boundary_pieces(b);
  BoundaryContact strongest = BoundaryContact::none;
  for (const Segment& s : boundary_pieces(a)) {
    for (const Segment& t : edges_of_b) strongest = std::max(strongest, contact_of(s, t));
  }
  return strongest;
}

std::string describe(BoundaryContact contact) {
  switch (contact) {
    case BoundaryContact::none:
      return "without contact";
    case BoundaryContact::weak:
      return "with weak intersections only";
    case BoundaryContact::opposite:
      return "with opposite edges that overlap";
    case BoundaryContact::same:
      return "with edges of one direction that overlap";
    case BoundaryContact::crossing:
      return "with edges that cross";
  }
  throw std::logic_error("not a kind of contact");
}

}  // namespace oplus
