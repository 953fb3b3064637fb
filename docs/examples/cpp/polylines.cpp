// SPDX-License-Identifier: MIT
// A tool on a path, and a robot between walls that are lines.
#include <iostream>
#include <oplus/oplus.hpp>

int main(int argc, char** argv) {
  auto tool = oplus::polygon({{0, 0}, {2, 0}, {2, 1}, {0, 1}});
  oplus::ValidSet path({}, {{{0, 0}, {5, 0}, {5, 3}}});
  oplus::ValidSet covered = minkowski_sum(path, tool);
  std::cout << "covered: " << to_wkt(covered) << '\n';

  // A room with a wall; a door in it is as wide as the robot.
  auto walls = oplus::read_set("MULTILINESTRING((0 0,8 0,8 6,0 6,0 0),(4 0,4 2),(4 4,4 6))");
  oplus::ValidSet robot = oplus::polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  oplus::ValidSet blocked = minkowski_sum(walls, -robot, {.boundary = oplus::Boundary::open});
  for (const oplus::Segment& door : blocked.dangling_edges())
    std::cout << "the robot passes a door from " << door.source.x << ' ' << door.source.y << " to "
              << door.target.x << ' ' << door.target.y << '\n';

  // A region, a point that is in it, and one that is not.
  oplus::ValidSet mixed(tool, {}, {{1, 1}, {3, 3}});
  std::cout << "points left: " << mixed.value().isolated_vertices.size()
            << ", the same again: " << (mixed == oplus::ValidSet(tool, {{{3, 3}}})) << '\n';

  if (argc == 2) std::cout << to_wkt(minkowski_sum(oplus::read_set_file(argv[1]), tool)) << '\n';
}
