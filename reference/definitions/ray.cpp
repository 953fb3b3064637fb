// SPDX-License-Identifier: MIT
#include "reference/definitions/ray.hpp"

#include <algorithm>

namespace oplus {

std::optional<Rational> first_met(const Point& start, const Vector& along,
                                  const std::vector<Segment>& segments) {
  std::optional<Rational> first;
  const auto at = [&](const Rational& t) {
    if (sign(t) > 0 && (!first || t < *first)) first = t;
  };
  const Rational length = dot(along, along);
  for (const Segment& s : segments) {
    const Vector to_source = s.source - start;
    const Vector v = direction_of(s);
    const Rational turn = cross(along, v);
    if (sign(turn) != 0) {
      const Rational on_segment = cross(to_source, along) / turn;
      if (sign(on_segment) >= 0 && on_segment <= 1) at(cross(to_source, v) / turn);
    } else if (sign(cross(along, to_source)) == 0) {
      at(dot(along, to_source) / length);
      at(dot(along, s.target - start) / length);
    }
  }
  return first;
}

Point point_beside(const Point& start, const Vector& along, const std::vector<Segment>& segments) {
  const Rational first = first_met(start, along, segments).value_or(2);
  return start + Rational(std::min(first, Rational(2)) / 2) * along;
}

}  // namespace oplus
