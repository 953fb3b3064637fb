// SPDX-License-Identifier: GPL-3.0-or-later
// The sum of two triangles is convex. Clipper2's union is two polygons, of which one is inside the other; neither is a
// hole.
// Expected: 381.5 10.5: (48, -7) (-1, 0) (52, -8)
#include <clipper2/clipper.h>

#include <iostream>
int main() {
  using namespace Clipper2Lib;
  const Path64 p = MakePath({-1, 0, 0, 0, 0, 1});
  const Path64 q = MakePath({71, -11, 0, 0, -46, 0});
  const Paths64 sum =
      Union(MinkowskiSum(p, q, true), {TranslatePath(q, p[0].x, p[0].y)}, FillRule::NonZero);
  std::cout << Area(sum.at(0)) << ' ' << Area(sum.at(1)) << ':';
  for (const Point64& v : sum.at(1)) std::cout << " (" << v.x << ", " << v.y << ')';
  std::cout << '\n';
}
