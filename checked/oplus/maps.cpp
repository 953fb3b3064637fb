// SPDX-License-Identifier: MIT
#include "checked/oplus/oplus.hpp"
#include "reference/arithmetic/rational_rotation.hpp"
#include "reference/definitions/squared_distance.hpp"

namespace oplus {

namespace {

AffineMap by(const RationalRotation& rotation) {
  return {rotation.cos, -rotation.sin, rotation.sin, rotation.cos};
}

}  // namespace

AffineMap translation(const Coordinates& by) { return {.by = by.point()}; }

AffineMap scaling(const Number& of_x, const Number& of_y) {
  if (of_x.value() == 0 || of_y.value() == 0)
    throw InvalidInput({"scaling", 0, 0}, "a factor is zero", "two that are not");
  return {of_x.value(), 0, 0, of_y.value()};
}

AffineMap scaling(const Number& of_both) { return scaling(of_both, of_both); }

AffineMap rotation(const Number& degrees, const Number& error) {
  if (error.value() <= 0)
    throw InvalidInput({"rotation", 0, 0},
                       error.value() == 0 ? "the error is zero" : "the error is negative",
                       "a positive one");
  return by(rational_rotation(degrees.value(), error.value()));
}

AffineMap rotation_to(const Coordinates& cosine_and_sine) {
  const Point& p = cosine_and_sine.point();
  if (squared_length(p) != 1)
    throw InvalidInput({"rotation", 0, 0}, "the squares of cosine and sine don't add up to 1",
                       "a point of the unit circle, such as 3/5,4/5");
  return by(RationalRotation{p.x, p.y});
}

}  // namespace oplus
