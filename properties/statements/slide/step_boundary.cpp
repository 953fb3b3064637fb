// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/registry.hpp"
#include "properties/statements/placements/covered_sum.hpp"
#include "properties/statements/slide/slid_pair.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

Outcome check(const Summands& summands) {
  const SlidPair pair(summands);
  const PlanarSet sum = oracle_sums(summands.p, summands.q).closed;
  const std::vector<Segment> boundary = edges(sum);
  slide::FreePieces<SlidPair::Numbers> search(pair.segments.summands());
  Outcome outcome;
  std::vector<Segment> free;
  for (std::uint32_t i = 0; i < pair.segments.size(); ++i) {
    std::vector<SlidPair::Piece> pieces;
    search.find(pair.segments[i], [&](auto piece) { pieces.push_back(std::move(piece)); });
    std::vector<SlidPair::Place> ends;
    for (const auto& piece : pieces) {
      ends.insert(ends.end(), {piece.from, piece.to});
      free.push_back({pair.point(i, piece.from), pair.point(i, piece.to)});
    }
    for (const SlidPair::Place& t : pair.between(ends)) {
      const bool is_free = std::any_of(pieces.begin(), pieces.end(), [&](const auto& piece) {
        return piece.from < t && t < piece.to;
      });
      const Point x = pair.point(i, t);
      const bool is_boundary =
          std::any_of(boundary.begin(), boundary.end(), [&](const Segment& edge) {
            return lies_on(x, edge) && sign(dot(direction_of(edge), pair.direction(i))) > 0 &&
                   sign(cross(direction_of(edge), pair.direction(i))) == 0;
          });
      ++outcome.counts[is_free ? "places in free pieces" : "places elsewhere"];
      if (is_free == is_boundary) continue;
      return outcome.fail(
          std::string(is_free ? "a free place is not on" : "a blocked place is on") +
              " the boundary, on segment " + std::to_string(i),
          x);
    }
  }
  for (const Segment& edge : boundary) {
    std::vector<Segment> equally_directed;
    for (const Segment& piece : free)
      if (sign(dot(direction_of(piece), direction_of(edge))) > 0) equally_directed.push_back(piece);
    ++outcome.counts["edges of the boundary"];
    if (cover(equally_directed, edge)) continue;
    return outcome.fail("an edge of the boundary is not covered by free pieces",
                        midpoint(edge.source, edge.target));
  }
  return outcome;
}

const Registered registered({
    .id = "step-boundary",
    .sources = {{"grid", 6, 4},
                {"tight", 6, 3},
                {"holes", 4, 2},
                {"components", 4, 2},
                {"islands", 2, 1},
                {"fork", 2, 1}},
    .promises = {{"holes", 10}, {"parallel edges", 40}},
    .kills = {"slide-shifts-to-the-left", "slide-components-never-overlap"},
    .cases = 100,
    .check = check,
});

}  // namespace

}  // namespace oplus
