// SPDX-License-Identifier: MIT
#include "checked/slide/box_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

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

/// What a tree is built of.
struct BoxTree::Edges {
  const std::vector<Box>& boxes;
  const std::vector<NearSegment>* segments;  ///< if there are strips
  std::vector<std::uint32_t>& order;         ///< that of the leaves
};

BoxTree::BoxTree(const std::vector<Box>& of_edges) : BoxTree(of_edges, {}) {}

BoxTree::BoxTree(const std::vector<Box>& of_edges, const std::vector<NearSegment>& edges) {
  constexpr std::size_t too_few = 32;  // for strips to save time
  const auto size = static_cast<std::uint32_t>(of_edges.size());
  std::vector<std::uint32_t> order(size);
  std::iota(order.begin(), order.end(), 0u);
  nodes_.reserve(2 * of_edges.size());
  add({of_edges, edges.size() < too_few ? nullptr : &edges, order}, 0, size);
}

namespace {

float half_circumference(const Box& box) { return -(box[0] + box[1] + box[2] + box[3]); }

Box box_around(const std::vector<Box>& boxes, std::span<const std::uint32_t> edges) {
  Box box = boxes[edges[0]];
  for (const std::uint32_t edge : edges.subspan(1)) box = around(box, boxes[edge]);
  return box;
}

/// How far the halves of a set of edges, in the given order, reach: the sum of their circumferences.
float reach_of_halves(const std::vector<Box>& boxes, std::span<const std::uint32_t> edges) {
  const std::size_t half = edges.size() / 2;
  return half_circumference(box_around(boxes, edges.first(half))) +
         half_circumference(box_around(boxes, edges.subspan(half)));
}

/// Orders edges so that the first half has the smaller middles along the axis along which the middles
/// are spread more. Either half stays in order.
void halve_by_place(const std::vector<Box>& boxes, std::span<std::uint32_t> edges) {
  const auto twice_middle = [&](std::uint32_t edge, std::size_t axis) {
    return boxes[edge][axis] - boxes[edge][axis + 2];
  };
  std::array<float, 2> spread;
  for (const std::size_t axis : {0u, 1u}) {
    float low = twice_middle(edges[0], axis), high = low;
    for (const std::uint32_t edge : edges) {
      low = std::min(low, twice_middle(edge, axis));
      high = std::max(high, twice_middle(edge, axis));
    }
    spread[axis] = high - low;
  }
  const std::size_t axis = spread[0] < spread[1];
  const auto key = [&](std::uint32_t edge) { return std::pair(twice_middle(edge, axis), edge); };
  std::vector<std::uint32_t> by_place(edges.begin(), edges.end());
  const auto middle = by_place.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
  std::nth_element(by_place.begin(), middle, by_place.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  const auto first_of_second = key(*middle);
  std::stable_partition(edges.begin(), edges.end(),
                        [&](std::uint32_t edge) { return key(edge) < first_of_second; });
}

/// A strip around edges, in the direction in which they are spread most, if it is much narrower than
/// their box.
std::optional<Strip> narrow_strip(const std::vector<NearSegment>& segments,
                                  std::span<const std::uint32_t> edges, const Box& box) {
  // The moments of the middles and the directions, about the middle of the box.
  const double middle_x = (static_cast<double>(box[0]) - static_cast<double>(box[2])) / 2;
  const double middle_y = (static_cast<double>(box[1]) - static_cast<double>(box[3])) / 2;
  double xx = 0, xy = 0, yy = 0;
  for (const std::uint32_t edge : edges) {
    const NearSegment& s = segments[edge];
    const double x = s.x + s.dx / 2 - middle_x, y = s.y + s.dy / 2 - middle_y;
    xx += x * x + s.dx * s.dx / 12;
    xy += x * y + s.dx * s.dy / 12;
    yy += y * y + s.dy * s.dy / 12;
  }
  const double angle = std::atan2(2 * xy, xx - yy) / 2;
  Strip strip{std::cos(angle), std::sin(angle), std::numeric_limits<double>::infinity(),
              -std::numeric_limits<double>::infinity()};
  double largest = 0;
  const auto add = [&](double x, double y) {
    const double place = strip.dx * y - strip.dy * x;
    strip.low = std::min(strip.low, place);
    strip.high = std::max(strip.high, place);
    largest = std::max({largest, std::abs(x), std::abs(y)});
  };
  for (const std::uint32_t edge : edges) {
    const NearSegment& s = segments[edge];
    add(s.x, s.y);
    add(s.x + s.dx, s.y + s.dy);
  }
  strip.low -= largest * 0x1p-48 + 0x1p-400;
  strip.high += largest * 0x1p-48 + 0x1p-400;
  const double across_box = std::abs(strip.dx) * -static_cast<double>(box[1] + box[3]) +
                            std::abs(strip.dy) * -static_cast<double>(box[0] + box[2]);
  if (2 * (strip.high - strip.low) > across_box) return std::nullopt;
  return strip;
}

}  // namespace

void BoxTree::add(const Edges& edges, std::uint32_t first, std::uint32_t last) {
  const std::size_t here = nodes_.size();
  const std::span<std::uint32_t> these(edges.order.data() + first, last - first);
  nodes_.push_back({edges.boxes[these[0]], none, none, 0, none});
  if (these.size() == 1) {
    nodes_[here].edge = these[0];
  } else {
    const Box box = box_around(edges.boxes, these);
    constexpr std::size_t too_few = 4;  // for the order to matter
    if (these.size() > too_few) {
      // A box that is cut in two across its longer side.
      const float width = -(box[0] + box[2]), height = -(box[1] + box[3]);
      const float least = std::max(width, height) + 2 * std::min(width, height);
      const float by_order = reach_of_halves(edges.boxes, these);
      if (by_order > 1.1F * least) {
        const std::vector<std::uint32_t> in_order(these.begin(), these.end());
        halve_by_place(edges.boxes, these);
        if (by_order <= reach_of_halves(edges.boxes, these))
          std::copy(in_order.begin(), in_order.end(), these.begin());
      }
    }
    if (edges.segments != nullptr) {
      if (const auto strip = narrow_strip(*edges.segments, these, box)) {
        nodes_[here].strip = static_cast<std::uint32_t>(strips_.size());
        strips_.push_back(*strip);
        nodes_[here].size = static_cast<float>(2 * (strip->high - strip->low));
      }
    }
    const std::uint32_t middle = first + (last - first) / 2;
    add(edges, first, middle);
    const auto right = static_cast<std::uint32_t>(nodes_.size());
    add(edges, middle, last);
    nodes_[here].right = right;
    nodes_[here].box = box;
  }
  if (nodes_[here].strip == none) nodes_[here].size = half_circumference(nodes_[here].box);
}

}  // namespace oplus::slide
