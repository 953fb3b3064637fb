// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "properties/runner/registry.hpp"
#include "properties/statements/directions_around.hpp"
#include "reference/definitions/tangent_set.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// A row of the fiber grid: a chain of P at a vertex of Q; then `of` is Q. Or a column; then `of`
/// is P.
struct Line {
  Summand of;
  VertexIndex at;
  std::size_t along;  ///< a chain of the other summand

  friend auto operator<=>(const Line&, const Line&) = default;
};

/// How often a vertex that turns by less than π, left or right, passes d: 1, 0 or -1.
int passed(std::size_t d, std::size_t in, std::size_t out, const DirectionsAround& around) {
  const std::size_t half = around.places() / 2, turn = around.turn(in, out);
  if (turn < half) return around.turn(in, d) < turn ? 1 : 0;
  return around.turn(out, d) < around.places() - turn ? -1 : 0;
}

Enumeration enumerate() {
  const DirectionsAround directions(4);
  Enumeration result;
  for (const Summand edge_of : {Summand::P, Summand::Q}) {
    const Summand of = other(edge_of);
    for_each_choice<3>(directions.size(), [&](const std::array<std::size_t, 3>& choice) {
      const auto [in, out, d] = choice;
      if (out == directions.opposite(in)) return;  // it turns back, as no vertex of a region does
      const Corner corner{directions[in], directions[out]};
      const int times = in_tangent_set({directions[d], edge_of}, corner) ? 1 : 0;
      const int reflex = is_reflex(corner) ? 1 : 0;
      const int expected = passed(directions.place(d, edge_of), directions.place(in, of),
                                  directions.place(out, of), directions) +
                           reflex;
      ++result.cases;
      if (!result.failure.empty() || times == expected) return;
      result.failure = "at a vertex with edges " + to_string(corner.in) + " and " +
                       to_string(corner.out) + " the other summand's direction " +
                       to_string(directions[d]) + " is in the tangent set " +
                       std::to_string(times) + " times, and should be " + std::to_string(expected);
    });
  }
  return result;
}

/// All rows, or all columns.
void add_lines(Summand of, const Region& region, const Region& across,
               std::map<Line, std::size_t>& lines) {
  const std::vector<Chain> own = chains(region), others = chains(across);
  for (std::size_t chain = 0; chain < own.size(); ++chain)
    for (std::size_t vertex = 0; vertex < own[chain].size(); ++vertex)
      for (std::size_t along = 0; along < others.size(); ++along)
        lines[{of, {chain, vertex}, along}] = 0;
}

Outcome check(const Summands& summands) {
  std::map<Line, std::size_t> leaving;
  add_lines(Summand::P, summands.p, summands.q, leaving);
  add_lines(Summand::Q, summands.q, summands.p, leaving);
  for (const ConvolutionSegment& s : convolution(summands.p, summands.q))
    ++leaving[{s.origin.edge_of, s.origin.edge, s.origin.vertex.chain}];
  const std::vector<Chain> of_p = chains(summands.p), of_q = chains(summands.q);
  Outcome outcome;
  for (const auto& [line, edges] : leaving) {
    const Chain& along = (line.of == Summand::P ? of_q : of_p)[line.along];
    const bool is_hole = sign(twice_area(along)) < 0;
    ++outcome.counts[is_hole ? "rows and columns along holes" : "along outer chains"];
    if (edges >= (is_hole ? 2U : 1U)) continue;
    outcome.fail("too few edges, " + std::to_string(edges) + ", leave the line of vertex " +
                 std::to_string(line.at.vertex) + " of chain " + std::to_string(line.at.chain) +
                 " of " + (line.of == Summand::P ? "P" : "Q") + " along chain " +
                 std::to_string(line.along) + " of the other summand");
    break;
  }
  return outcome;
}

const Registered registered(larger_mixture(),
                            {.id = "lemma-4.1.8",
                             .kills = {"acute-vertex-is-reflex", "angles-grow-clockwise",
                                       "between-is-on-the-other-arc", "reflex-turns-clockwise",
                                       "tangent-set-without-ties", "ties-go-the-other-way"},
                             .cases = 1000,
                             .check = check,
                             .enumerate = enumerate});

}  // namespace

}  // namespace oplus
