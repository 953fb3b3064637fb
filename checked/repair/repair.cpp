// SPDX-License-Identifier: MIT
#include "checked/repair/repair.hpp"

#include <algorithm>
#include <deque>
#include <string>
#include <utility>

#include "checked/repair/filled.hpp"
#include "reference/chains/near_point.hpp"
#include "reference/chains/nesting.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/io/invalid_region.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

Mend mend_at(const UncheckedInput& input, MendKind kind, const Position& at, std::string what) {
  return {kind, {input.name, at.line, at.column}, std::move(what)};
}

/// Whether a chain that goes from a to b turns back there to go to c.
bool turns_back(const Point& a, const Point& b, const Point& c) {
  return orientation(a, b, c) == 0 && dot(b - a, c - b) < 0;
}

/// Leaves out repeated vertices and spikes of a chain.
class ChainMender {
 public:
  ChainMender(const UncheckedInput& input, PlacedChain& chain) : input_(input), chain_(chain) {}

  /// What was done; or nothing, and no vertex is left, where the chain encloses nothing.
  std::vector<Mend> mend() {
    for (std::size_t v = 0; v < chain_.vertices.size(); ++v) {
      kept_.push_back(v);
      while (mend_last()) {
      }
    }
    while (kept_.size() >= 3 &&
           !OPLUS_MUTANT("repair-forgets-the-last-edge",
                         "a repair does not look at the edge from the last vertex to the first") &&
           mend_ends()) {
    }
    if (kept_.size() < 3) {
      chain_.vertices.clear();
      return {};
    }
    if (!mends_.empty()) keep();
    std::stable_sort(mends_.begin(), mends_.end(), [](const Mend& a, const Mend& b) {
      return std::pair(a.where.line, a.where.column) < std::pair(b.where.line, b.where.column);
    });
    return std::move(mends_);
  }

 private:
  const Point& at(std::size_t index) const { return chain_.vertices[kept_[index]]; }

  /// Mends what the last vertex has brought; returns whether there was anything.
  bool mend_last() {
    const std::size_t n = kept_.size();
    if (n >= 2 && at(n - 2) == at(n - 1)) {
      add_repeated(kept_[n - 2], kept_[n - 1]);
      kept_.pop_back();
      return true;
    }
    if (n < 3 || !turns_back(at(n - 3), at(n - 2), at(n - 1))) return false;
    add_spike(kept_[n - 2]);
    kept_.erase(kept_.end() - 2);
    return true;
  }

  /// The same where the last vertex is followed by the first.
  bool mend_ends() {
    const std::size_t n = kept_.size();
    if (at(n - 1) == at(0)) {
      add_repeated(kept_[0], kept_[n - 1]);
      kept_.pop_back();
    } else if (turns_back(at(n - 2), at(n - 1), at(0))) {
      add_spike(kept_[n - 1]);
      kept_.pop_back();
    } else if (turns_back(at(n - 1), at(0), at(1))) {
      add_spike(kept_[0]);
      kept_.pop_front();
    } else {
      return false;
    }
    return true;
  }

  std::string name(std::size_t vertex) const {
    if (OPLUS_MUTANT("repair-counts-from-zero", "repairs name the vertex before")) --vertex;
    return "vertex " + std::to_string(vertex + 1) + " of " + describe(chain_.name);
  }

  void add_repeated(std::size_t first, std::size_t second) {
    mends_.push_back(mend_at(input_, MendKind::repeated_vertex, chain_.places[second],
                             name(second) + " is equal to vertex " + std::to_string(first + 1) +
                                 ", " + to_string(chain_.vertices[second]) + "; left out"));
  }

  void add_spike(std::size_t tip) {
    mends_.push_back(mend_at(
        input_, MendKind::spike, chain_.places[tip],
        name(tip) + ", " + to_string(chain_.vertices[tip]) + ", is the tip of a spike; left out"));
  }

  void keep() {
    PlacedChain& chain = chain_;
    std::vector<Point> vertices;
    std::vector<Position> places;
    for (const std::size_t v : kept_) {
      vertices.push_back(std::move(chain.vertices[v]));
      places.push_back(chain.places[v]);
      chain.numbers.push_back(v + 1);
    }
    chain.vertices = std::move(vertices);
    chain.places = std::move(places);
  }

  const UncheckedInput& input_;
  PlacedChain& chain_;
  std::deque<std::size_t> kept_;
  std::vector<Mend> mends_;
};

/// Chains by the component they are in: the outer one, then the holes.
using Groups = std::vector<std::vector<std::size_t>>;

/// By the depth of chains that neither cross nor overlap: an even one makes an outer chain. Nothing where an
/// outer chain would become a hole of what an outer chain is around already.
std::optional<Groups> groups_by_depth(const std::vector<PlacedChain>& chains) {
  std::vector<const Chain*> all;
  for (const PlacedChain& chain : chains) all.push_back(&chain.vertices);
  const SweptChains swept(all);
  const Nesting nests = nesting(swept);
  std::vector<bool> is_hole(chains.size(), false);
  std::vector<bool> is_known(chains.size(), false);
  for (std::size_t c = 0; c < chains.size(); ++c) {
    std::vector<std::size_t> way;
    for (std::optional<std::size_t> at = c; at && !is_known[*at]; at = nests.around(*at))
      way.push_back(*at);
    for (; !way.empty(); way.pop_back()) {
      const std::size_t here = way.back();
      is_known[here] = true;
      const std::optional<std::size_t> around = nests.around(here);
      is_hole[here] = around && !is_hole[*around];
      if (is_hole[here] && chains[here].name.hole == 0 && chains[*around].name.hole == 0)
        return std::nullopt;
    }
  }
  std::vector<std::vector<std::size_t>> with_holes(chains.size());
  for (std::size_t c = 0; c < chains.size(); ++c)
    if (!is_hole[c])
      with_holes[c].insert(with_holes[c].begin(), c);
    else
      with_holes[*nests.around(c)].push_back(c);
  Groups result;
  for (std::size_t c = 0; c < chains.size(); ++c)
    if (!is_hole[c]) result.push_back(std::move(with_holes[c]));
  return result;
}

class Repair {
 public:
  explicit Repair(UncheckedInput input) : input_(std::move(input)) {}

  RepairedRegion run(std::optional<FillRule> fill) {
    mend_chains();
    std::optional<Defect> defect = find_defect(region());
    if (defect && is_of_roles(defect->kind) && mend_roles()) defect = find_defect(region());
    orient();
    Region result = region();
    if (defect) result = filled_or_refused(fill);
    return {std::move(result), std::move(mends_)};
  }

 private:
  static bool is_of_roles(DefectKind kind) {
    return kind == DefectKind::hole_outside || kind == DefectKind::holes_nested;
  }

  std::vector<PlacedChain>& chains() { return input_.geometry.chains; }

  void add(MendKind kind, const Position& at, std::string what) {
    mends_.push_back(mend_at(input_, kind, at, std::move(what)));
  }

  /// A copy: the chains are needed for messages.
  Region region() const {
    Region result;
    for (const PlacedChain& chain : input_.geometry.chains) {
      if (chain.name.hole == 0)
        result.components.push_back({chain.vertices, {}});
      else
        result.components.back().holes.push_back(chain.vertices);
    }
    return result;
  }

  void mend_chains() {
    std::vector<PlacedChain> kept;
    bool is_outer_left_out = false;
    for (PlacedChain& chain : chains()) {
      if (chain.name.hole == 0) is_outer_left_out = false;
      if (chain.name.hole == 0 && chain.vertices.empty())
        InputText{input_.name}.refuse(
            chain.start, describe(chain.name) + " is missing, so the region is unbounded",
            "a bounded region");
      if (is_outer_left_out) {
        add(MendKind::empty_chain, chain.start,
            describe(chain.name) + " has no outer chain any more; left out");
        continue;
      }
      if (chain.is_open) {
        chain.is_open = false;
        add(MendKind::closed_ring, chain.places.back(),
            describe(chain.name) + " was not closed; an edge goes from " +
                to_string(chain.vertices.back()) + " to " + to_string(chain.vertices.front()));
      }
      for (Mend& mend : ChainMender(input_, chain).mend()) mends_.push_back(std::move(mend));
      if (chain.vertices.empty()) {
        is_outer_left_out = chain.name.hole == 0;
        add(MendKind::empty_chain, chain.start,
            describe(chain.name) + " encloses nothing; left out");
        continue;
      }
      kept.push_back(std::move(chain));
    }
    chains() = std::move(kept);
  }

  /// Returns whether it could.
  bool mend_roles() {
    const std::optional<Groups> groups = groups_by_depth(chains());
    if (!groups) return false;
    std::vector<PlacedChain> grouped;
    std::vector<std::pair<Position, std::string>> changes;
    std::size_t component = 0;
    for (const std::vector<std::size_t>& group : *groups) {
      const std::size_t before = chains()[group[0]].name.component;
      ++component;
      for (std::size_t i = 0; i < group.size(); ++i) {
        PlacedChain& chain = chains()[group[i]];
        const ChainName name{component, i};
        const bool was_hole = chain.name.hole != 0;
        if (was_hole != (i > 0) || (was_hole && chain.name.component != before))
          changes.emplace_back(chain.start, describe(chain.name) + " is now " + describe(name));
        names_.push_back(name);
        grouped.push_back(std::move(chain));
      }
    }
    for (std::size_t i = 0; i < grouped.size(); ++i) grouped[i].name = names_[i];
    chains() = std::move(grouped);
    std::stable_sort(changes.begin(), changes.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& [at, what] : changes) add(MendKind::role, at, std::move(what));
    return true;
  }

  void orient() {
    for (PlacedChain& chain : chains())
      if (turn_as_named(chain))
        add(MendKind::orientation, chain.start,
            describe(chain.name) + " was " +
                (chain.name.hole == 0 ? "clockwise" : "counterclockwise") + "; turned");
  }

  Region filled_or_refused(std::optional<FillRule> fill) {
    const Region given = region();
    const std::optional<Defect> defect = find_defect(given);
    try {
      refuse_defect({input_.name}, input_.geometry, *defect);
    } catch (const InvalidInput& refused) {
      if (!fill)
        throw InvalidInput(refused.where(), refused.wrong(),
                           "what can be repaired without a fill rule");
      const bool is_even_odd = *fill == FillRule::even_odd;
      mends_.push_back({MendKind::filled, refused.where(),
                        refused.wrong() + "; all chains filled by the rule " +
                            (is_even_odd ? "even-odd" : "nonzero")});
    }
    std::vector<Chain> all;
    for (PlacedChain& chain : chains()) {
      if (input_.geometry.has_directions && chain.is_turned)
        std::reverse(chain.vertices.begin(), chain.vertices.end());
      all.push_back(std::move(chain.vertices));
    }
    return region_of(filled(all, *fill));
  }

  UncheckedInput input_;
  std::vector<ChainName> names_;
  std::vector<Mend> mends_;
};

}  // namespace

RepairedRegion repaired(UncheckedInput input, std::optional<FillRule> fill) {
  return Repair(std::move(input)).run(fill);
}

}  // namespace oplus
