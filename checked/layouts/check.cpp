// SPDX-License-Identifier: MIT
#include "checked/layouts/check.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "checked/collision/collision_test.hpp"
#include "checked/collision/summand_boundary.hpp"
#include "checked/distance/distance.hpp"
#include "checked/distance/nearest_segments.hpp"
#include "checked/operations/complement.hpp"
#include "checked/operations/union_of.hpp"
#include "checked/slide/parallel_for.hpp"
#include "checked/verify/overlay.hpp"
#include "reference/chains/frame.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/exact_box.hpp"
#include "reference/definitions/region.hpp"
#include "reference/io/invalid_input.hpp"

namespace oplus {

namespace {

/// A shape, and what tests of many pairs need.
struct Shape {
  explicit Shape(const Region& its_region)
      : region(its_region), boundary(region), area(oplus::area(region)) {}

  const Region& region;
  SummandBoundary boundary;
  Rational area;
};

/// A region of a pair, where it is.
struct Body {
  const Shape& shape;
  Vector at;
  Box box;
  std::optional<SegmentTree> moved;  ///< the boundary where it is, if distances are asked for

  const SegmentTree& edges() const { return moved ? *moved : shape.boundary.pieces; }

  ExactBox exact_box() const {
    ExactBox result(shape.boundary.around[0].source + at);
    result.add(shape.boundary.around[0].target + at);
    return result;
  }
};

Body body(const Shape& shape, const Vector& at) {
  return {shape, at, box_of(translated(shape.boundary.around.certified(0), interval(at))), {}};
}

Region both(Region a, const Region& b) {
  a.components.insert(a.components.end(), b.components.begin(), b.components.end());
  return a;
}

Region united(const Region& region) { return region_of(union_of(region)); }

/// What some parts must not overlap: all outside of the container, and defects.
struct Forbidden {
  Forbidden(Region forbidden, const Rational& margin)
      : region(std::move(forbidden)), in_frame(framed(region, margin)), framed_shape(in_frame) {}

  Region region;  ///< unbounded
  Region in_frame;
  Shape framed_shape;
};

class SheetCheck {
 public:
  SheetCheck(const Sheet& sheet, const LayoutRules& rules, unsigned threads)
      : sheet_(sheet), rules_(rules), threads_(threads) {}

  SheetVerdict run() {
    place();
    forbid();
    SheetVerdict result;
    const std::vector<Pair> pairs = near_pairs();
    constexpr std::size_t in_a_lot = 16;
    for (Judged& judged : slide::found_in_parts(
             pairs.size(), threads_,
             [&](std::size_t first, std::size_t last) { return judge(pairs, first, last); },
             in_a_lot)) {
      std::move(judged.faults.begin(), judged.faults.end(), std::back_inserter(result.faults));
      result.forgiven += judged.forgiven;
    }
    for (const Body& part : parts_) result.used_area += part.shape.area;
    result.area = area();
    return result;
  }

 private:
  struct Pair {
    std::optional<std::size_t> other;
    std::size_t part;

    friend auto operator<=>(const Pair&, const Pair&) = default;
  };

  struct Judged {
    std::vector<LayoutFault> faults;
    std::size_t forgiven = 0;
  };

  void place() {
    std::map<const Region*, std::size_t> numbers;
    std::vector<const Region*> regions;
    for (const PlacedPart& part : sheet_.parts)
      if (numbers.emplace(part.shape.get(), regions.size()).second)
        regions.push_back(part.shape.get());
    shapes_.resize(regions.size());
    slide::parallel_for(regions.size(), threads_,
                        [&](std::size_t i) { shapes_[i] = std::make_unique<Shape>(*regions[i]); });
    for (const PlacedPart& part : sheet_.parts)
      parts_.push_back(body(*shapes_[numbers.at(part.shape.get())], part.at));
    if (sgn(rules_.spacing) == 0 && sgn(rules_.margin) == 0) return;
    slide::parallel_for(parts_.size(), threads_, [&](std::size_t i) {
      Body& part = parts_[i];
      if (part.at == Vector{}) return;
      std::vector<Segment> moved;
      for (const Segment& e : edges(part.shape.region)) moved.push_back(translated(e, part.at));
      part.moved.emplace(std::move(moved));
    });
  }

  /// The box around all parts.
  std::optional<ExactBox> box() const {
    std::optional<ExactBox> all;
    for (const Body& part : parts_) {
      const ExactBox one = part.exact_box();
      if (!all) all = one;
      all->add(one.low);
      all->add(one.high);
    }
    return all;
  }

  void forbid() {
    if (!sheet_.container && sheet_.defects.empty()) return;
    const Region outside = sheet_.container ? complement(*sheet_.container) : Region{};
    std::optional<ExactBox> all = box();
    if (!all) return;
    for (const Segment& edge : edges(outside)) all->add(edge.source);
    const Rational margin = all->high.x - all->low.x + all->high.y - all->low.y;
    for (const PlacedPart& part : sheet_.parts) {
      std::unique_ptr<Forbidden>& forbidden = forbidden_[part.least_quality];
      if (forbidden) continue;
      Region region = outside;
      for (const DefectiveZone& defect : sheet_.defects)
        if (!part.least_quality || defect.quality < *part.least_quality)
          region = both(std::move(region), defect.region);
      forbidden = std::make_unique<Forbidden>(united(region), margin);
    }
  }

  /// Those whose boxes are not too far apart. Parts are passed from left to right.
  std::vector<Pair> near_pairs() const {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < parts_.size() && !forbidden_.empty(); ++i)
      pairs.push_back({std::nullopt, i});
    std::vector<std::pair<Box, std::size_t>> boxes;
    for (std::size_t i = 0; i < parts_.size(); ++i)
      boxes.emplace_back(enlarged(parts_[i].box, interval(rules_.spacing).high), i);
    std::sort(boxes.begin(), boxes.end(), [](const auto& a, const auto& b) {
      return std::pair(a.first.low_x, a.second) < std::pair(b.first.low_x, b.second);
    });
    for (auto a = boxes.begin(); a != boxes.end(); ++a)
      for (auto b = std::next(a); b != boxes.end() && b->first.low_x <= a->first.high_x; ++b)
        if (meet(a->first, parts_[b->second].box))
          pairs.push_back({std::min(a->second, b->second), std::max(a->second, b->second)});
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  Judged judge(const std::vector<Pair>& pairs, std::size_t first, std::size_t last) const {
    Judged result;
    for (std::size_t i = first; i < last; ++i) judge(pairs[i], result);
    return result;
  }

  void judge(const Pair& pair, Judged& result) const {
    const Body& q = parts_[pair.part];
    const auto fault = [&](auto what) {
      result.faults.push_back({pair.other, pair.part, std::move(what)});
    };
    const Forbidden* forbidden =
        pair.other ? nullptr : forbidden_.at(sheet_.parts[pair.part].least_quality).get();
    const Shape& p = forbidden ? forbidden->framed_shape : parts_[*pair.other].shape;
    const Vector p_at = forbidden ? Vector{} : parts_[*pair.other].at;
    const Rational& gap = forbidden ? rules_.margin : rules_.spacing;
    const bool do_meet = interiors_meet(p.boundary, q.shape.boundary, q.at - p_at);
    if (!do_meet && sgn(gap) == 0) return;
    if (!do_meet) {
      const SegmentTree& of_p = forbidden ? p.boundary.pieces : parts_[*pair.other].edges();
      NearestPoints nearest = nearest_points(of_p, q.edges());
      if (nearest.squared_distance < gap * gap) fault(std::move(nearest));
      return;
    }
    const Region of_q = translated(q.shape.region, q.at);
    const Region of_p = forbidden ? forbidden->region : translated(p.region, p_at);
    std::optional<Overlap> way_out = way_out_of(of_p, of_q);
    if (!way_out || way_out->squared_depth > rules_.tolerance * rules_.tolerance)
      return fault(found(forbidden ? p.region : of_p, of_q, std::move(way_out)));
    ++result.forgiven;
    if (sgn(gap) > 0) fault(distance(of_p, of_q));
  }

  static std::optional<Overlap> way_out_of(const Region& p, const Region& q) {
    try {
      return depth(p, q);
    } catch (const InvalidInput&) {
      return std::nullopt;
    }
  }

  static OverlapFound found(const Region& p, const Region& q, std::optional<Overlap> way_out) {
    const std::optional<Point> witness = Overlay({p, {}, {}}, canonical_sum(q)).common_point();
    return {witness.value(), oplus::area(p) + oplus::area(q) - oplus::area(united(both(p, q))),
            std::move(way_out)};
  }

  Rational area() const {
    if (sheet_.container) {
      Region outside = complement(*sheet_.container);
      for (const DefectiveZone& defect : sheet_.defects)
        outside = both(std::move(outside), defect.region);
      return -oplus::area(united(outside));
    }
    const std::optional<ExactBox> all = box();
    if (!all) return 0;
    return (all->high.x - all->low.x) * (all->high.y - all->low.y);
  }

  const Sheet& sheet_;
  const LayoutRules& rules_;
  const unsigned threads_;
  std::vector<std::unique_ptr<Shape>> shapes_;
  std::vector<Body> parts_;
  std::map<std::optional<int>, std::unique_ptr<Forbidden>> forbidden_;
};

}  // namespace

SheetVerdict check(const Sheet& sheet, const LayoutRules& rules, unsigned threads) {
  return SheetCheck(sheet, rules, threads).run();
}

}  // namespace oplus
