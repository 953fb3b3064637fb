// SPDX-License-Identifier: GPL-3.0-or-later
// The sum of two triangles is convex. Clipper2's, filled as its users fill it, has a hole.
// Expected: 674 -16.5: (67, 0) (36, 3) (78, 0)
#include <clipper2/clipper.h>

#include <iostream>
int main() {
  using namespace Clipper2Lib;
  const Path64 p = MakePath({-2, 0, 0, 0, 0, 2});
  const Path64 q = MakePath({0, 8, 0, 0, 108, -4});
  const Paths64 sum =
      Union(MinkowskiSum(p, q, true), {TranslatePath(q, p[0].x, p[0].y)}, FillRule::NonZero);
  std::cout << Area(sum.at(0)) << ' ' << Area(sum.at(1)) << ':';
  for (const Point64& v : sum.at(1)) std::cout << " (" << v.x << ", " << v.y << ')';
  std::cout << '\n';
}
