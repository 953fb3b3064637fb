// SPDX-License-Identifier: MIT
#include "checked/operations/disc.hpp"
#include "checked/operations/image.hpp"
#include "checked/oplus/internal/sum_options.hpp"
#include "checked/oplus/oplus.hpp"

namespace oplus {

namespace {

void require_invertible(const AffineMap& map) {
  if (map.determinant() == 0)
    throw InvalidInput({"transformation", 0, 0}, "the determinant is zero",
                       "a map that has an inverse");
}

}  // namespace

ValidRegion transformed(const ValidRegion& region, const AffineMap& map) {
  require_invertible(map);
  return ValidRegion::found_valid(image(map, region.region()));
}

ValidSet transformed(const ValidSet& set, const AffineMap& map) {
  require_invertible(map);
  return set_of(image(map, set.value()), set.boundary());
}

ValidRegion disc(const Number& radius, DiscSide side, const Number& error) {
  return ValidRegion::found_valid(disc_polygon(radius.value(), side, error.value()));
}

}  // namespace oplus
