// SPDX-License-Identifier: MIT
#include "checked/slide/box_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace oplus::slide {

namespace {

float rounded_down(double value) {
  const auto rounded = static_cast<float>(value);
  return static_cast<double>(rounded) <= value
             ? rounded
             : std::nextafter(rounded, -std::numeric_limits<float>::infinity());
}

}  // namespace

Box box_around(double ax, double ay, double bx, double by) {
  return box_of(rounded_down(std::min(ax, bx)), rounded_down(std::min(ay, by)),
                rounded_down(-std::max(ax, bx)), rounded_down(-std::max(ay, by)));
}

BoxTree::BoxTree(const std::vector<Box>& of_edges) {
  nodes_.reserve(2 * of_edges.size());
  add(of_edges, 0, static_cast<std::uint32_t>(of_edges.size()));
}

void BoxTree::add(const std::vector<Box>& of_edges, std::uint32_t first, std::uint32_t last) {
  const std::size_t here = nodes_.size();
  nodes_.push_back({of_edges[first], last - first == 1 ? first : none, none, 0});
  if (last - first > 1) {
    const std::uint32_t middle = first + (last - first) / 2;
    add(of_edges, first, middle);
    const auto right = static_cast<std::uint32_t>(nodes_.size());
    add(of_edges, middle, last);
    nodes_[here].right = right;
    nodes_[here].box = around(nodes_[here + 1].box, nodes_[right].box);
  }
  const Box& box = nodes_[here].box;
  nodes_[here].size = -(box[0] + box[1] + box[2] + box[3]);
}

}  // namespace oplus::slide
