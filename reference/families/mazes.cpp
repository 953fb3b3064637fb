// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <utility>
#include <vector>

#include "reference/families/pairs.hpp"
#include "reference/families/polygons.hpp"

// Long corridors, whose walls are near each other and far apart along the boundary.

namespace oplus {

namespace {

struct Place {
  int x;
  int y;
};

constexpr std::array<Place, 4> steps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// Rooms on a square grid, connected as a tree by a random walk that goes back where it is stuck.
class Maze {
 public:
  Maze(Random& random, std::size_t rooms)
      : side_(static_cast<int>(std::ceil(std::sqrt(static_cast<double>(rooms))))),
        doors_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_)),
        entered_(doors_.size(), false) {
    std::vector<Place> path{{0, 0}};
    entered_[0] = true;
    for (std::size_t entered = 1; entered < rooms;) {
      const Place here = path.back();
      std::vector<int> ways;
      for (int way = 0; way < 4; ++way)
        if (is_new(after(here, way))) ways.push_back(way);
      if (ways.empty()) {
        path.pop_back();
        continue;
      }
      const int way = ways[uniform_index(random, ways.size())];
      const Place there = after(here, way);
      doors_[number(here)].set(static_cast<std::size_t>(way));
      doors_[number(there)].set(static_cast<std::size_t>((way + 2) % 4));
      entered_[number(there)] = true;
      path.push_back(there);
      ++entered;
    }
  }

  /// Once around all rooms, the walls to the right: visit(room, corner) for each corner of each room,
  /// 0 the upper right one, then counterclockwise.
  template <typename Visit>
  void walk_around(const Visit& visit) const {
    Place room{0, 0};
    int from = 3;  // there is no room below
    std::size_t corners =
        4 * static_cast<std::size_t>(std::count(entered_.begin(), entered_.end(), true));
    while (corners > 0) {
      int way = from;
      do {
        visit(room, way % 4);
        if (--corners == 0) return;
        way = (way + 1) % 4;
      } while (!doors_[number(room)][static_cast<std::size_t>(way)]);
      room = after(room, way);
      from = (way + 2) % 4;
    }
  }

 private:
  static Place after(const Place& p, int way) {
    const Place& step = steps.at(static_cast<std::size_t>(way));
    return {p.x + step.x, p.y + step.y};
  }
  std::size_t number(const Place& p) const {
    return static_cast<std::size_t>(p.x) * static_cast<std::size_t>(side_) +
           static_cast<std::size_t>(p.y);
  }
  bool is_new(const Place& p) const {
    return p.x >= 0 && p.y >= 0 && p.x < side_ && p.y < side_ && !entered_[number(p)];
  }

  int side_;
  std::vector<std::bitset<4>> doors_;  ///< of each room, by the way
  std::vector<bool> entered_;
};

}  // namespace

Summands maze_pair(Random& random, std::size_t n) {
  const Maze maze(random, n);
  Chain chain;
  chain.reserve(4 * n);
  maze.walk_around([&](const Place& room, int corner) {
    const bool right = corner == 0 || corner == 3, upper = corner < 2;
    const int x = uniform(random, 3, 6), y = uniform(random, 3, 6);
    chain.push_back({16 * room.x + (right ? x : -x), 16 * room.y + (upper ? y : -y)});
  });
  return {polygon(std::move(chain)), convex_grid_polygon(random, 6, 6)};
}

Summands spiral_pair(Random& random, std::size_t n) {
  const int pitch = uniform(random, 3, 6);
  // Out along one wall, back along the other, which is up to pitch - 1 further inwards.
  const int width = uniform(random, 1, pitch - 1);
  Chain out{{0, 0}}, back{{0, width}};
  int x = 0, y = 0;
  for (std::size_t corner = 0; corner <= n; ++corner) {
    const Place& step = steps.at(corner % 4);
    const Place& next = steps.at((corner + 1) % 4);
    const int length = pitch * (static_cast<int>(corner) / 2 + 2);
    x += length * step.x;
    y += length * step.y;
    out.push_back({x, y});
    const int back_along = corner < n ? width : 0;  // both walls end beside each other
    back.push_back(
        {x + width * next.x - back_along * step.x, y + width * next.y - back_along * step.y});
  }
  out.insert(out.end(), back.rbegin(), back.rend());
  return {polygon(std::move(out)), convex_grid_polygon(random, 6, pitch)};
}

Summands thin_pair(Random& random, std::size_t n) {
  const auto length = static_cast<int>(8 * n);
  const auto slanted = [](const Region& region, const Vector& along, const Vector& across) {
    return mapped(region, [&](const Point& p) { return p.x * along + p.y * across; });
  };
  Region saw = comb_polygon(random, n);
  Region bar =
      polygon({{0, 0}, {length, uniform(random, 0, 1)}, {length, uniform(random, 2, 3)}, {0, 1}});
  return {slanted(saw, {7, 4}, {-1, 1}), slanted(bar, {-5, 6}, {-1, -1})};
}

}  // namespace oplus
