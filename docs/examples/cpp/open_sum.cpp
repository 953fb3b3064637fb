// SPDX-License-Identifier: MIT
// Open sums: a part that just fits, and a door as wide as the robot.
#include <iostream>
#include <oplus/oplus.hpp>

int main() {
  auto frame = oplus::polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {3, 1}, {3, 3}, {1, 3}}});
  auto slider = oplus::polygon({{0, 0}, {2, 0}, {2, 1}, {0, 1}});  // as wide as the hole
  auto plug = oplus::polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}});    // as large as the hole

  const oplus::SumOptions open = {.boundary = oplus::Boundary::open};
  oplus::ValidSet where_slider_meets = minkowski_sum(frame, -slider, open);
  oplus::ValidSet where_plug_meets = minkowski_sum(frame, -plug, open);

  for (const oplus::Segment& edge : where_slider_meets.dangling_edges())
    std::cout << "the slider fits from " << edge.source.x << ' ' << edge.source.y << " to "
              << edge.target.x << ' ' << edge.target.y << '\n';
  for (const oplus::Point& vertex : where_plug_meets.isolated_vertices())
    std::cout << "the plug fits at " << vertex.x << ' ' << vertex.y << '\n';

  // The closed sum has lost it: touching counts as meeting.
  oplus::ValidSet closed = minkowski_sum(frame, -plug);
  std::cout << "at 1 1: open " << contains(where_plug_meets, {1, 1}) << ", closed "
            << contains(closed, {1, 1}) << '\n';
  std::cout << (closed.boundary() == oplus::Boundary::closed) << (closed == where_plug_meets)
            << (closed.region() == where_plug_meets.region()) << '\n';
  std::cout << to_wkt(where_plug_meets) << '\n';
}
