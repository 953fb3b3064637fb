// SPDX-License-Identifier: MIT
#pragma once

#include "checked/slide/box_tree.hpp"
#include "checked/slide/short_list.hpp"

namespace oplus::slide {

/// Visits the leaves of a tree whose boxes contain a place, as contains() takes it. Stops where a visit
/// returns true; returns whether one did.
template <typename Visit>
bool any_leaf_around(const BoxTree& tree, const Box& place, const Visit& visit) {
  ShortList<std::uint32_t> waiting;
  std::uint32_t node = 0;
  while (true) {
    const BoxTree::Node& here = tree[node];
    if (contains(here.box, place)) {
      if (!here.is_leaf()) {
        waiting.push_back(here.right);
        ++node;
        continue;
      }
      if (visit(here.edge)) return true;
    }
    if (waiting.empty()) return false;
    node = waiting.back();
    waiting.pop_back();
  }
}

}  // namespace oplus::slide
