// SPDX-License-Identifier: MIT
#include <iostream>
#include <oplus/engines.hpp>

/// A unit square and a triangle: the sum's area is 1 + 1/2 + 2, the last one the mixed term.
int main() {
  const oplus::ValidRegion square = oplus::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const oplus::ValidRegion triangle = oplus::polygon({{0, 0}, {1, 0}, {0, 1}});
  const std::vector<oplus::Chain> expected = {{{0, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 2}}};
  bool right = oplus::engine_names().size() == 4;
  for (const std::string& name : oplus::engine_names()) {
    const oplus::ValidSet sum = minkowski_sum(square, triangle, {.engine = oplus::engine(name)});
    right = right && sum.value().outer == expected && sum.value().holes.empty() &&
            area(sum) == oplus::Rational(7, 2);
    std::cout << name << ": area " << area(sum) << '\n';
  }
  std::cout << (right ? "" : "which is wrong\n");
  return right ? 0 : 1;
}
