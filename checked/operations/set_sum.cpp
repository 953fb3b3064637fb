// SPDX-License-Identifier: MIT
#include "checked/operations/set_sum.hpp"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <map>
#include <memory>
#include <utility>

#include "checked/collision/collision_test.hpp"
#include "checked/collision/segment_tree.hpp"
#include "checked/operations/winding_sweep.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/definitions/exact_box.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/sorted_without_copies.hpp"

namespace oplus {

namespace {

/// The boundary of a region summed with a segment: each edge at that end of the segment which is further
/// to its right, and where the end changes, a copy of the segment at the vertex. While a point x - s(t)
/// moves along x - s, it enters the region where it passes an edge of the first kind from right to left;
/// so this chain winds around x as often as the region and x - s have common pieces, for each x in no
/// special position.
Chain swept_along(const Chain& chain, const Segment& s) {
  const std::size_t n = chain.size();
  const Vector along = direction_of(s);
  std::vector<int> sides(n);
  for (std::size_t i = 0; i < n; ++i) sides[i] = sign(cross(chain[next(i, n)] - chain[i], along));
  std::size_t first = 0;
  while (sides[first] == 0) ++first;
  // An edge parallel to the segment stays with the edge before it.
  int side = sides[first];
  Chain result;
  for (std::size_t k = 1; k <= n; ++k) {
    const std::size_t i = (first + k) % n;
    const int before = side;
    if (sides[i] != 0) side = sides[i];
    const auto at_end = [&](int of_edge) { return chain[i] + (of_edge < 0 ? s.target : s.source); };
    result.push_back(at_end(before));
    if (side != before) result.push_back(at_end(side));
  }
  return result;
}

Chain parallelogram(const Segment& s, const Segment& t) {
  Chain result = {s.source + t.source, s.target + t.source, s.target + t.target,
                  s.source + t.target};
  if (sign(cross(direction_of(s), direction_of(t))) < 0) std::swap(result[1], result[3]);
  return result;
}

/// The segment that is the sum of two parallel ones.
Segment sum_of_parallel(const Segment& s, const Segment& t) {
  const auto [s_low, s_high] = std::minmax(s.source, s.target);
  const auto [t_low, t_high] = std::minmax(t.source, t.target);
  return {s_low + t_low, s_high + t_high};
}

/// Adds the sums of a region with each edge and point of the other set.
void add_moved_along(const PlanarSet& region, const PlanarSet& set, SweptSets& sets) {
  for (const Point& p : set.isolated_vertices) sets.add(region, p);
  for (const Segment& s : set.dangling_edges) {
    if (OPLUS_MUTANT("regions-jump-along-edges",
                     "a region summed with an edge is only at the ends of the edge")) {
      sets.add(region, s.source);
      sets.add(region, s.target);
      continue;
    }
    for (const std::vector<Chain>* chains : {&region.outer, &region.holes})
      for (const Chain& chain : *chains) sets.add(swept_along(chain, s));
  }
}

/// Subtracts the region at ends that edges have in common, so that one winding number counts the common
/// pieces of the region and x - e for edges e that make a tree, not for each e: most edges of the copies
/// at common ends are then away, and with them most of the arrangement.
void subtract_at_common_ends(const PlanarSet& region, const PlanarSet& set, SweptSets& sets) {
  boost::disjoint_sets_with_storage<> trees(set.dangling_edges.size());
  std::map<Point, std::size_t> first_at;
  for (std::size_t i = 0; i < set.dangling_edges.size(); ++i) {
    for (const Point* end : {&set.dangling_edges[i].source, &set.dangling_edges[i].target}) {
      const std::size_t first = first_at.emplace(*end, i).first->second;
      if (trees.find_set(first) == trees.find_set(i) &&
          !OPLUS_MUTANT("cycles-of-edges-are-trees",
                        "a region is subtracted also where edges close a cycle"))
        continue;
      if (first == i) continue;
      trees.union_set(first, i);
      sets.subtract(region, *end);
    }
  }
}

/// Adds the sums of edges and points with edges and points.
void add_sums_of_edges_and_points(const PlanarSet& p, const PlanarSet& q, SweptSets& sets) {
  for (const Point& a : p.isolated_vertices) {
    for (const Point& b : q.isolated_vertices) sets.points.push_back(a + b);
    for (const Segment& t : q.dangling_edges) sets.segments.push_back({a + t.source, a + t.target});
  }
  for (const Segment& s : p.dangling_edges) {
    for (const Point& b : q.isolated_vertices)
      sets.segments.push_back({s.source + b, s.target + b});
    for (const Segment& t : q.dangling_edges) {
      if (sign(cross(direction_of(s), direction_of(t))) != 0)
        sets.add(parallelogram(s, t));
      else
        sets.segments.push_back(sum_of_parallel(s, t));
    }
  }
}

/// Whether x is in the sum of a region's interior with the edges and points of a set.
class NearEdges {
 public:
  NearEdges(const PlanarSet& region, const PlanarSet& set)
      : region_(region.outer.empty() ? Region{} : region_of(region)),
        edges_(edges(region_)),
        tree_(edges_and_points(set)) {
    if (!edges_.empty()) box_ = box_around(edges(region_));
  }

  bool meets_interior_at(const Point& x) const {
    if (edges_.empty() || tree_.empty()) return false;
    bool meets = false;
    tree_.look_at_meeting(
        box_of(interval(Segment{x - box_->high, x - box_->low})), [&](std::size_t i) {
          meets = meets || meets_interior({x - tree_[i].source, x - tree_[i].target});
        });
    return meets;
  }

 private:
  bool meets_interior(const Segment& s) const {
    if (s.source == s.target) return locate(s.source, region_) == Location::inside;
    const std::vector<Segment> pieces = cut_where_met(s, edges_);
    return std::any_of(pieces.begin(), pieces.end(), [&](const Segment& piece) {
      return locate(midpoint(piece.source, piece.target), region_) == Location::inside;
    });
  }

  static std::vector<Segment> edges_and_points(const PlanarSet& set) {
    std::vector<Segment> result = set.dangling_edges;
    for (const Point& p : set.isolated_vertices) result.push_back({p, p});
    return result;
  }

  Region region_;
  SegmentTree edges_;
  SegmentTree tree_;
  std::optional<ExactBox> box_;
};

/// Decides, by its definition, what is in an open sum.
class OpenSum {
 public:
  OpenSum(const PlanarSet& p, const PlanarSet& q) : p_along_q_(p, q), q_along_p_(q, p) {
    if (!p.outer.empty() && !q.outer.empty())
      interiors_ = hierarchy_collision(region_of(p), region_of(q));
  }

  bool contains(const Point& x) const {
    return p_along_q_.meets_interior_at(x) || q_along_p_.meets_interior_at(x) ||
           (interiors_ && interiors_->interiors_meet_at(x));
  }

 private:
  NearEdges p_along_q_, q_along_p_;
  std::unique_ptr<CollisionTest> interiors_;
};

PlanarSet closed_sum(const PlanarSet& p, const PlanarSet& q, const PlanarSet& of_regions) {
  SweptSets sets;
  sets.add(of_regions);
  for (const auto& [region, set] : {std::pair(&p, &q), {&q, &p}}) {
    if (region->outer.empty()) continue;
    add_moved_along(*region, *set, sets);
    if (!OPLUS_MUTANT("regions-jump-along-edges")) subtract_at_common_ends(*region, *set, sets);
  }
  add_sums_of_edges_and_points(p, q, sets);
  return closed_set(std::move(sets));
}

/// Adds, back and forth, the edges of a set at each point in which chains of a region touch, as often as they
/// are there: an edge of the set may pass between the chains, and no chain of the sum shows it.
void add_at_touching_points(const PlanarSet& of_region, const PlanarSet& set, SweptSets& sets) {
  if (of_region.outer.empty() || set.dangling_edges.empty()) return;
  const Region region = region_of(of_region);
  std::map<Point, int> times;
  for (const Point& p : touching_points(region)) times.emplace(p, 0);
  if (times.empty()) return;
  for (const Segment& piece : boundary_pieces(region))
    if (const auto found = times.find(piece.source); found != times.end()) ++found->second;
  for (const auto& [p, n] : times)
    for (const Segment& s : set.dangling_edges) sets.add_both_ways({s.source + p, s.target + p}, n);
}

/// Where the sum is on all sides, its points are told from others by the definition. Where `winding` pieces
/// in common with -Q + x', for x' beside x, are all gone at x, each has its boundary at x: so only
/// such x are asked for at which enough edges meet.
PlanarSet open_sum(const PlanarSet& p, const PlanarSet& q, const PlanarSet& of_regions) {
  SweptSets sets;
  sets.add(of_regions);
  for (const Segment& e : of_regions.dangling_edges) sets.add_both_ways(e, 1);
  sets.points = of_regions.isolated_vertices;
  for (const auto& [region, set] : {std::pair(&p, &q), {&q, &p}}) {
    add_moved_along(*region, *set, sets);
    add_at_touching_points(*region, *set, sets);
  }
  sets.merge(true);

  const OpenSum open_sum(p, q);
  BoundaryFeatures features;
  sweep_windings(
      sets,
      [&](const SweptPiece& piece) {
        if ((piece.left > 0) != (piece.right > 0))
          features.edges.push_back(piece.left > 0 ? piece.segment : reversed(piece.segment));
        else if (piece.right <= piece.back &&
                 !OPLUS_MUTANT("open-sets-lose-edges",
                               "an open sum of sets with edges and points has no dangling edge") &&
                 !open_sum.contains(midpoint(piece.segment.source, piece.segment.target)))
          features.dangling_edges.push_back(piece.segment);
      },
      [&](const SweptPoint& point) {
        const bool many_edges = 2 * point.most <= point.ends + (point.ends > 4 ? 2 : 0);
        if (point.least > 0 && (many_edges || point.is_given) && !open_sum.contains(point.point))
          features.isolated_vertices.push_back(point.point);
      });
  std::vector<Point> ends;
  for (const Segment& e : features.dangling_edges) {
    ends.push_back(e.source);
    ends.push_back(e.target);
  }
  ends = sorted_without_copies(std::move(ends));
  std::erase_if(features.isolated_vertices,
                [&](const Point& v) { return std::binary_search(ends.begin(), ends.end(), v); });
  return canonical_sum(features);
}

}  // namespace

PlanarSet set_sum(const PlanarSet& p, const PlanarSet& q, Boundary boundary, const SumOf& sum) {
  PlanarSet of_regions;
  if (!p.outer.empty() && !q.outer.empty()) of_regions = sum(region_of(p), region_of(q), boundary);
  if (!has_edge_or_point(p) && !has_edge_or_point(q)) return of_regions;
  return boundary == Boundary::closed ? closed_sum(p, q, of_regions) : open_sum(p, q, of_regions);
}

}  // namespace oplus
