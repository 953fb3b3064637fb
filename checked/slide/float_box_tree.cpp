// SPDX-License-Identifier: MIT
#include "checked/slide/float_box_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "checked/slide/parallel_for.hpp"

namespace oplus::slide {

namespace {

float rounded_down(double value) {
  const auto rounded = static_cast<float>(value);
  return static_cast<double>(rounded) <= value
             ? rounded
             : std::nextafter(rounded, -std::numeric_limits<float>::infinity());
}

}  // namespace

FloatBox box_around(double ax, double ay, double bx, double by) {
  return box_of(rounded_down(std::min(ax, bx)), rounded_down(std::min(ay, by)),
                rounded_down(-std::max(ax, bx)), rounded_down(-std::max(ay, by)));
}

/// What a tree is built of.
struct FloatBoxTree::Edges {
  const std::vector<FloatBox>& boxes;
  std::span<const NearSegment> segments;  ///< empty if there are no strips
  std::vector<std::uint32_t> order;       ///< that of the leaves
  std::size_t of_a_thread;                ///< twice as many are divided between two
};

/// The edges from the first up to, not including, the last.
struct FloatBoxTree::PartOfBoundary {
  FloatBox box;
  std::uint32_t first, last;
};

namespace {

float half_circumference(const FloatBox& box) { return -(box[0] + box[1] + box[2] + box[3]); }

FloatBox box_around(const std::vector<FloatBox>& boxes, std::span<const std::uint32_t> edges) {
  FloatBox box = boxes[edges[0]];
  for (const std::uint32_t edge : edges.subspan(1)) box = around(box, boxes[edge]);
  return box;
}

/// The boxes around the halves of a set of edges in an order.
struct Halves {
  FloatBox first;
  FloatBox second;

  float reach() const { return half_circumference(first) + half_circumference(second); }
};

Halves halves_of(const std::vector<FloatBox>& boxes, std::span<const std::uint32_t> edges) {
  const std::size_t half = edges.size() / 2;
  return {box_around(boxes, edges.first(half)), box_around(boxes, edges.subspan(half))};
}

constexpr std::size_t too_few = 4;  // edges, for their order to matter

/// The side of the boxes of items along which they are spread most.
template <typename Items, typename BoxOf>
std::size_t side_of_most_spread(const Items& items, const BoxOf& box_of) {
  FloatBox low = box_of(items[0]), high = low;
  for (const auto& item : items) {
    const FloatBox& box = box_of(item);
    low = around(low, box);
    high = high < box ? box : high;
  }
  std::size_t side = 0;
  for (std::size_t other = 1; other < 4; ++other)
    if (high[other] - low[other] > high[side] - low[side]) side = other;
  return side;
}

/// Orders edges by one of the sides of their boxes, that along which they are spread most; then each
/// half of them, so many times. What is not divided stays in order.
void order_by_sides(const std::vector<FloatBox>& boxes, std::span<std::uint32_t> edges,
                    unsigned halvings) {
  if (halvings == 0 || edges.size() <= too_few) return;
  const std::size_t side = side_of_most_spread(
      edges, [&](std::uint32_t edge) -> const FloatBox& { return boxes[edge]; });
  const auto key = [&](std::uint32_t edge) {
    return std::pair<float, std::uint32_t>(boxes[edge][side], edge);
  };
  std::vector<std::uint32_t> by_side(edges.begin(), edges.end());
  const std::size_t half = edges.size() / 2;
  const auto middle = by_side.begin() + static_cast<std::ptrdiff_t>(half);
  std::nth_element(by_side.begin(), middle, by_side.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  const auto first_of_second = key(*middle);
  std::stable_partition(edges.begin(), edges.end(),
                        [&](std::uint32_t edge) { return key(edge) < first_of_second; });
  order_by_sides(boxes, edges.first(half), halvings - 1);
  order_by_sides(boxes, edges.subspan(half), halvings - 1);
}

/// How large the boxes are around what halvings leave together.
float reach(const std::vector<FloatBox>& boxes, std::span<const std::uint32_t> edges,
            unsigned halvings) {
  if (halvings == 0 || edges.size() <= too_few) return half_circumference(box_around(boxes, edges));
  const std::size_t half = edges.size() / 2;
  return reach(boxes, edges.first(half), halvings - 1) +
         reach(boxes, edges.subspan(half), halvings - 1);
}

/// A strip in a direction around edges.
template <typename EachEdge>
Strip strip_around(std::span<const NearSegment> segments, const EachEdge& each_edge, double dx,
                   double dy) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Strip strip{dx, dy, infinity, -infinity};
  double largest = 0;
  const auto add = [&](double x, double y) {
    const double place = dx * y - dy * x;
    strip.low = std::min(strip.low, place);
    strip.high = std::max(strip.high, place);
    largest = std::max({largest, std::abs(x), std::abs(y)});
  };
  each_edge([&](std::uint32_t edge) {
    const NearSegment& s = segments[edge];
    add(s.x, s.y);
    add(s.x + s.dx, s.y + s.dy);
  });
  strip.low -= largest * 0x1p-48 + 0x1p-400;
  strip.high += largest * 0x1p-48 + 0x1p-400;
  return strip;
}

}  // namespace

/// Of the points of edges, each edge with the same weight: how many edges, the mean, and the second
/// moments about it.
struct FloatBoxTree::Moments {
  double count, x, y;
  double xx, xy, yy;

  static Moments of(const NearSegment& s) {
    return {
        1, s.x + s.dx / 2, s.y + s.dy / 2, s.dx * s.dx / 12, s.dx * s.dy / 12, s.dy * s.dy / 12};
  }

  friend Moments operator+(const Moments& a, const Moments& b) {
    const double all = a.count + b.count, share = b.count / all, weight = a.count * share;
    const double dx = b.x - a.x, dy = b.y - a.y;
    return {all,
            a.x + share * dx,
            a.y + share * dy,
            a.xx + b.xx + weight * dx * dx,
            a.xy + b.xy + weight * dx * dy,
            a.yy + b.yy + weight * dy * dy};
  }
};

FloatBoxTree::FloatBoxTree(const std::vector<FloatBox>& of_edges,
                           std::span<const NearSegment> segments,
                           std::span<const std::uint32_t> chains, unsigned threads) {
  constexpr std::size_t too_few_for_strips = 32, too_few_for_a_thread = 1024;
  const auto size = static_cast<std::uint32_t>(of_edges.size());
  Edges edges{of_edges,
              segments.size() < too_few_for_strips ? std::span<const NearSegment>() : segments,
              std::vector<std::uint32_t>(size),
              std::max<std::size_t>(too_few_for_a_thread, size / std::max(threads, 1u))};
  std::iota(edges.order.begin(), edges.order.end(), 0u);
  nodes_.reserve(2 * of_edges.size());
  std::vector<PartOfBoundary> parts;
  for (std::size_t k = 0; k < std::max<std::size_t>(chains.size(), 1); ++k) {
    const std::uint32_t first = chains.empty() ? 0 : chains[k];
    const std::uint32_t last = k + 1 < chains.size() ? chains[k + 1] : size;
    parts.push_back(
        {box_around(of_edges, std::span(edges.order).subspan(first, last - first)), first, last});
  }
  add(edges, parts);
}

FloatBoxTree::Moments FloatBoxTree::add(Edges& edges, std::span<PartOfBoundary> chains) {
  if (chains.size() == 1) return add(edges, chains[0].first, chains[0].last, chains[0].box, 0);
  const std::size_t side = side_of_most_spread(
      chains, [](const PartOfBoundary& chain) -> const FloatBox& { return chain.box; });
  std::sort(chains.begin(), chains.end(), [&](const PartOfBoundary& a, const PartOfBoundary& b) {
    return std::pair<float, std::uint32_t>(a.box[side], a.first) <
           std::pair<float, std::uint32_t>(b.box[side], b.first);
  });
  // As equally as can be by the number of edges.
  std::size_t all = 0, before = 0, middle = 1;
  FloatBox box = chains[0].box;
  for (const PartOfBoundary& chain : chains) {
    all += chain.last - chain.first;
    box = around(box, chain.box);
  }
  for (std::size_t k = 0; k + 1 < chains.size(); ++k) {
    before += chains[k].last - chains[k].first;
    middle = k + 1;
    if (2 * before + (chains[k + 1].last - chains[k + 1].first) >= all) break;
  }
  const std::size_t here = nodes_.size();
  nodes_.push_back({box, none, none, half_circumference(box), none});
  const auto [left, right] = add_halves(
      edges, all, [&](FloatBoxTree& tree) { return tree.add(edges, chains.first(middle)); },
      [&](FloatBoxTree& tree) { return tree.add(edges, chains.subspan(middle)); });
  return with_strip(edges, here, left, right, [&](const auto& visit) {
    for (const PartOfBoundary& chain : chains)
      for (std::uint32_t edge = chain.first; edge < chain.last; ++edge) visit(edge);
  });
}

FloatBoxTree::Moments FloatBoxTree::add(Edges& edges, std::uint32_t first, std::uint32_t last,
                                        const FloatBox& box, unsigned settled) {
  const std::size_t here = nodes_.size();
  const std::span<std::uint32_t> these(edges.order.data() + first, last - first);
  nodes_.push_back({box, none, none, half_circumference(box), none});
  if (these.size() == 1) {
    nodes_[here].edge = these[0];
    return edges.segments.empty() ? Moments{} : Moments::of(edges.segments[these[0]]);
  }
  Halves halves = halves_of(edges.boxes, these);
  if (settled > 0) {
    --settled;
  } else if (these.size() > too_few) {
    // A box that is cut in two across its longer side.
    const float width = -(box[0] + box[2]), height = -(box[1] + box[3]);
    const float least = std::max(width, height) + 2 * std::min(width, height);
    if (halves.reach() > 1.1F * least) {
      // One halving may show nothing: rings around each other share no place only once each is
      // divided into its sides.
      constexpr unsigned halvings = 4;
      std::vector<std::uint32_t> by_sides(these.begin(), these.end());
      order_by_sides(edges.boxes, by_sides, halvings);
      if (reach(edges.boxes, by_sides, halvings) < reach(edges.boxes, these, halvings)) {
        std::copy(by_sides.begin(), by_sides.end(), these.begin());
        halves = halves_of(edges.boxes, these);
        settled = halvings - 1;
      }
    }
  }
  const std::uint32_t middle = first + (last - first) / 2;
  const auto [left, right] = add_halves(
      edges, these.size(),
      [&](FloatBoxTree& tree) { return tree.add(edges, first, middle, halves.first, settled); },
      [&](FloatBoxTree& tree) { return tree.add(edges, middle, last, halves.second, settled); });
  return with_strip(edges, here, left, right, [&](const auto& visit) {
    for (const std::uint32_t edge : these) visit(edge);
  });
}

template <typename First, typename Second>
std::pair<FloatBoxTree::Moments, FloatBoxTree::Moments> FloatBoxTree::add_halves(
    const Edges& edges, std::size_t size, const First& add_first, const Second& add_second) {
  const std::size_t here = nodes_.size() - 1;
  if (size < 2 * edges.of_a_thread) {
    const Moments first = add_first(*this);
    nodes_[here].right = static_cast<std::uint32_t>(nodes_.size());
    return {first, add_second(*this)};
  }
  FloatBoxTree other;
  std::pair<Moments, Moments> moments;
  parallel_for(2, 2, [&](std::size_t half) {
    (half == 0 ? moments.first : moments.second) = half == 0 ? add_first(*this) : add_second(other);
  });
  const auto nodes = static_cast<std::uint32_t>(nodes_.size());
  const auto strips = static_cast<std::uint32_t>(strips_.size());
  nodes_[here].right = nodes;
  for (Node node : other.nodes_) {
    if (!node.is_leaf()) node.right += nodes;
    if (node.strip != none) node.strip += strips;
    nodes_.push_back(node);
  }
  strips_.insert(strips_.end(), other.strips_.begin(), other.strips_.end());
  return moments;
}

template <typename EachEdge>
FloatBoxTree::Moments FloatBoxTree::with_strip(const Edges& edges, std::size_t here,
                                               const Moments& left, const Moments& right,
                                               const EachEdge& each_edge) {
  Node& node = nodes_[here];
  // Opening it helps little where its halves are nearly as large.
  const float size = half_circumference(node.box);
  const float of_halves =
      half_circumference(nodes_[here + 1].box) + half_circumference(nodes_[node.right].box);
  node.size = std::clamp(8 * (2 * size - of_halves), size / 64, size);
  if (edges.segments.empty()) return {};
  const FloatBox box = node.box;

  // The direction in which the edges are spread most, and their variance across it: a strip is at
  // least twice as wide as the root of that.
  const Moments all = left + right;
  const double difference = std::hypot(all.xx - all.yy, 2 * all.xy);
  const double cosine = difference > 0 ? (all.xx - all.yy) / difference : 1;  // of twice the angle
  const double dx = std::sqrt(std::max(0.0, (1 + cosine) / 2));
  const double dy = std::copysign(std::sqrt(std::max(0.0, (1 - cosine) / 2)), all.xy);
  const double across_box = dx * -static_cast<double>(box[1] + box[3]) +
                            std::abs(dy) * -static_cast<double>(box[0] + box[2]);
  const double variance = (all.xx + all.yy - difference) / 2 / all.count;
  if (64 * variance > across_box * across_box) return all;
  const Strip strip = strip_around(edges.segments, each_edge, dx, dy);
  const double width = strip.high - strip.low;
  if (4 * width > across_box) return all;
  node.strip = static_cast<std::uint32_t>(strips_.size());
  node.size = std::min(node.size, static_cast<float>(2 * width));
  strips_.push_back(strip);
  return all;
}

}  // namespace oplus::slide
