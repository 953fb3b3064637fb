// SPDX-License-Identifier: MIT
#include "checked/layouts/check.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

#include "checked/collision/collision_test.hpp"
#include "checked/collision/summand_boundary.hpp"
#include "checked/distance/distance.hpp"
#include "checked/distance/nearest_segments.hpp"
#include "checked/operations/complement.hpp"
#include "checked/operations/union_of.hpp"
#include "checked/slide/parallel_for.hpp"
#include "reference/chains/frame.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/cells.hpp"
#include "reference/definitions/common_denominator.hpp"
#include "reference/definitions/exact_box.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/region.hpp"
#include "reference/io/invalid_input.hpp"

namespace oplus {

namespace {

/// The common denominator of the coordinates of a sheet, or 1 where that is too large. Multiplied by it, coordinates are
/// integers, and doubles decide contacts.
class Unit {
 public:
  explicit Unit(const Sheet& sheet) {
    bool is_short = true;
    const auto add = [&](const Region& region) {
      is_short = is_short && add_denominators(value_, region, most_bits);
    };
    for (const PlacedPart& part : sheet.parts) {
      add(polygon({part.at}));
      add(*part.shape);
    }
    if (sheet.container) add(*sheet.container);
    for (const DefectiveZone& defect : sheet.defects) add(defect.region);
    if (!is_short) value_ = 1;
  }

  Rational of(const Rational& length) const { return value_ == 1 ? length : length * value_; }
  Point of(const Point& x) const { return {of(x.x), of(x.y)}; }
  SummandBoundary boundary_of(const Region& region) const {
    if (value_ == 1) return SummandBoundary(region);
    return SummandBoundary(mapped(region, [&](const Point& x) { return of(x); }));
  }
  Rational back(const Rational& length) const { return length / value_; }
  Point back(const Point& x) const { return {back(x.x), back(x.y)}; }

 private:
  static constexpr std::size_t most_bits = 40;

  mpz_class value_ = 1;
};

/// A shape, and what tests of many pairs need.
struct Shape {
  Shape(const Region& its_region, const Unit& unit)
      : region(its_region), boundary(unit.boundary_of(region)), area(oplus::area(region)) {}

  const Region& region;
  SummandBoundary boundary;  ///< in units
  Rational area;
};

/// A shape of a pair, where it is.
struct Body {
  const Shape& shape;
  Vector at;                         ///< in units
  std::optional<SegmentTree> moved;  ///< the boundary where it is, if distances are asked for

  const SegmentTree& edges() const { return moved ? *moved : shape.boundary.pieces; }

  /// From corner to corner of its box.
  Segment diagonal() const { return translated(shape.boundary.around[0], at); }
};

Region united(const Region& region) { return region_of(union_of(region)); }

/// What some parts must not overlap: all outside of the container, and defects.
struct Forbidden {
  Forbidden(Region forbidden, const Rational& margin, const Unit& unit)
      : region(std::move(forbidden)),
        in_frame(framed(region, margin)),
        framed_shape(in_frame, unit) {}

  Region region;  ///< unbounded
  Region in_frame;
  Shape framed_shape;
};

class SheetCheck {
 public:
  SheetCheck(const Sheet& sheet, const LayoutRules& rules, unsigned threads)
      : sheet_(sheet),
        rules_(rules),
        threads_(threads),
        unit_(sheet),
        outside_(sheet.container ? outside_of(*sheet.container) : Region{}) {}

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
  static Region outside_of(const Region& container) {
    const bool is_filled =
        OPLUS_MUTANT("layouts-fill-holes", "parts may lie in the holes of a container");
    return complement(is_filled ? polygon(container.components.at(0).outer) : container);
  }

  struct Pair {
    std::optional<std::size_t> other;
    std::size_t part;

    /// Not by default: an optional number of Clang's library before 17 has no operator<=>.
    friend bool operator<(const Pair& a, const Pair& b) {
      return std::tie(a.other, a.part) < std::tie(b.other, b.part);
    }
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
    slide::parallel_for(regions.size(), threads_, [&](std::size_t i) {
      shapes_[i] = std::make_unique<Shape>(*regions[i], unit_);
    });
    for (const PlacedPart& part : sheet_.parts)
      parts_.push_back({*shapes_[numbers.at(part.shape.get())], unit_.of(part.at), {}});
    if (sgn(rules_.spacing) == 0 && sgn(rules_.margin) == 0) return;
    slide::parallel_for(parts_.size(), threads_, [&](std::size_t i) {
      Body& part = parts_[i];
      if (part.at == Vector{}) return;
      const SegmentTree& pieces = part.shape.boundary.pieces;
      std::vector<Segment> moved;
      for (std::size_t k = 0; k < pieces.size(); ++k)
        moved.push_back(translated(pieces[k], part.at));
      part.moved.emplace(std::move(moved));
    });
  }

  /// The box around all parts. Requires: there is one.
  ExactBox box() const {
    ExactBox all(parts_.at(0).diagonal().source);
    for (const Body& part : parts_) {
      const auto [low, high] = part.diagonal();
      all.add(low);
      all.add(high);
    }
    all.low = unit_.back(all.low);
    all.high = unit_.back(all.high);
    return all;
  }

  void forbid() {
    if ((!sheet_.container && sheet_.defects.empty()) || parts_.empty() ||
        OPLUS_MUTANT("layouts-have-no-container", "parts may lie outside of the container"))
      return;
    ExactBox all = box();
    for (const Segment& edge : edges(outside_)) all.add(edge.source);
    const Rational margin = all.high.x - all.low.x + all.high.y - all.low.y;
    for (const PlacedPart& part : sheet_.parts) {
      std::unique_ptr<Forbidden>& forbidden = forbidden_[part.least_quality];
      if (forbidden) continue;
      Region region = outside_;
      for (const DefectiveZone& defect : sheet_.defects)
        if (!part.least_quality || defect.quality < *part.least_quality)
          region = together(std::move(region), defect.region);
      forbidden = std::make_unique<Forbidden>(united(region), margin, unit_);
    }
  }

  /// Those whose boxes are not too far apart.
  std::vector<Pair> near_pairs() const {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < parts_.size() && !forbidden_.empty(); ++i)
      pairs.push_back({std::nullopt, i});
    std::vector<Segment> diagonals;
    for (const Body& part : parts_) diagonals.push_back(part.diagonal());
    const SegmentTree tree(std::move(diagonals));
    const double gap = interval(unit_.of(rules_.spacing)).high;
    for (std::size_t i = 0; i < parts_.size(); ++i)
      tree.look_at_meeting(enlarged(box_of(tree.certified(i)), gap), [&](std::size_t j) {
        if (i < j) pairs.push_back({i, j});
      });
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
    const Rational& gap =
        forbidden || OPLUS_MUTANT("layouts-have-one-margin", "parts keep the margin to each other")
            ? rules_.margin
            : rules_.spacing;
    const bool do_meet = interiors_meet(p.boundary, q.shape.boundary,
                                        forbidden ? q.at : q.at - parts_[*pair.other].at);
    if (!do_meet && sgn(gap) == 0) return;
    if (!do_meet) {
      const SegmentTree& of_p = forbidden ? p.boundary.pieces : parts_[*pair.other].edges();
      NearestPoints nearest = nearest_points(of_p, q.edges());
      const Rational most = unit_.of(gap);
      if (nearest.squared_distance < most * most ||
          OPLUS_MUTANT("layouts-count-boxes-as-near", "parts whose boxes are near are too near"))
        fault(NearestPoints{unit_.back(unit_.back(nearest.squared_distance)),
                            unit_.back(nearest.on_p), unit_.back(nearest.on_q)});
      return;
    }
    const Region of_q = translated(q.shape.region, sheet_.parts[pair.part].at);
    const Region of_p =
        forbidden ? forbidden->region : translated(p.region, sheet_.parts[*pair.other].at);
    std::optional<Overlap> way_out = way_out_of(of_p, of_q);
    const Rational forgiven = OPLUS_MUTANT("layouts-forgive-by-the-square",
                                           "the square of a depth is compared with the tolerance")
                                  ? rules_.tolerance
                                  : Rational(rules_.tolerance * rules_.tolerance);
    if (!way_out || way_out->squared_depth > forgiven)
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
    const Region common = complement(united(together(complement(p), complement(q))));
    return {point_inside(boundary_pieces(common)), oplus::area(common), std::move(way_out)};
  }

  Rational area() const {
    if (sheet_.container) {
      Region outside = outside_;
      for (const DefectiveZone& defect : sheet_.defects)
        outside = together(std::move(outside), defect.region);
      return -oplus::area(united(outside));
    }
    if (parts_.empty()) return 0;
    const ExactBox all = box();
    return (all.high.x - all.low.x) * (all.high.y - all.low.y);
  }

  const Sheet& sheet_;
  const LayoutRules& rules_;
  const unsigned threads_;
  const Unit unit_;
  const Region outside_;  ///< of the container; empty where there is none
  std::vector<std::unique_ptr<Shape>> shapes_;
  std::vector<Body> parts_;
  std::map<std::optional<int>, std::unique_ptr<Forbidden>> forbidden_;
};

}  // namespace

SheetVerdict check(const Sheet& sheet, const LayoutRules& rules, unsigned threads) {
  return SheetCheck(sheet, rules, threads).run();
}

}  // namespace oplus
