// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "reference/chains/plane_sweep.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// The chains as chains(region) has them, not copied: a region may have millions of vertices.
std::vector<const Chain*> chains_in(const Region& region);

/// The edges of chains, to be swept; it refers to the chains. Edge i leaves point i.
struct SweptChains {
  explicit SweptChains(const std::vector<const Chain*>& chains);

  /// Whether more than two ends of edges meet at a place: those of two neighbours at their vertex do not.
  bool is_touched(const SweptPlace& place) const {
    return place.left.size() + place.right.size() > 2;
  }
  VertexIndex name(std::uint32_t edge) const {
    return {chain_of[edge], edge - first_of_chain[chain_of[edge]]};
  }

  SweptEdges edges;
  std::vector<std::uint32_t> chain_of;  ///< of each edge
  std::vector<std::uint32_t> first_of_chain;
};

/// Which chain is directly around another one.
///
/// Requires: chains don't cross or overlap, themselves or each other; they may touch. No chain winds
/// around a point twice, or around two points in different directions. Otherwise any chain may count as
/// the one around another, but none as one around itself, by way of others.
class Nesting {
 public:
  explicit Nesting(const SweptChains& chains);

  /// To be called for each place of a sweep over the chains.
  void pass(const SweptPlace& place);

  /// The innermost chain that winds around the points inside a chain; empty where there is none.
  /// Requires: all places are passed, or at least those up to the chain's smallest vertex.
  std::optional<std::size_t> around(std::size_t chain) const { return found_[chain].around; }

 private:
  struct Found {
    bool is_passed = false;
    bool is_counterclockwise = false;
    std::optional<std::uint32_t> around;
  };

  const SweptChains& chains_;
  std::vector<Found> found_;
};

/// The same of all chains at once: O(n log n) for n vertices.
Nesting nesting(const SweptChains& chains);

}  // namespace oplus
