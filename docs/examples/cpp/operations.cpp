// SPDX-License-Identifier: MIT
// Where parts overlap, where they fit inside, and unbounded regions.
#include <iostream>
#include <oplus/oplus.hpp>

int main() {
  auto bin = oplus::polygon({{0, 0}, {100, 0}, {100, 100}, {0, 100}});
  auto part = oplus::polygon({{0, 0}, {100, 0}, {100, 30}, {0, 30}});  // as wide as the bin

  // All x where the part, moved by x, is inside the bin: exact fits are edges and points.
  oplus::ValidSet places = ifp(bin, part);
  for (const oplus::Segment& edge : places.dangling_edges())
    std::cout << "it fits from " << edge.source.x << ' ' << edge.source.y << " to " << edge.target.x
              << ' ' << edge.target.y << '\n';
  std::cout << "at 0 50: " << contains(places, {0, 50})
            << ", at 1 50: " << contains(places, {1, 50}) << '\n';
  std::cout << to_wkt(ifp(bin, bin)) << '\n';

  // Where a second part overlaps the first, an open set.
  std::cout << to_wkt(nfp(part, part)) << '\n';

  // What is left of the bin when copies of the part have swept all they can.
  std::cout << area(erosion(bin, part)) << ' ' << area(opening(bin, part)) << ' '
            << area(closing(bin, part)) << '\n';

  // The outside of the part is a region too, an unbounded one.
  oplus::ValidRegion outside = complement(part);
  std::cout << is_unbounded(outside) << contains(outside, {-1, 1000}) << contains(outside, {50, 20})
            << ' ' << outside.components()[0].holes.size() << " hole\n";
  std::cout << to_wkt(complement(
                   minkowski_sum(outside, oplus::polygon({{0, 0}, {9, 0}, {0, 9}})).region()))
            << '\n';
}
