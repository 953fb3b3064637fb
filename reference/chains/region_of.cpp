// SPDX-License-Identifier: MIT
#include "reference/chains/region_of.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "reference/chains/clearly_simple.hpp"
#include "reference/chains/near_point.hpp"
#include "reference/chains/nesting.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/unbounded.hpp"

namespace oplus {

namespace {

using Index = std::uint32_t;

/// How a chain turns at its vertices.
class Turns {
 public:
  explicit Turns(const Chain& chain) : chain_(chain) {
    points_.reserve(chain.size());
    for (const Point& p : chain) points_.push_back(near_point(p));
    for (std::size_t i = 0; i < chain.size(); ++i)
      turns_.push_back(orientation(points_[previous(i, chain.size())], points_[i],
                                   points_[next(i, chain.size())]));
  }

  Chain without_collinear_vertices() const {
    Chain corners;
    corners.reserve(chain_.size());
    for (std::size_t i = 0; i < chain_.size(); ++i)
      if (turns_[i] != 0 || OPLUS_MUTANT("edges-in-line-stay-apart")) corners.push_back(chain_[i]);
    return corners;
  }

  /// It turns one way, and once around.
  bool is_convex() const {
    std::size_t changes = 0;
    for (std::size_t i = 0; i < turns_.size(); ++i) {
      if (turns_[i] == 0 || turns_[i] != turns_[0]) return false;
      const NearPoint& p = points_[i];
      const int in = compare(points_[previous(i, points_.size())], p);
      const int out = compare(p, points_[next(i, points_.size())]);
      changes += (in < 0) != (out < 0);
    }
    return changes == 2;
  }

  /// Whether it certainly does not touch itself.
  bool is_clearly_simple() const { return is_convex() || oplus::is_clearly_simple(points_); }

  /// Requires: the chain is simple.
  bool is_counterclockwise() const {
    const auto smallest =
        std::min_element(points_.begin(), points_.end(),
                         [](const NearPoint& a, const NearPoint& b) { return compare(a, b) < 0; });
    return smallest != points_.end() &&
           turns_[static_cast<std::size_t>(smallest - points_.begin())] > 0;
  }

 private:
  const Chain& chain_;
  std::vector<NearPoint> points_;
  std::vector<int> turns_;
};

struct SimpleChain {
  Chain chain;
  bool is_counterclockwise;
};

SimpleChain simple_chain(const Chain& chain, const Turns& turns) {
  Chain corners = turns.without_collinear_vertices();
  const bool is_counterclockwise =
      (corners.size() == chain.size() ? turns : Turns(corners)).is_counterclockwise();
  return {std::move(corners), is_counterclockwise};
}

/// The vertices of a chain by their indices, also where it passes through them; and a number for each vertex,
/// equal where they are. Empty where the chain does not touch itself.
struct Passed {
  std::vector<Index> vertices;
  std::vector<std::size_t> number;
};

Passed passed(const Chain& chain) {
  const SweptChains chains({&chain});
  Passed result;
  result.number.resize(chain.size());
  std::vector<std::pair<Index, Index>> through;  // an edge, and a vertex inside it
  std::size_t numbers = 0;
  bool is_touched = false;
  sweep(chains.edges, [&](const SweptPlace& place) {
    if (place.points.empty()) return true;
    for (const Index v : place.points) result.number[v] = numbers;
    ++numbers;
    if (!chains.is_touched(place)) return true;
    is_touched = true;
    for (const Index e : place.left)
      if (passes(chains.edges, e, place)) through.emplace_back(e, place.points.front());
    return true;
  });
  if (!is_touched) return result;
  std::stable_sort(through.begin(), through.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  auto cut = through.begin();
  for (Index v = 0; v < chain.size(); ++v) {
    result.vertices.push_back(v);
    const auto first = cut;
    while (cut != through.end() && cut->first == v) ++cut;
    if (!chains.edges.runs_right(v)) std::reverse(first, cut);
    for (auto i = first; i != cut; ++i) result.vertices.push_back(i->second);
  }
  return result;
}

/// Takes a chain that touches itself apart into chains that do not.
void add_simple_chains(const Chain& chain, std::vector<SimpleChain>& simple) {
  const Turns turns(chain);
  Passed pass;
  if (!turns.is_clearly_simple()) pass = passed(chain);
  if (pass.vertices.empty()) {
    simple.push_back(simple_chain(chain, turns));
    return;
  }
  constexpr auto nowhere = static_cast<std::size_t>(-1);
  std::vector<std::size_t> place_in_open(chain.size(), nowhere);
  std::vector<Index> open;
  const auto close = [&](std::size_t from) {
    Chain closed;
    for (std::size_t i = from; i < open.size(); ++i) {
      closed.push_back(chain[open[i]]);
      place_in_open[pass.number[open[i]]] = nowhere;
    }
    open.resize(from);
    simple.push_back(simple_chain(closed, Turns(closed)));
  };
  for (const Index v : pass.vertices) {
    std::size_t& place = place_in_open[pass.number[v]];
    if (place != nowhere) close(place);
    place = open.size();
    open.push_back(v);
  }
  close(0);
}

/// Finds the outer chain directly around each hole; where chains cross, any, or none.
class OuterChains {
 public:
  OuterChains(const std::vector<const Chain*>& outer, const std::vector<const Chain*>& holes)
      : count_(outer.size()), nesting_(nesting(SweptChains(together(outer, holes)))) {}

  std::optional<std::size_t> around(std::size_t hole) const {
    std::optional<std::size_t> result = nesting_.around(count_ + hole);
    while (result && *result >= count_) result = nesting_.around(*result);
    return result;
  }

 private:
  static std::vector<const Chain*> together(std::vector<const Chain*> a,
                                            const std::vector<const Chain*>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  std::size_t count_;
  Nesting nesting_;
};

}  // namespace

Region region_of(const PlanarSet& sum) {
  std::vector<SimpleChain> simple;
  for (const std::vector<Chain>* of_sum : {&sum.outer, &sum.holes})
    for (const Chain& chain : *of_sum) add_simple_chains(chain, simple);
  Region region;
  std::vector<Chain> holes;
  for (SimpleChain& one : simple) {
    if (one.is_counterclockwise)
      region.components.push_back({std::move(one.chain), {}});
    else
      holes.push_back(std::move(one.chain));
  }
  const std::size_t bounded = region.components.size();
  if (sum.is_unbounded) region.components.emplace_back();
  OPLUS_REQUIRES(holes.empty() || !region.components.empty(), "Observation 3.1.4");
  if (region.components.size() == 1) {
    region.components[0].holes = std::move(holes);
    return region;
  }
  if (holes.empty()) return region;
  std::vector<const Chain*> outer_chains, hole_chains;
  for (std::size_t c = 0; c < bounded; ++c) outer_chains.push_back(&region.components[c].outer);
  for (const Chain& hole : holes) hole_chains.push_back(&hole);
  const OuterChains outer_of_hole(outer_chains, hole_chains);
  for (std::size_t h = 0; h < holes.size(); ++h) {
    const std::optional<std::size_t> around = outer_of_hole.around(h);
    OPLUS_REQUIRES(around || sum.is_unbounded, "Observation 3.1.4");
    region.components[around.value_or(bounded)].holes.push_back(std::move(holes[h]));
  }
  return region;
}

PlanarSet canonical_sum(const Region& region) {
  PlanarSet sum;
  if (!touching_points(region).empty()) {
    sum = canonical_sum(BoundaryFeatures{boundary_pieces(region), {}, {}});
    sum.is_unbounded = is_unbounded(region);
    return sum;
  }
  sum.is_unbounded = is_unbounded(region);
  for (const Chain* of_region : chains_in(region)) {
    if (of_region->empty()) continue;
    auto [chain, is_outer] = simple_chain(*of_region, Turns(*of_region));
    std::rotate(chain.begin(),
                chain.begin() + static_cast<std::ptrdiff_t>(start_of_smallest_rotation(chain)),
                chain.end());
    (is_outer ? sum.outer : sum.holes).push_back(std::move(chain));
  }
  std::sort(sum.outer.begin(), sum.outer.end());
  std::sort(sum.holes.begin(), sum.holes.end());
  return sum;
}

ClaimedSum given(const PlanarSet& sum) {
  ClaimedSum result{{}, sum.dangling_edges, sum.isolated_vertices};
  std::vector<const Chain*> outer_chains, hole_chains;
  for (const Chain& outer : sum.outer) {
    outer_chains.push_back(&outer);
    result.region.components.push_back({outer, {}});
  }
  for (const Chain& hole : sum.holes) hole_chains.push_back(&hole);
  const OuterChains outer_of_hole(outer_chains, hole_chains);
  for (std::size_t h = 0; h < sum.holes.size(); ++h) {
    if (const std::optional<std::size_t> around = outer_of_hole.around(h))
      result.region.components[*around].holes.push_back(sum.holes[h]);
    else
      result.region.components.push_back({{}, {sum.holes[h]}});
  }
  return result;
}

}  // namespace oplus
