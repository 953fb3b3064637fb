// SPDX-License-Identifier: MIT
#include "checked/layouts/builder.hpp"

#include "checked/operations/image.hpp"
#include "reference/arithmetic/rational_rotation.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/quoting.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/unchecked_input.hpp"
#include "reference/io/writing.hpp"

namespace oplus::layouts {

Region Builder::region(PlacedGeometry geometry) {
  beyond_the_plane_ += geometry.beyond_the_plane;
  geometry.beyond_the_plane = 0;
  ReadRegion read = checked_region({input.name, std::move(geometry), {}});
  turned_chains_ += read.notes.size();
  return std::move(read.region);
}

AffineMap Builder::rotation(const Rational& degrees) {
  const auto [known, is_new] = rotations_.try_emplace(degrees);
  if (is_new) {
    const RationalRotation r = rational_rotation(degrees, angle_error_);
    known->second = {r.cos, -r.sin, r.sin, r.cos};
  }
  if (Rational(degrees / 90).get_den() != 1) ++near_rotations_;
  return known->second;
}

void Builder::place(std::string name, std::size_t line, const void* original, Region shape,
                    const AffineMap& map, std::optional<int> least_quality) {
  AffineMap turn = map;
  turn.by = {};
  std::shared_ptr<const Region> single;
  std::shared_ptr<const Region>& turned =
      original ? shapes_[{original, Turn{turn.a, turn.b, turn.c, turn.d}}] : single;
  if (!turned)
    turned = std::make_shared<const Region>(turn == AffineMap{} ? std::move(shape)
                                                                : image(turn, std::move(shape)));
  layout.sheets.back().parts.push_back({std::move(name), line, turned, map.by, least_quality});
}

Layout Builder::finish() {
  const std::string start = one_line(input.name) + ": ";
  if (turned_chains_ > 0)
    layout.notes.push_back(start + counted(turned_chains_, "chain was", "chains were") +
                           " turned the other way round");
  if (beyond_the_plane_ > 0)
    layout.notes.push_back(start + "of " + vertices(beyond_the_plane_) +
                           " with more than two coordinates, only x and y were read");
  if (near_rotations_ > 0)
    layout.notes.push_back(start + counted(near_rotations_, "rotation is", "rotations are") +
                           " not by a multiple of 90 degrees, and taken for one by at most " +
                           to_string(angle_error_) + " degrees more or less (docs/layouts.md)");
  return std::move(layout);
}

}  // namespace oplus::layouts
