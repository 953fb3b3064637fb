// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/nesting.hpp"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <queue>
#include <set>

#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

using Face = ConvolutionArrangement::Face;
using Halfedge = ConvolutionArrangement::Halfedge;

/// The regions into which the loops cut the plane, each named by one of its faces. Two faces are in
/// one region if an edge between them is on no loop.
std::vector<Face> regions_between(const ConvolutionArrangement& arrangement,
                                  const std::vector<OrientableLoop>& loops) {
  std::vector<bool> is_on_loop(arrangement.edge_count(), false);
  for (const OrientableLoop& loop : loops)
    for (const Halfedge h : loop) is_on_loop[h / 2] = true;
  boost::disjoint_sets_with_storage<> faces(arrangement.face_count());
  for (Halfedge h = 0; h < 2 * arrangement.edge_count(); h += 2) {
    if (!is_on_loop[h / 2])
      faces.union_set(arrangement.face(h), arrangement.face(ConvolutionArrangement::twin(h)));
  }
  std::vector<Face> regions(arrangement.face_count());
  for (Face f = 0; f < regions.size(); ++f) regions[f] = static_cast<Face>(faces.find_set(f));
  return regions;
}

/// What a loop separates. Turning clockwise most, it has one region to its right; where it touches
/// itself, several to its left.
struct Sides {
  Face right;
  std::set<Face> left;
};

}  // namespace

std::vector<LoopVerdict> judge(const ConvolutionArrangement& arrangement,
                               const std::vector<OrientableLoop>& loops,
                               const std::function<bool(Halfedge)>& is_hole_right_of) {
  const std::vector<Face> regions = regions_between(arrangement, loops);
  std::vector<Sides> sides;
  std::vector<std::vector<std::size_t>> loops_around(arrangement.face_count());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    Sides of_loop{regions[arrangement.face(ConvolutionArrangement::twin(loops[i][0]))], {}};
    for (const Halfedge h : loops[i]) {
      of_loop.left.insert(regions[arrangement.face(h)]);
      OPLUS_ENSURES(regions[arrangement.face(ConvolutionArrangement::twin(h))] == of_loop.right,
                    "Observation 3.2.5");
    }
    loops_around[of_loop.right].push_back(i);
    for (const Face region : of_loop.left) loops_around[region].push_back(i);
    sides.push_back(std::move(of_loop));
  }

  std::vector<LoopVerdict> verdicts(loops.size(), LoopVerdict::not_nested);
  std::vector<bool> is_judged(loops.size(), false);
  struct Visit {
    Face region;
    bool is_in_sum;
  };
  const Face outside = regions[ConvolutionArrangement::unbounded];
  std::queue<Visit> to_visit({Visit{outside, false}});
  while (!to_visit.empty()) {
    const auto [region, is_in_sum] = to_visit.front();
    to_visit.pop();
    for (const std::size_t i : loops_around[region]) {
      if (is_judged[i]) continue;
      is_judged[i] = true;
      const bool seen_from_the_right = sides[i].right == region;
      // The sum is to the left of its boundary.
      const bool is_nested = seen_from_the_right != is_in_sum &&
                             !(OPLUS_MUTANT("islands-are-not-nested",
                                            "external loops are looked for on the outside only") &&
                               seen_from_the_right && region != outside);
      const bool is_boundary =
          is_nested && (region == outside ||
                        OPLUS_MUTANT("nested-loops-need-no-hole-test",
                                     "every loop that is nested is taken for boundary") ||
                        is_hole_right_of(loops[i][0]));
      if (is_nested) verdicts[i] = is_boundary ? LoopVerdict::boundary : LoopVerdict::not_boundary;
      if (!seen_from_the_right) to_visit.push({sides[i].right, is_in_sum && !is_boundary});
      for (const Face left : sides[i].left) {
        if (left != region) to_visit.push({left, is_in_sum || is_boundary});
      }
    }
  }
  OPLUS_ENSURES(std::find(is_judged.begin(), is_judged.end(), false) == is_judged.end(),
                "Observation 3.1.4");
  return verdicts;
}

}  // namespace oplus
