// SPDX-License-Identifier: MIT
#include "checked/slide/component_tree.hpp"

#include <algorithm>
#include <span>

namespace oplus::slide {

namespace {

using NearBox = ComponentTree::NearBox;
using Node = ComponentTree::Node;

NearBox around(const NearBox& a, const NearBox& b) {
  return {std::min(a.low_x, b.low_x), std::min(a.low_y, b.low_y), std::max(a.high_x, b.high_x),
          std::max(a.high_y, b.high_y)};
}

NearBox near_box(const NearSegment& s, const NearSegment& next) {
  return {std::min(s.x, next.x), std::min(s.y, next.y), std::max(s.x, next.x),
          std::max(s.y, next.y)};
}

struct Item {
  NearBox box;
  std::uint32_t number;
};

/// Appends a tree over the items, halved across the longer side of their box; make_leaf(item) appends
/// a leaf, or the tree that is in its place.
template <typename MakeLeaf>
void add_tree(std::vector<Node>& nodes, std::span<Item> items, const MakeLeaf& make_leaf) {
  if (items.size() == 1) return make_leaf(items[0]);
  const std::size_t here = nodes.size();
  nodes.push_back({items[0].box, 0, 0, ComponentTree::none});
  for (const Item& item : items) nodes[here].box = around(nodes[here].box, item.box);
  const NearBox box = nodes[here].box;
  const bool by_x = box.high_x - box.low_x > box.high_y - box.low_y;
  const auto middle = [&](const Item& item) {
    return by_x ? item.box.low_x / 2 + item.box.high_x / 2
                : item.box.low_y / 2 + item.box.high_y / 2;
  };
  const std::size_t half = items.size() / 2;
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                   [&](const Item& a, const Item& b) { return middle(a) < middle(b); });
  add_tree(nodes, items.first(half), make_leaf);
  nodes[here].right = static_cast<std::uint32_t>(nodes.size());
  add_tree(nodes, items.subspan(half), make_leaf);
}

}  // namespace

ComponentTree::ComponentTree(std::span<const NearSegment> near,
                             std::span<const std::uint32_t> chain_of,
                             std::span<const std::uint32_t> first_of_component)
    : next_(near.size()) {
  std::vector<Item> components, chains;
  std::vector<std::uint32_t> behind(near.size());  // of the first edge of a chain
  for (std::uint32_t c = 0; c + 1 < first_of_component.size(); ++c) {
    chains.clear();
    const std::uint32_t last = first_of_component[c + 1];
    for (std::uint32_t first = first_of_component[c]; first < last;) {
      std::uint32_t end = first + 1;
      while (end < last && chain_of[end] == chain_of[first]) ++end;
      NearBox box = near_box(near[end - 1], near[first]);
      next_[end - 1] = first;
      for (std::uint32_t i = first; i + 1 < end; ++i) {
        box = around(box, near_box(near[i], near[i + 1]));
        next_[i] = i + 1;
      }
      // The outer chain is the first.
      if (chains.empty()) components.push_back({box, c});
      chains.push_back({box, first});
      behind[first] = end;
      first = end;
    }
    chains_of_.push_back(static_cast<std::uint32_t>(parts_.size()));
    add_tree(parts_, chains,
             [&](const Item& chain) { add_part(near, chain.number, behind[chain.number]); });
  }
  add_tree(components_, components, [&](const Item& component) {
    components_.push_back({component.box, component.number, component.number, none});
  });
}

void ComponentTree::add_part(std::span<const NearSegment> near, std::uint32_t first,
                             std::uint32_t last) {
  constexpr std::uint32_t in_a_leaf = 4;
  const std::size_t here = parts_.size();
  parts_.push_back({near_box(near[first], near[next_[first]]), first, last, none});
  if (last - first <= in_a_leaf) {
    for (std::uint32_t i = first + 1; i < last; ++i)
      parts_[here].box = around(parts_[here].box, near_box(near[i], near[next_[i]]));
    return;
  }
  const std::uint32_t middle = first + (last - first) / 2;
  add_part(near, first, middle);
  const auto right = static_cast<std::uint32_t>(parts_.size());
  parts_[here].right = right;
  add_part(near, middle, last);
  parts_[here].box = around(parts_[here + 1].box, parts_[right].box);
}

}  // namespace oplus::slide
