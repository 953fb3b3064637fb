// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/winding_numbers.hpp"

#include <queue>

#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

using Halfedge = ConvolutionArrangement::Halfedge;
using Face = ConvolutionArrangement::Face;

/// Left of a segment the winding number is one more than right of it.
int left_minus_right(const ConvolutionArrangement& arrangement, Halfedge h) {
  if (OPLUS_MUTANT("overlapping-segments-count-once",
                   "crossing an edge of several segments changes the winding number by one"))
    return arrangement.along(h).empty() ? -1 : 1;
  return static_cast<int>(arrangement.along(h).size()) -
         static_cast<int>(arrangement.along(ConvolutionArrangement::twin(h)).size());
}

}  // namespace

std::vector<int> winding_numbers(const ConvolutionArrangement& arrangement) {
  std::vector<int> numbers(arrangement.face_count(), 0);
  std::vector<bool> is_known(arrangement.face_count(), false);
  std::queue<Face> to_visit({ConvolutionArrangement::unbounded});
  is_known[ConvolutionArrangement::unbounded] = true;
  while (!to_visit.empty()) {
    const Face face = to_visit.front();
    to_visit.pop();
    arrangement.all_around(face, [&](Halfedge h) {
      const Face neighbour = arrangement.face(ConvolutionArrangement::twin(h));
      const int number = numbers[face] - left_minus_right(arrangement, h);
      if (!is_known[neighbour]) {
        is_known[neighbour] = true;
        numbers[neighbour] = number;
        to_visit.push(neighbour);
      }
      OPLUS_ENSURES(numbers[neighbour] == number, "Definition 4.2.4");
      return true;
    });
  }
  return numbers;
}

}  // namespace oplus
