// SPDX-License-Identifier: MIT
#include "checked/certificates/cell.hpp"

#include <algorithm>

#include "reference/definitions/region.hpp"

namespace oplus::certificates {

HalvedCell halved(const Cell& cell, const Sides& sides, const IntegerLine& line,
                  const ShiftedDoubles& doubles) {
  HalvedCell result;
  const auto cut = std::make_shared<const IntegerLine>(line);
  const std::size_t size = cell.corners.size();
  for (std::size_t k = 0; k < size; ++k) {
    const std::size_t after = next(k, size);
    const auto& corner = cell.corners[k];
    auto side = cell.lines[k];
    const bool crosses = sides[k] * sides[after] < 0;
    if (crosses && side == nullptr)
      side = std::make_shared<const IntegerLine>(
          line_through(corner->exact, cell.corners[after]->exact));
    const auto crossing =
        crosses ? std::make_shared<const CellCorner>(meet(line, *side), doubles) : nullptr;
    for (const auto& [part, sign] :
         {std::pair(&result.positive, 1), std::pair(&result.negative, -1)}) {
      if (sides[k] * sign >= 0) {
        // From a corner on the line, the part goes on along the side only where that is within it.
        part->corners.push_back(corner);
        part->lines.push_back(sides[k] != 0 || sides[after] * sign > 0 ? side : cut);
      }
      if (crossing) {
        part->corners.push_back(crossing);
        part->lines.push_back(sides[after] * sign > 0 ? side : cut);
      }
    }
  }
  const auto& lines = result.positive.lines;
  const auto start = static_cast<std::size_t>(std::ranges::find(lines, cut) - lines.begin());
  result.from = result.positive.corners[start];
  result.to = result.positive.corners[next(start, lines.size())];
  return result;
}

Place centre(const Cell& cell) {
  Place sum;
  for (const auto& corner : cell.corners) {
    sum.x += corner->near.x;
    sum.y += corner->near.y;
  }
  const auto size = static_cast<double>(cell.corners.size());
  return {sum.x / size, sum.y / size};
}

}  // namespace oplus::certificates
