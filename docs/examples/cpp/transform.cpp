// SPDX-License-Identifier: MIT
// Maps, exact, and discs: a part is rotated, moved and offset.
#include <iostream>
#include <oplus/oplus.hpp>

int main() {
  auto part = oplus::polygon({{0, 0}, {3, 0}, {3, 1}, {0, 1}});

  // The map on the right is done first.
  oplus::AffineMap place = oplus::translation({10, 0}) * oplus::rotation_to({"4/5", "3/5"});
  std::cout << to_wkt(transformed(part, place)) << '\n';
  std::cout << to_wkt(transformed(part, oplus::scaling(-1, 2) * oplus::rotation(90))) << '\n';

  // No rational rotation is by 30 degrees; this one is within a hundredth of a degree.
  oplus::AffineMap turn = oplus::rotation(30, 0.01);
  std::cout << "cosine " << turn.a << ", sine " << turn.c << ", determinant " << turn.determinant()
            << ", (2, 1) goes to " << turn({2, 1}).x << ", " << turn({2, 1}).y << '\n';

  // All points at most 1 away from the part, and some at most 1.1.
  auto around = oplus::disc(1, oplus::DiscSide::outside, "0.1");
  oplus::ValidSet offset = minkowski_sum(part, around);
  std::cout << offset.components()[0].outer.size() << " vertices, area " << area(offset) << '\n';
  std::cout << (transformed(offset, turn) ==
                minkowski_sum(transformed(part, turn), transformed(around, turn)))
            << (turn == oplus::AffineMap()) << '\n';

  try {
    oplus::disc(1, oplus::DiscSide::inside, 0);
  } catch (const oplus::InvalidInput& error) {
    std::cout << error.what() << '\n';
  }
}
