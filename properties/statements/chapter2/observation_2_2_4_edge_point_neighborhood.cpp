// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "properties/runner/registry.hpp"
#include "properties/statements/chapter2/points_around.hpp"
#include "properties/statements/places/open_sum.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// Looks at half disks, as far as it is constant in the cells of the vertex-edge sum's arrangement
/// whether a point is in the open sum. It is: only there a vertex of P meets an edge of -Q+x.
class HalfDisks {
 public:
  explicit HalfDisks(const Summands& summands)
      : sum_(segments(vertex_edge_sum(summands.p, summands.q))), open_sum_(summands) {}

  void look_at(const Point& x, const Vector& along) {
    ++outcome.counts["half disks"];
    for (const Point& y : points_to_the_left(x, along, sum_)) {
      if (outcome.kind == Outcome::Kind::fails || open_sum_.contains(y)) continue;
      outcome.fail("the half disk around " + to_string(x) + " contains " + to_string(y) +
                   ", which is not in the open sum");
    }
  }

  Outcome outcome;

 private:
  std::vector<Segment> sum_;
  OpenSum open_sum_;
};

constexpr std::size_t most_half_disks = 60;  // a pair

struct HalfDisk {
  Point centre;
  Vector along;
};

/// The middle of an edge, at a vertex and at the middle of an edge of the other summand.
void add_half_disks(const Region& with_edges, const Region& other_region,
                    std::vector<HalfDisk>& all) {
  for (const Segment& piece : boundary_pieces(with_edges)) {
    const Vector along = direction_of(piece);
    const Point middle = midpoint(piece.source, piece.target);
    for (const Segment& of_other : boundary_pieces(other_region)) {
      all.push_back({middle + of_other.source, along});
      all.push_back({middle + midpoint(of_other.source, of_other.target), along});
    }
  }
}

Outcome check(const Summands& summands) {
  std::vector<HalfDisk> all;
  add_half_disks(summands.p, summands.q, all);
  add_half_disks(summands.q, summands.p, all);
  HalfDisks half_disks(summands);
  const std::size_t looked_at = std::min(all.size(), most_half_disks);
  for (std::size_t k = 0; k < looked_at; ++k) {
    const auto& [centre, along] = all[k * all.size() / looked_at];
    half_disks.look_at(centre, along);
  }
  return half_disks.outcome;
}

const Registered registered({
    .id = "observation-2.2.4",
    .kind = "observation",
    .title = "Around a point of an edge the sum fills a half disk",
    .statement =
        "Let p be inside an edge of one summand, in no point where another chain touches that edge, "
        "and q in the other summand, which is closed. Then a small half disk around p + q, to the "
        "left of a line along the edge, is in the sum of the open regions.",
    .why =
        "The region of p fills such a half disk around p, whose points are interior. The sum of an "
        "interior point and any point of a closed region is in the sum of the open regions. Where "
        "another chain touches the edge in p, the half disk is not there: the observation as "
        "printed is false, and so for the sum of closed regions (docs/findings.md).",
    .hypotheses = {"P and Q are valid regions, holes, components and collinear vertices allowed",
                   "no other chain touches the edge in p"},
    .rests_on = {"lemma-2.2.2"},
    .sources = {{"grid", 5, 6}, {"tight", 1, 1}, {"holes", 4, 3}, {"components", 4, 2}},
    .promises =
        {{"holes", 15}, {"several components", 5}, {"reflex vertices", 10}, {"parallel edges", 40}},
    .kills = {"containment-is-no-collision"},
    .cases = 60,
    .check = check,
});

}  // namespace

}  // namespace oplus
