// SPDX-License-Identifier: MIT
#include "checked/rounding/rounding.hpp"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "checked/rounding/snap_rounding.hpp"
#include "checked/slide/slide.hpp"
#include "checked/verify/grown_features.hpp"
#include "checked/verify/overlay.hpp"
#include "reference/chains/nesting.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/swept_cells.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/sorted_without_copies.hpp"
#include "reference/io/counted.hpp"

namespace oplus {

namespace {

/// A chain of a region: the number of its component, and of its hole, counted through the region; an outer chain
/// has none.
struct ChainPlace {
  std::size_t component;
  std::optional<std::size_t> hole;
};

std::vector<ChainPlace> places_of_chains(const Region& region) {
  std::vector<ChainPlace> result;
  std::size_t holes = 0;
  for (std::size_t c = 0; c < region.components.size(); ++c) {
    result.push_back({c, std::nullopt});
    for (std::size_t h = 0; h < region.components[c].holes.size(); ++h)
      result.push_back({c, holes++});
  }
  return result;
}

std::size_t hole_count(const Region& region) {
  std::size_t count = 0;
  for (const Component& component : region.components) count += component.holes.size();
  return count;
}

/// Edges with the set on the left, and the faces on both sides of each: components, and holes, after which the
/// outside has the last number.
struct Boundaries {
  std::vector<Segment> edges;
  std::vector<std::size_t> left;
  std::vector<std::size_t> right;
};

/// The face of the complement that is around a chain of a region: its own, of a hole.
std::vector<std::size_t> faces_right_of_chains(const std::vector<ChainPlace>& places,
                                               const Nesting& nesting, std::size_t outside) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::optional<std::size_t> chain = i;
    while (chain && !places[*chain].hole) chain = nesting.around(*chain);
    result.push_back(chain ? *places[*chain].hole : outside);
  }
  return result;
}

Boundaries boundaries_of(const Region& region) {
  const std::vector<const Chain*> all = chains_in(region);
  const std::vector<ChainPlace> places = places_of_chains(region);
  const std::vector<std::size_t> right =
      faces_right_of_chains(places, nesting(SweptChains(all)), hole_count(region));
  Boundaries result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (Segment& e : edges(*all[i])) {
      result.edges.push_back(std::move(e));
      result.left.push_back(places[i].component);
      result.right.push_back(right[i]);
    }
  }
  return result;
}

/// Faces of one kind, components or those of the complement, and which of them became one.
class Faces {
 public:
  explicit Faces(std::size_t count) : count_(count), sets_(count) {}

  void join(std::size_t a, std::size_t b) {
    const std::size_t of_a = sets_.find_set(a), of_b = sets_.find_set(b);
    if (of_a == of_b) return;
    sets_.link(of_a, of_b);
  }
  std::size_t one_of(std::size_t face) { return sets_.find_set(face); }
  std::size_t size() const { return count_; }

 private:
  std::size_t count_;
  boost::disjoint_sets_with_storage<> sets_;
};

/// The set to be rounded, and the faces of the given one that its edges separate.
struct Prepared {
  Boundaries boundaries;
  Faces components;
  Faces complement;
  std::size_t component_count = 0;   ///< other numbers are those of no component of the given set
  std::size_t complement_count = 0;  ///< likewise
  std::size_t outside = 0;           ///< the number of the face around all chains
};

/// What contains a region without touching its boundary, and the faces of the region that its own contain, or are
/// contained in.
Prepared prepared(const Region& region, const Region& sum) {
  // They don't touch, so that one sweep nests the chains of both.
  std::vector<const Chain*> all = chains_in(region);
  const std::size_t of_region = all.size();
  const std::vector<const Chain*> of_sum = chains_in(sum);
  all.insert(all.end(), of_sum.begin(), of_sum.end());
  const Nesting around = nesting(SweptChains(all));
  const auto innermost = [&](std::size_t chain, bool in_region) {
    std::optional<std::size_t> result = around.around(chain);
    while (result && (*result < of_region) != in_region) result = around.around(*result);
    return result;
  };
  const std::vector<ChainPlace> places = places_of_chains(region);
  const std::vector<ChainPlace> places_in_sum = places_of_chains(sum);
  const std::size_t outside = hole_count(region);
  Prepared result{{}, Faces(region.components.size() + 1), Faces(outside + 2)};
  result.component_count = region.components.size();
  result.complement_count = outside + 1;
  result.outside = outside;

  std::vector<std::optional<std::size_t>> first_in(sum.components.size());
  for (std::size_t i = 0; i < of_region; ++i) {
    if (places[i].hole) continue;
    const std::optional<std::size_t> chain = innermost(i, false);
    if (!chain) continue;
    std::optional<std::size_t>& first = first_in[places_in_sum[*chain - of_region].component];
    if (first) result.components.join(*first, places[i].component);
    first = places[i].component;
  }
  for (std::size_t i = 0; i < of_sum.size(); ++i) {
    const std::size_t component = places_in_sum[i].component;
    // The complement of the sum beside a chain is in that of the region.
    std::optional<std::size_t> chain = of_region + i;
    while (chain && (*chain < of_region || !places_in_sum[*chain - of_region].hole))
      chain = around.around(*chain);
    if (chain) chain = innermost(*chain, true);
    const std::size_t face = chain ? places[*chain].hole.value_or(outside) : outside;
    for (Segment& e : edges(*of_sum[i])) {
      result.boundaries.edges.push_back(std::move(e));
      result.boundaries.left.push_back(first_in[component].value_or(result.component_count));
      result.boundaries.right.push_back(face);
    }
  }
  return result;
}

/// How often edges run along a link forth and back, the faces on their left and right sides by number.
struct Link {
  Segment link;  ///< from its smaller end
  bool forth;
  std::size_t left;
  std::size_t right;
};

/// Counts of one kind of faces.
struct FaceChanges {
  std::size_t vanished = 0;
  std::size_t joined = 0;
  std::size_t split = 0;
  std::size_t with_outside = 0;
  std::size_t new_ones = 0;
};

/// Counts what happened to faces: `is_left[f]` where something is left of face f, `now` has the face of which each face of
/// the result is a part. Only the first `count` are faces of the given set; what became of the outside is counted apart.
FaceChanges counted_changes(Faces& faces, const std::vector<bool>& is_left,
                            const std::vector<std::size_t>& now, std::size_t count,
                            std::optional<std::size_t> outside) {
  FaceChanges result;
  std::vector<std::size_t> before(faces.size(), 0), after(faces.size(), 0);
  for (std::size_t f = 0; f < count; ++f) {
    if (f == outside) continue;
    if (!is_left[f])
      ++result.vanished;
    else if (outside && faces.one_of(f) == faces.one_of(*outside))
      ++result.with_outside;
    else
      ++before[faces.one_of(f)];
  }
  for (const std::size_t f : now) ++after[faces.one_of(f)];
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (before[f] == 0) result.new_ones += after[f];
    if (before[f] > 1) result.joined += before[f];
    if (before[f] > 0 && after[f] > 1) ++result.split;
  }
  return result;
}

/// Boundaries, rounded: links of which one more runs forth than back, or the other way round, and what happened to
/// the faces.
struct Snapped {
  std::vector<Segment> edges;  ///< of the new boundary, the set to the left; they meet at ends only
  std::vector<Segment> others;  ///< links that are on none, or on both sides in the set
  std::vector<Point> points;    ///< of chains that became points
  FaceChanges components;
  FaceChanges complement;
};

/// The simple chains around each component of the interior and the holes in it: as programs want polygons whose interior is
/// connected. Requires: edges meet at ends only.
Region region_with_connected_interiors(std::vector<Segment> edges) {
  for (Segment& e : edges) e = reversed(e);
  // Each chain of a sum bounds one face of the complement, here of the set.
  MinkowskiSum faces = canonical_sum(BoundaryFeatures{std::move(edges), {}, {}});
  MinkowskiSum turned;
  for (std::vector<Chain>* chains : {&faces.outer, &faces.holes}) {
    for (Chain& chain : *chains) {
      std::reverse(chain.begin(), chain.end());
      turned.outer.push_back(std::move(chain));
    }
  }
  Region region = region_of(turned);
  const auto start_at_smallest = [](Chain& chain) {
    std::rotate(chain.begin(),
                chain.begin() + static_cast<std::ptrdiff_t>(start_of_smallest_rotation(chain)),
                chain.end());
  };
  for (Component& component : region.components) {
    start_at_smallest(component.outer);
    std::ranges::for_each(component.holes, start_at_smallest);
    std::ranges::sort(component.holes);
  }
  std::ranges::sort(region.components, {}, &Component::outer);
  return region;
}

Snapped snapped(const Prepared& prepared, const HotPixels& hot) {
  const auto& [edges, left, right] = prepared.boundaries;
  Snapped result;
  std::vector<Link> links;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::vector<Point> passed = hot.passed(edges[i]);
    for (std::size_t k = 1; k < passed.size(); ++k) {
      const bool forth = passed[k - 1] < passed[k];
      links.push_back(
          {forth ? Segment{passed[k - 1], passed[k]} : Segment{passed[k], passed[k - 1]}, forth,
           left[i], right[i]});
    }
    result.points.push_back(passed.front());
  }
  std::sort(links.begin(), links.end(),
            [](const Link& a, const Link& b) { return a.link < b.link; });

  Faces components = prepared.components, complement = prepared.complement;
  std::vector<bool> component_is_left(components.size(), false);
  std::vector<bool> complement_is_left(complement.size(), false);
  // How often each face is beside a link, counted with the sign of the direction.
  const auto net = [](std::vector<std::pair<std::size_t, int>>& turns, std::vector<bool>& is_left,
                      Faces& faces) {
    std::sort(turns.begin(), turns.end());
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < turns.size();) {
      const std::size_t face = turns[i].first;
      int sum = 0;
      for (; i < turns.size() && turns[i].first == face; ++i) sum += turns[i].second;
      if (sum == 0) continue;
      is_left[face] = true;
      if (first) faces.join(*first, face);
      first = face;
    }
  };
  struct NewEdge {
    Segment edge;
    std::size_t left;
    std::size_t right;
  };
  std::vector<NewEdge> new_edges;
  for (std::size_t i = 0; i < links.size();) {
    const std::size_t begin = i;
    int turns = 0;
    std::vector<std::pair<std::size_t, int>> of_components, of_complement;
    for (; i < links.size() && links[i].link == links[begin].link; ++i) {
      const int turn = links[i].forth ? 1 : -1;
      turns += turn;
      of_components.emplace_back(links[i].left, turn);
      of_complement.emplace_back(links[i].right, -turn);
    }
    net(of_components, component_is_left, components);
    net(of_complement, complement_is_left, complement);
    const Segment& link = links[begin].link;
    if (turns == 0) {
      result.others.push_back(link);
      continue;
    }
    const auto remaining =
        std::find_if(links.begin() + static_cast<std::ptrdiff_t>(begin), links.end(),
                     [&](const Link& one) { return one.forth == (turns > 0); });
    new_edges.push_back({turns > 0 ? link : reversed(link), remaining->left, remaining->right});
  }
  std::vector<Point> ends;
  for (const Link& one : links) {
    ends.push_back(one.link.source);
    ends.push_back(one.link.target);
  }
  ends = sorted_without_copies(std::move(ends));
  std::erase_if(result.points,
                [&](const Point& p) { return std::binary_search(ends.begin(), ends.end(), p); });

  // Which faces those of the result are.
  std::sort(new_edges.begin(), new_edges.end(),
            [](const NewEdge& a, const NewEdge& b) { return a.edge < b.edge; });
  for (const NewEdge& e : new_edges) result.edges.push_back(e.edge);
  const auto at_start = [&](const Chain& chain) -> const NewEdge& {
    auto e = new_edges.end();
    if (chain.size() > 2) {
      const Vector along = chain[1] - chain[0];
      e = std::find_if(
          std::lower_bound(new_edges.begin(), new_edges.end(), chain[0],
                           [](const NewEdge& one, const Point& p) { return one.edge.source < p; }),
          new_edges.end(), [&](const NewEdge& one) {
            const Vector direction = direction_of(one.edge);
            return one.edge.source != chain[0] ||
                   (sgn(cross(along, direction)) == 0 && sgn(dot(along, direction)) > 0);
          });
    }
    if (e == new_edges.end() || e->edge.source != chain[0])
      throw std::logic_error("edges cross that were rounded");
    return *e;
  };
  std::vector<std::size_t> components_now, holes_now;
  for (const Component& component : region_with_connected_interiors(result.edges).components)
    components_now.push_back(at_start(component.outer).left);
  const MinkowskiSum sum = canonical_sum(BoundaryFeatures{result.edges, {}, {}});
  for (const Component& component : region_of(sum).components)
    for (const Chain& hole : component.holes) holes_now.push_back(at_start(hole).right);
  result.components = counted_changes(components, component_is_left, components_now,
                                      prepared.component_count, std::nullopt);
  result.complement = counted_changes(complement, complement_is_left, holes_now,
                                      prepared.complement_count, prepared.outside);
  return result;
}

std::vector<Point> ends_of(const std::vector<Segment>& segments) {
  std::vector<Point> result;
  result.reserve(2 * segments.size());
  for (const Segment& s : segments) {
    result.push_back(s.source);
    result.push_back(s.target);
  }
  return result;
}

void add(std::vector<Point>& to, const std::vector<Point>& points) {
  to.insert(to.end(), points.begin(), points.end());
}

void add(std::vector<Segment>& to, const std::vector<Segment>& segments) {
  to.insert(to.end(), segments.begin(), segments.end());
}

TopologyChanges changes_of(const FaceChanges& components, const FaceChanges& complement) {
  return {.vanished_components = components.vanished,
          .joined_components = components.joined,
          .split_components = components.split,
          .new_components = components.new_ones,
          .closed_holes = complement.vanished,
          .joined_holes = complement.joined,
          .split_holes = complement.split,
          .opened_holes = complement.with_outside,
          .new_holes = complement.new_ones};
}

/// Puts the boundary of what was snapped there.
void put_edges(RoundedSet& result, std::vector<Segment> edges) {
  result.set = canonical_sum(BoundaryFeatures{edges, {}, {}});
  result.region = region_with_connected_interiors(std::move(edges));
}

RoundedSet nearest(const MinkowskiSum& set, Boundary boundary, const Rational& step) {
  const Region region = region_of(set);
  const std::size_t components = region.components.size(), outside = hole_count(region);
  const Prepared prepared{.boundaries = boundaries_of(region),
                          .components = Faces(components + 1),
                          .complement = Faces(outside + 2),
                          .component_count = components,
                          .complement_count = outside + 1,
                          .outside = outside};
  std::vector<Point> points = ends_of(prepared.boundaries.edges);
  std::vector<Segment> dangling;
  for (const std::vector<Segment>& pieces : swept_pieces(set.dangling_edges)) add(dangling, pieces);
  add(points, ends_of(dangling));
  add(points, set.isolated_vertices);
  const HotPixels hot(points, step);
  Snapped all = snapped(prepared, hot);
  RoundedSet result;
  result.changes = changes_of(all.components, all.complement);
  put_edges(result, std::move(all.edges));

  // Edges and points: those of an open set's complement that are still in the set, or those of a closed set outside of
  // it.
  std::vector<Segment> links;
  std::vector<Point> centres;
  for (const Segment& s : dangling) {
    const std::vector<Point> passed = hot.passed(s);
    for (std::size_t k = 1; k < passed.size(); ++k) links.push_back({passed[k - 1], passed[k]});
    centres.push_back(passed.front());
  }
  for (const Point& p : set.isolated_vertices) centres.push_back(nearest_grid_point(p, step));
  if (boundary == Boundary::open) {
    add(links, all.others);
    add(centres, all.points);
  }
  if (links.empty() && centres.empty()) return result;
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
  return result;
}

Region square_of(const Rational& half) {
  return polygon({{-half, -half}, {half, -half}, {half, half}, {-half, half}});
}

/// Rounds a region, and the edges and points of a set, so that the result contains them.
Prepared prepared_around(const Region& region, const MinkowskiSum& features, const Rational& step) {
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
  Region sum = region_of(slide_sum(region, square_of(half), Boundary::closed).sum);
  if (!features.dangling_edges.empty() || !features.isolated_vertices.empty())
    sum = region_of(with_grown_features(sum, features, half));
  return prepared(region, sum);
}

Snapped snapped(const Prepared& prepared, const Rational& step) {
  return snapped(prepared, HotPixels(ends_of(prepared.boundaries.edges), step));
}

const MinkowskiSum& features_if(bool wanted, const MinkowskiSum& set) {
  static const MinkowskiSum none;
  return wanted ? set : none;
}

RoundedSet contain(const MinkowskiSum& set, Boundary boundary, const Rational& step) {
  RoundedSet result;
  Snapped all = snapped(
      prepared_around(region_of(set), features_if(boundary == Boundary::closed, set), step), step);
  result.changes = changes_of(all.components, all.complement);
  put_edges(result, std::move(all.edges));
  if (boundary == Boundary::open)
    result.changes.lost_edges_and_points = set.dangling_edges.size() + set.isolated_vertices.size();
  return result;
}

/// A rectangle with all points of a set more than a few steps inside it.
Chain frame_around(const std::vector<Point>& points, const Rational& step) {
  Point low = points.empty() ? Point{} : points[0], high = low;
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const Rational margin = 8 * step;
  return {{low.x - margin, low.y - margin},
          {high.x + margin, low.y - margin},
          {high.x + margin, high.y + margin},
          {low.x - margin, high.y + margin}};
}

/// The complement of what contains the complement, both in a frame.
RoundedSet contained(const MinkowskiSum& set, Boundary boundary, const Rational& step) {
  const Region region = region_of(set);
  std::vector<Segment> boundary_edges = boundary_pieces(region);
  std::vector<Point> points = ends_of(boundary_edges);
  add(points, ends_of(set.dangling_edges));
  add(points, set.isolated_vertices);
  const Chain frame = frame_around(points, step);
  for (Segment& e : boundary_edges) e = reversed(e);
  add(boundary_edges, edges(frame));
  const Region complement =
      region_of(canonical_sum(BoundaryFeatures{std::move(boundary_edges), {}, {}}));
  const bool has_features =
      boundary == Boundary::open &&
      !OPLUS_MUTANT("contained-covers-what-just-fits",
                    "rounded inwards, an open sum has no regard to its edges and points");
  Prepared around = prepared_around(complement, features_if(has_features, set), step);

  // Back again: without the frame, with the set on the left, and the outside as the last face of its complement.
  std::size_t with_frame = 0;
  for (std::size_t c = 0; c < complement.components.size(); ++c)
    if (std::ranges::count(complement.components[c].outer, frame[0]) > 0) with_frame = c;
  const std::size_t beyond_frame = hole_count(complement);
  Prepared turned{{}, std::move(around.complement), std::move(around.components)};
  turned.component_count = beyond_frame;
  turned.complement_count = complement.components.size();
  turned.outside = with_frame;
  for (std::size_t i = 0; i < around.boundaries.edges.size(); ++i) {
    if (around.boundaries.right[i] == beyond_frame) continue;
    turned.boundaries.edges.push_back(reversed(around.boundaries.edges[i]));
    turned.boundaries.left.push_back(around.boundaries.right[i]);
    turned.boundaries.right.push_back(around.boundaries.left[i]);
  }
  Snapped all = snapped(turned, step);
  RoundedSet result;
  result.changes = changes_of(all.components, all.complement);
  put_edges(result, std::move(all.edges));
  return result;
}

/// The complement, as a set of the same edges and points.
MinkowskiSum complement(const MinkowskiSum& set) {
  std::vector<Segment> all = edges(set);
  all.resize(all.size() - set.dangling_edges.size());
  BoundaryFeatures features{{}, set.dangling_edges, set.isolated_vertices};
  for (const std::vector<Segment>& pieces : swept_pieces(all))
    for (const Segment& piece : pieces) features.edges.push_back(reversed(piece));
  MinkowskiSum result = canonical_sum(features);
  result.is_unbounded = !set.is_unbounded;
  return result;
}

/// Of an unbounded set: the component without an outer chain is the last one.
Region unbounded_region(MinkowskiSum set, const Rational& step) {
  const Chain frame = frame_around(ends_of(edges(set)), step);
  set.outer.push_back(frame);
  set.is_unbounded = false;
  Region region = region_of(set);
  const auto outermost = std::ranges::find_if(region.components, [&](const Component& component) {
    return std::ranges::count(component.outer, frame[0]) > 0;
  });
  outermost->outer.clear();
  std::rotate(outermost, outermost + 1, region.components.end());
  return region;
}

RoundedSet rounded_complement(const MinkowskiSum& set, Boundary boundary, const Rational& step,
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
      // A hole of the complement that opens to its outside joins the unbounded component.
      .joined_components = of.joined_holes + of.opened_holes,
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

RoundedSet rounded(const MinkowskiSum& set, Boundary boundary, const Rational& step, Side side) {
  std::vector<Point> points = set.isolated_vertices;
  add(points, ends_of(edges(set)));
  if (std::all_of(points.begin(), points.end(),
                  [&](const Point& p) { return is_on_grid(p, step); })) {
    RoundedSet result;
    result.set = set;
    if (set.is_unbounded) {
      result.region = unbounded_region(set, step);
    } else {
      result.region = region_of(set);
      if (!touching_points(result.region).empty())
        result.region = region_with_connected_interiors(boundary_pieces(result.region));
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
