// SPDX-License-Identifier: MIT
#include "checked/verify/exceptional_places.hpp"

#include "reference/chains/touching_points.hpp"
#include "reference/definitions/convolution.hpp"

namespace oplus {

namespace {

/// Around a vertex in which chains touch, the interior is not that of its corners one by one, so
/// that a contact with it may block though its segment is not in the convolution.
std::vector<Segment> contacts_of_touching_points(const Region& p, const Region& q,
                                                 const std::vector<Point>& touching_p,
                                                 const std::vector<Point>& touching_q) {
  std::vector<Segment> result;
  for (const Point& v : touching_p)
    for (const Segment& e : edges(q)) result.push_back({v + e.source, v + e.target});
  for (const Point& v : touching_q)
    for (const Segment& e : edges(p)) result.push_back({v + e.source, v + e.target});
  return result;
}

}  // namespace

std::vector<Segment> exceptional_places(const Region& p, const Region& q) {
  std::vector<Segment> all = segments(convolution(p, q));
  const std::vector<Segment> more =
      contacts_of_touching_points(p, q, touching_points(p), touching_points(q));
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace oplus
