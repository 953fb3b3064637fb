// SPDX-License-Identifier: MIT
// How far parts are from each other, how deep they overlap, and many places of one pair.
#include <iostream>
#include <oplus/oplus.hpp>

int main() {
  auto plate = oplus::polygon({{0, 0}, {8, 0}, {8, 6}, {0, 6}}, {{{2, 2}, {2, 4}, {4, 4}, {4, 2}}});
  auto key = oplus::polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}});

  oplus::NearestPoints nearest = distance(plate, transformed(key, oplus::translation({11, 10})));
  std::cout << nearest.squared_distance << ": from " << nearest.on_p.x << ' ' << nearest.on_p.y
            << " to " << nearest.on_q.x << ' ' << nearest.on_q.y << '\n';

  // Where it overlaps the plate, it is moved into the hole, which it fills.
  std::optional<oplus::Overlap> overlap =
      depth(plate, transformed(key, oplus::translation({"2.5", "1.75"})));
  if (overlap)
    std::cout << "move by " << overlap->move.x << ' ' << overlap->move.y << ", whose square is "
              << overlap->squared_depth << '\n';

  // The no-fit polygon is computed once, then each place takes a fraction of a microsecond.
  oplus::Placements places(plate, key);
  int apart = 0, touching = 0;
  for (int x = -4; x <= 12; ++x)
    for (int y = -4; y <= 12; ++y) {
      apart += places.locate({x, y}) == oplus::Location::outside;
      touching += places.locate({x, y}) == oplus::Location::boundary;
    }
  std::cout << apart << " apart, " << touching << " touching\n";
  std::cout << places.depth({0, 5})->move.y << ' ' << places.distance({9, 0}).squared_distance
            << ' ' << places.no_fit().isolated_vertices().size() << '\n';
}
