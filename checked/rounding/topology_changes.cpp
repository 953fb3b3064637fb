// SPDX-License-Identifier: MIT
#include "checked/rounding/topology_changes.hpp"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "reference/chains/plane_sweep.hpp"
#include "reference/definitions/cells.hpp"

namespace oplus {

namespace {

/// Counts of one kind of faces.
struct FaceChanges {
  std::size_t vanished = 0;
  std::size_t joined = 0;
  std::size_t split = 0;
  std::size_t with_outside = 0;
  std::size_t new_ones = 0;
};

/// Faces of one kind, components or those of the complement, before and after, and which of them became each other.
class Faces {
 public:
  Faces(std::size_t before, std::size_t after)
      : before_(before), after_(after), sets_(before + after) {}

  void join_two_before(std::size_t a, std::size_t b) { sets_.union_set(a, b); }
  void join(std::size_t before, std::size_t after) { sets_.union_set(before, before_ + after); }

  /// Of the outside, what became one with it, or was cut off.
  FaceChanges changes(std::optional<std::size_t> outside) {
    struct Group {
      std::size_t before = 0;
      std::size_t after = 0;
    };
    std::vector<Group> groups(before_ + after_);
    for (std::size_t f = 0; f < before_; ++f) ++groups[sets_.find_set(f)].before;
    for (std::size_t f = 0; f < after_; ++f) ++groups[sets_.find_set(before_ + f)].after;
    FaceChanges result;
    if (outside) {
      Group& around = groups[sets_.find_set(*outside)];
      result.with_outside = around.before - 1;
      result.new_ones = around.after - 1;
      around = {};
    }
    for (const auto& [before, after] : groups) {
      if (before == 0) result.new_ones += after;
      if (after == 0) result.vanished += before;
      if (before > 1) result.joined += before;
      if (before > 0 && after > 1) ++result.split;
    }
    return result;
  }

 private:
  std::size_t before_;
  std::size_t after_;
  boost::disjoint_sets_with_storage<> sets_;
};

struct FacesOfBothKinds {
  FacesOfBothKinds(const Boundaries& before, const Boundaries& after)
      : components(before.component_count, after.component_count),
        complement(before.hole_count + 1, after.hole_count + 1),
        outside(before.hole_count) {
    complement.join(before.hole_count, after.hole_count);
  }

  TopologyChanges changes() {
    const FaceChanges of_components = components.changes(std::nullopt);
    const FaceChanges of_complement = complement.changes(outside);
    return {.vanished_components = of_components.vanished,
            .joined_components = of_components.joined,
            .split_components = of_components.split,
            .new_components = of_components.new_ones,
            .closed_holes = of_complement.vanished,
            .joined_holes = of_complement.joined,
            .split_holes = of_complement.split,
            .opened_holes = of_complement.with_outside,
            .new_holes = of_complement.new_ones};
  }

  Faces components;
  Faces complement;
  std::size_t outside;
};

/// Given how often links of a segment have a face on their left, counted with the sign of the direction: joins the faces
/// that are beside it once the others became thin, and returns one of them.
std::optional<std::uint32_t> join_faces(std::vector<std::pair<std::uint32_t, int>> turns,
                                        Faces& faces) {
  std::ranges::sort(turns);
  std::optional<std::uint32_t> first;
  for (std::size_t i = 0; i < turns.size();) {
    const std::uint32_t face = turns[i].first;
    int sum = 0;
    for (; i < turns.size() && turns[i].first == face; ++i) sum += turns[i].second;
    if (sum == 0) continue;
    if (first) faces.join_two_before(*first, face);
    first = face;
  }
  return first;
}

/// A link that is left, and the faces beside it, before it was moved.
struct LeftLink {
  NumberedEdge between;
  std::uint32_t left;
  std::uint32_t right;
};

/// Requires: links are sorted.
const LeftLink& first_link_of(const Boundaries::Edge& piece, const std::vector<LeftLink>& links,
                              const std::vector<Point>& centres) {
  const auto source = static_cast<std::uint32_t>(std::ranges::lower_bound(centres, *piece.source) -
                                                 centres.begin());
  const auto first = std::ranges::lower_bound(links, source, {},
                                              [](const LeftLink& one) { return one.between.from; });
  auto last = first;
  while (last != links.end() && last->between.from == source) ++last;
  if (last - first == 1) return *first;
  const Vector along = direction_of(piece.segment());
  for (auto link = first; link != last; ++link) {
    const Vector direction = centres[link->between.to] - *piece.source;
    if (sgn(cross(along, direction)) == 0 && sgn(dot(along, direction)) > 0) return *link;
  }
  throw std::logic_error("edges cross that were rounded");
}

/// The boundary of each component, or of each hole, the face to the left.
std::vector<std::vector<Segment>> boundaries_of_components(const Boundaries& set) {
  std::vector<std::vector<Segment>> result(set.component_count);
  for (const Boundaries::Edge& e : set.edges) result[e.left].push_back(e.segment());
  return result;
}

std::vector<std::vector<Segment>> boundaries_of_holes(const Boundaries& set) {
  std::vector<std::vector<Segment>> result(set.hole_count);
  for (const Boundaries::Edge& e : set.edges)
    if (e.right < set.hole_count) result[e.right].push_back(reversed(e.segment()));
  return result;
}

/// The number of the component of a set, or of the face of its complement, around a point inside each of the given faces;
/// empty where there is none. Requires: none of these points is on the set's boundary.
std::vector<std::optional<std::size_t>> faces_around(const std::vector<std::vector<Segment>>& faces,
                                                     const Boundaries& set, bool are_components) {
  std::vector<Point> points;
  for (const std::vector<Segment>& boundary : faces) points.push_back(point_inside(boundary));
  SweptEdges edges;
  for (const Point& p : points) edges.add(p);
  for (const Boundaries::Edge& e : set.edges) {
    const auto first = static_cast<std::uint32_t>(edges.points.size());
    edges.points.insert(edges.points.end(), {e.source, e.target});
    edges.edges.push_back({first, first + 1});
  }
  std::vector<std::optional<std::size_t>> result(points.size());
  sweep(edges, [&](const SweptPlace& place) {
    for (const std::uint32_t point : place.points) {
      if (point >= points.size()) continue;
      const std::optional<std::uint32_t> edge = place.below;
      const bool is_in_set = edge && edges.runs_right(*edge);
      if (is_in_set != are_components) continue;
      result[point] = !edge       ? set.hole_count
                      : is_in_set ? set.edges[*edge].left
                                  : set.edges[*edge].right;
    }
    return true;
  });
  return result;
}

}  // namespace

TopologyChanges changes_by_snapping(const Boundaries& before, const SnappedEdges& snapped,
                                    const std::vector<Point>& centres, const PlanarSet& after) {
  const Boundaries now = boundaries_of(after);
  FacesOfBothKinds faces(before, now);
  std::vector<LeftLink> links;
  links.reserve(snapped.left.size());
  each_group(snapped.links, [&](std::span<const Link> group) {
    std::vector<std::pair<std::uint32_t, int>> of_components, of_complement;
    for (const Link& one : group) {
      of_components.emplace_back(before.edges[one.edge].left, one.forth ? 1 : -1);
      of_complement.emplace_back(before.edges[one.edge].right, one.forth ? -1 : 1);
    }
    const auto left = join_faces(std::move(of_components), faces.components);
    const auto right = join_faces(std::move(of_complement), faces.complement);
    const int more = turns(group);
    const auto [from, to] = group.front().between;
    if (more != 0)
      links.push_back({more > 0 ? NumberedEdge{from, to} : NumberedEdge{to, from}, left.value(),
                       right.value()});
  });
  std::ranges::sort(links, {}, &LeftLink::between);
  for (const Boundaries::Edge& e : now.edges) {
    const LeftLink& link = first_link_of(e, links, centres);
    faces.components.join(link.left, e.left);
    faces.complement.join(link.right, e.right);
  }
  return faces.changes();
}

TopologyChanges changes_by_containment(const PlanarSet& before, const PlanarSet& after,
                                       bool after_contains_before) {
  const Boundaries was = boundaries_of(before), now = boundaries_of(after);
  const Boundaries& smaller = after_contains_before ? was : now;
  const Boundaries& larger = after_contains_before ? now : was;
  FacesOfBothKinds faces(was, now);
  const auto join = [&](Faces& of, std::size_t in_smaller, std::size_t in_larger) {
    if (after_contains_before)
      of.join(in_smaller, in_larger);
    else
      of.join(in_larger, in_smaller);
  };
  const auto in_larger = faces_around(boundaries_of_components(smaller), larger, true);
  for (std::size_t c = 0; c < in_larger.size(); ++c)
    if (in_larger[c]) join(faces.components, c, *in_larger[c]);
  const auto in_smaller = faces_around(boundaries_of_holes(larger), smaller, false);
  for (std::size_t h = 0; h < in_smaller.size(); ++h)
    if (in_smaller[h]) join(faces.complement, *in_smaller[h], h);
  return faces.changes();
}

}  // namespace oplus
