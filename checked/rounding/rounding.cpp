// SPDX-License-Identifier: MIT
#include "checked/rounding/rounding.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "checked/operations/complement.hpp"
#include "checked/operations/set_sum.hpp"
#include "checked/rounding/faces.hpp"
#include "checked/rounding/snapped_edges.hpp"
#include "checked/rounding/topology_changes.hpp"
#include "checked/slide/by_slide.hpp"
#include "checked/verify/overlay.hpp"
#include "reference/chains/frame.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/swept_cells.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/sorted_without_copies.hpp"
#include "reference/io/counted.hpp"

namespace oplus {

namespace {

void add_ends(std::vector<Point>& to, const std::vector<Segment>& segments) {
  for (const Segment& s : segments) {
    to.push_back(s.source);
    to.push_back(s.target);
  }
}

/// Room for more is of use to HotPixels only, which takes them.
std::vector<Point> sources_of(const Boundaries& boundaries, std::size_t more = 0) {
  std::vector<Point> result;
  result.reserve(boundaries.edges.size() + more);
  for (const Boundaries::Edge& e : boundaries.edges) result.push_back(*e.source);
  return result;
}

/// Edges and points: those of an open set's complement that are still in the set, or those of a closed set outside of it.
void add_features(RoundedSet& result, const PlanarSet& set, const std::vector<Segment>& dangling,
                  Boundary boundary, const Rational& step, const HotPixels& hot,
                  const SnappedEdges& snapped) {
  const std::vector<Point>& at = hot.centres();
  std::vector<Segment> links;
  std::vector<Point> centres;
  for (const Segment& s : dangling) {
    const std::vector<Point> passed = hot.passed(s);
    for (std::size_t k = 1; k < passed.size(); ++k) links.push_back({passed[k - 1], passed[k]});
    centres.push_back(passed.front());
  }
  for (const Point& p : set.isolated_vertices) centres.push_back(nearest_grid_point(p, step));
  if (boundary == Boundary::open) {
    for (const NumberedEdge& e : snapped.thin) links.push_back({at[e.from], at[e.to]});
    for (const std::uint32_t p : snapped.points) centres.push_back(at[p]);
  }
  if (links.empty() && centres.empty()) return;
  const Location wanted = boundary == Boundary::open ? Location::inside : Location::outside;
  const Overlay around(given(result.set), {});
  const auto stays = [&](const Point& p) { return around.locate(p).of_given == wanted; };
  const auto link_stays = [&](const Segment& s) { return stays(midpoint(s.source, s.target)); };
  for (const Segment& s : set.dangling_edges) {
    const std::vector<Point> passed = hot.passed(s);
    bool is_kept = stays(passed.front());
    for (std::size_t k = 1; k < passed.size(); ++k)
      is_kept = is_kept || link_stays({passed[k - 1], passed[k]});
    result.changes.lost_edges_and_points += is_kept ? 0 : 1;
  }
  for (const Point& p : set.isolated_vertices)
    result.changes.lost_edges_and_points += stays(nearest_grid_point(p, step)) ? 0 : 1;
  std::erase_if(links, [&](const Segment& s) { return !link_stays(s); });
  const SegmentTree tree(links);
  std::vector<Point> isolated;
  for (Point& p : sorted_without_copies(std::move(centres)))
    if (stays(p) && !lies_on_one(p, tree)) isolated.push_back(std::move(p));
  result.set.dangling_edges = maximal_segments(std::move(links));
  result.set.isolated_vertices = std::move(isolated);
}

RoundedSet nearest(const PlanarSet& set, Boundary boundary, const Rational& step) {
  std::optional<Boundaries> boundaries = boundaries_of(set);
  std::vector<Segment> dangling;
  for (const std::vector<Segment>& pieces : swept_pieces(set.dangling_edges))
    dangling.insert(dangling.end(), pieces.begin(), pieces.end());
  std::vector<Point> points =
      sources_of(*boundaries, 2 * dangling.size() + set.isolated_vertices.size());
  add_ends(points, dangling);
  points.insert(points.end(), set.isolated_vertices.begin(), set.isolated_vertices.end());
  const HotPixels hot(std::move(points), step);
  SnappedEdges snapped(*boundaries, hot);
  RoundedSet result;
  result.set = set_bounded_by(hot.centres(), snapped.left);
  result.changes = changes_by_snapping(*boundaries, snapped, hot.centres(), result.set);
  boundaries.reset();
  snapped.links = {};
  add_features(result, set, dangling, boundary, step, hot, snapped);
  result.region = region_with_connected_interiors(hot.centres(), std::move(snapped.left));
  return result;
}

Region square_of(const Rational& half) {
  return polygon({{-half, -half}, {half, -half}, {half, half}, {-half, half}});
}

/// The region of a set, and edges and points, grown so that the result contains them also when it is rounded.
PlanarSet grown(PlanarSet set, const PlanarSet& features, const Rational& step) {
  const Rational half =
      step /
      (OPLUS_MUTANT(
           "rounding-grows-by-half-as-much",
           "before a set is rounded to one that contains it, it grows by a quarter of a step "
           "instead of half of one")
           ? 4
       : OPLUS_MUTANT("rounding-grows-by-twice-as-much",
                      "before a set is rounded to one that contains it, it grows by a whole step")
           ? 1
           : 2);
  set.dangling_edges = features.dangling_edges;
  set.isolated_vertices = features.isolated_vertices;
  return set_sum(set, canonical_sum(square_of(half)), Boundary::closed, by_slide);
}

RoundedSet snapped(const PlanarSet& set, const Rational& step) {
  const Boundaries boundaries = boundaries_of(set);
  const HotPixels hot(sources_of(boundaries), step);
  std::vector<NumberedEdge> left = SnappedEdges(boundaries, hot).left;
  RoundedSet result;
  result.set = set_bounded_by(hot.centres(), left);
  result.region = region_with_connected_interiors(hot.centres(), std::move(left));
  return result;
}

const PlanarSet& features_if(bool wanted, const PlanarSet& set) {
  static const PlanarSet none;
  return wanted ? set : none;
}

RoundedSet contain(const PlanarSet& set, Boundary boundary, const Rational& step) {
  RoundedSet result =
      snapped(grown(set, features_if(boundary == Boundary::closed, set), step), step);
  result.changes = changes_by_containment(set, result.set, true);
  if (boundary == Boundary::open)
    result.changes.lost_edges_and_points = set.dangling_edges.size() + set.isolated_vertices.size();
  return result;
}

/// The complement of what contains the complement, both in a frame.
RoundedSet contained(const PlanarSet& set, Boundary boundary, const Rational& step) {
  const bool has_features =
      boundary == Boundary::open &&
      !OPLUS_MUTANT("contained-covers-what-just-fits",
                    "rounded inwards, an open sum has no regard to its edges and points");
  const PlanarSet around =
      unframed(grown(framed(complement(set), 8 * step), features_if(has_features, set), step));
  RoundedSet result = snapped(complement(around), step);
  result.changes = changes_by_containment(set, result.set, false);
  return result;
}

/// Of an unbounded set: the component without an outer chain is the last one.
Region unbounded_region(const PlanarSet& set, const Rational& step) {
  const PlanarSet in_frame = framed(set, step);
  const Point& corner = in_frame.outer.front().front();
  Region region = with_connected_interiors(region_of(in_frame));
  const auto outermost = std::ranges::find_if(region.components, [&](const Component& component) {
    return std::ranges::count(component.outer, corner) > 0;
  });
  outermost->outer.clear();
  std::rotate(outermost, outermost + 1, region.components.end());
  return region;
}

RoundedSet rounded_complement(const PlanarSet& set, Boundary boundary, const Rational& step,
                              Side side) {
  const Side turned = side == Side::contain     ? Side::contained
                      : side == Side::contained ? Side::contain
                                                : side;
  RoundedSet result =
      rounded(complement(set), boundary == Boundary::open ? Boundary::closed : Boundary::open, step,
              turned);
  result.set = complement(result.set);
  result.region = unbounded_region(result.set, step);
  const TopologyChanges of = result.changes;
  result.changes = {
      .vanished_components = of.closed_holes,
      // Holes of the complement that open to its outside, and the unbounded component.
      .joined_components = of.joined_holes + of.opened_holes + (of.opened_holes > 0 ? 1 : 0),
      .split_components = of.split_holes,
      .new_components = of.new_holes,
      .closed_holes = of.vanished_components,
      .joined_holes = of.joined_components,
      .split_holes = of.split_components,
      .opened_holes = 0,
      .new_holes = of.new_components,
      .lost_edges_and_points = of.lost_edges_and_points};
  return result;
}

}  // namespace

RoundedSet rounded(const PlanarSet& set, Boundary boundary, const Rational& step, Side side) {
  const auto are_on_grid = [&](const std::vector<Point>& points) {
    return std::ranges::all_of(points, [&](const Point& p) { return is_on_grid(p, step); });
  };
  std::vector<Point> ends = set.isolated_vertices;
  add_ends(ends, set.dangling_edges);
  if (are_on_grid(ends) && std::ranges::all_of(set.outer, are_on_grid) &&
      std::ranges::all_of(set.holes, are_on_grid)) {
    RoundedSet result;
    result.set = set;
    if (set.is_unbounded) {
      result.region = unbounded_region(set, step);
    } else {
      result.region = with_connected_interiors(region_of(set));
    }
    return result;
  }
  RoundedSet result = set.is_unbounded        ? rounded_complement(set, boundary, step, side)
                      : side == Side::nearest ? nearest(set, boundary, step)
                      : side == Side::contain ? contain(set, boundary, step)
                                              : contained(set, boundary, step);
  result.is_exact = false;
  result.bound = side == Side::nearest ? step / 2 : step;
  return result;
}

std::string describe(const TopologyChanges& changes) {
  std::string text;
  const auto say_of = [&](std::size_t count, const std::string& one, const std::string& many,
                          const std::string& what) {
    if (count == 0) return;
    text += (text.empty() ? "" : ", ") + counted(count, one, many) + ' ' + what;
  };
  const auto say = [&](std::size_t count, const std::string& one, const std::string& what) {
    say_of(count, one, one + "s", what);
  };
  say(changes.vanished_components, "component", "vanished");
  say(changes.joined_components, "component", "joined");
  say(changes.split_components, "component", "came apart");
  say(changes.new_components, "component", "new");
  say(changes.closed_holes, "hole", "closed");
  say(changes.joined_holes, "hole", "joined");
  say(changes.split_holes, "hole", "came apart");
  say(changes.opened_holes, "hole", "opened to the outside");
  say(changes.new_holes, "hole", "new");
  say_of(changes.lost_edges_and_points, "dangling edge or isolated vertex",
         "dangling edges or isolated vertices", "lost");
  return text;
}

}  // namespace oplus
