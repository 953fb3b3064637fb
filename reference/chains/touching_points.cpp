// SPDX-License-Identifier: MIT
#include "reference/chains/touching_points.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "reference/chains/nesting.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

void sweep_touching_points(const SweptChains& chains,
                           const std::function<void(const SweptPlace&)>& visit) {
  if (chains.first_of_chain.size() < 2) return;
  sweep(chains.edges, [&](const SweptPlace& place) {
    if (chains.is_touched(place)) visit(place);
    return true;
  });
}

}  // namespace

std::vector<Point> touching_points(const Region& region) {
  std::vector<Point> result;
  sweep_touching_points(SweptChains(chains_in(region)),
                        [&](const SweptPlace& place) { result.push_back(place.point); });
  return result;
}

std::vector<std::vector<Segment>> pieces_by_chain(const Region& region) {
  const std::vector<const Chain*> all = chains_in(region);
  const SweptChains chains(all);
  std::vector<std::pair<std::uint32_t, Point>> cuts;  // of edges, from their smaller ends
  if (!OPLUS_MUTANT("edges-are-not-cut-where-chains-touch",
                    "an edge that another chain touches from within counts as one piece"))
    sweep_touching_points(chains, [&](const SweptPlace& place) {
      for (const std::uint32_t e : place.left)
        if (passes(chains.edges, e, place)) cuts.emplace_back(e, place.point);
    });
  std::stable_sort(cuts.begin(), cuts.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::vector<Segment>> pieces(all.size());
  auto cut = cuts.begin();
  for (std::uint32_t e = 0; e < chains.edges.edges.size(); ++e) {
    std::vector<Segment>& of_chain = pieces[chains.chain_of[e]];
    if (of_chain.empty()) of_chain.reserve(all[chains.chain_of[e]]->size());
    const auto first = cut;
    while (cut != cuts.end() && cut->first == e) ++cut;
    if (!chains.edges.runs_right(e)) std::reverse(first, cut);
    const Point* source = chains.edges.points[e];
    for (auto i = first; i != cut; ++i) {
      of_chain.push_back({*source, i->second});
      source = &i->second;
    }
    of_chain.push_back({*source, *chains.edges.points[chains.edges.edges[e].target]});
  }
  return pieces;
}

std::vector<Segment> boundary_pieces(const Region& region) {
  std::vector<Segment> all;
  for (std::vector<Segment>& of_chain : pieces_by_chain(region))
    std::move(of_chain.begin(), of_chain.end(), std::back_inserter(all));
  return all;
}

}  // namespace oplus
