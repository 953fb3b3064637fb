// SPDX-License-Identifier: GPL-3.0-or-later
// What rounding says about components and holes, against a count of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <set>
#include <utility>

#include "checked/rounding/rounding.hpp"
#include "checked/rounding/snap_rounding.hpp"
#include "checked/slide/slide.hpp"
#include "checked/verify/overlay.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/swept_cells.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/families/family.hpp"
#include "reference/families/random.hpp"
#include "reference/io/writing.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

std::vector<Segment> boundary_of(const PlanarSet& set) { return edges(regularized(set)); }

/// The connected parts of a bounded set's interior and of its complement, as sets of the cells of an arrangement
/// that contains its boundary.
struct Faces {
  std::vector<std::size_t> face_of_cell;
  std::vector<bool> is_inside;  ///< of each face
};

Faces faces_of(const PlanarSet& given, const Cells& cells) {
  const PlanarSet set = regularized(given);  // a dangling edge is not the end of a face
  const std::size_t count = cells.faces.size();
  std::vector<bool> is_inside(count, false);
  for (std::size_t i = 0; i < count; ++i)
    if (i != cells.unbounded_face)
      is_inside[i] = locate(point_inside(cells.faces[i]), set) == Location::inside;
  boost::disjoint_sets_with_storage<> sets(count);
  for (const Cells::Edge& e : cells.edges)
    if (is_inside[e.left_face] == is_inside[e.right_face])
      sets.union_set(e.left_face, e.right_face);
  Faces result;
  std::vector<std::size_t> numbers(count, count);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t& number = numbers[sets.find_set(i)];
    if (number == count) {
      number = result.is_inside.size();
      result.is_inside.push_back(is_inside[i]);
    }
    result.face_of_cell.push_back(number);
  }
  return result;
}

/// Which faces of a set and of the rounded one have a part in common.
struct Correspondence {
  Faces before;
  Faces after;
  std::size_t outside_before;
  std::size_t outside_after;
  std::set<std::pair<std::size_t, std::size_t>> pairs;
};

/// For a set and one that contains it, or is contained in it: where a component is in one of the larger set, or a hole
/// in a hole of the smaller one, and so on.
Correspondence by_common_points(const PlanarSet& set, const PlanarSet& rounded) {
  std::vector<Segment> both = boundary_of(set);
  const std::vector<Segment> edges = boundary_of(rounded);
  both.insert(both.end(), edges.begin(), edges.end());
  const Cells cells = swept_cells(both);
  Correspondence result{faces_of(set, cells), faces_of(rounded, cells), 0, 0, {}};
  result.outside_before = result.before.face_of_cell[cells.unbounded_face];
  result.outside_after = result.after.face_of_cell[cells.unbounded_face];
  for (std::size_t i = 0; i < cells.faces.size(); ++i) {
    const std::size_t a = result.before.face_of_cell[i], b = result.after.face_of_cell[i];
    if (result.before.is_inside[a] == result.after.is_inside[b]) result.pairs.emplace(a, b);
  }
  return result;
}

/// For the nearest set: where the boundary of a face, each edge of which becomes a polyline through hot pixels, winds around
/// points of the other face.
Correspondence by_moved_boundaries(const PlanarSet& set, const PlanarSet& rounded,
                                   const Rational& step) {
  const Cells cells = swept_cells(boundary_of(set));
  std::vector<Segment> all;
  std::vector<Point> points = set.isolated_vertices;
  for (const std::vector<Segment>& pieces : swept_pieces(edges(set)))
    for (const Segment& s : pieces) points.insert(points.end(), {s.source, s.target});
  const HotPixels hot(points, step);

  Correspondence result{faces_of(set, cells), {}, 0, 0, {}};
  result.outside_before = result.before.face_of_cell[cells.unbounded_face];
  std::vector<std::vector<Segment>> moved(result.before.is_inside.size());
  for (const Cells::Edge& e : cells.edges) {
    const std::vector<Point> passed = hot.passed(e.segment);
    for (std::size_t k = 1; k < passed.size(); ++k) {
      const Segment link{passed[k - 1], passed[k]};
      all.push_back(link);
      moved[result.before.face_of_cell[e.left_face]].push_back(link);
      moved[result.before.face_of_cell[e.right_face]].push_back(reversed(link));
    }
  }
  const Cells links = swept_cells(all);
  result.after = faces_of(rounded, links);
  result.outside_after = result.after.face_of_cell[links.unbounded_face];
  result.pairs.emplace(result.outside_before, result.outside_after);
  for (std::size_t i = 0; i < links.faces.size(); ++i) {
    if (i == links.unbounded_face) continue;
    const Point p = point_inside(links.faces[i]);
    for (std::size_t face = 0; face < moved.size(); ++face) {
      const int around = face == result.outside_before ? 1 : 0;
      if (winding_number(p, moved[face]) + around == 1)
        result.pairs.emplace(face, result.after.face_of_cell[i]);
    }
  }
  return result;
}

/// The changes that follow: faces that correspond, directly or by way of others, became each other.
TopologyChanges changes_in(const Correspondence& faces) {
  const std::size_t before = faces.before.is_inside.size(), after = faces.after.is_inside.size();
  boost::disjoint_sets_with_storage<> sets(before + after);
  for (const auto& [a, b] : faces.pairs) {
    EXPECT_EQ(faces.before.is_inside[a], faces.after.is_inside[b]);
    sets.union_set(a, before + b);
  }
  struct Group {
    std::size_t before = 0;
    std::size_t after = 0;
  };
  std::vector<Group> groups(before + after);
  for (std::size_t i = 0; i < before; ++i) ++groups[sets.find_set(i)].before;
  for (std::size_t i = 0; i < after; ++i) ++groups[sets.find_set(before + i)].after;
  TopologyChanges result;
  const std::size_t outside = sets.find_set(faces.outside_before);
  EXPECT_EQ(outside, sets.find_set(before + faces.outside_after));
  for (std::size_t i = 0; i < before + after; ++i) {
    const std::size_t one = sets.find_set(i);
    if (one != i) continue;
    const Group& group = groups[one];
    if (one == outside) {
      result.opened_holes += group.before - 1;
      result.new_holes += group.after - 1;
      continue;
    }
    const bool is_inside =
        i < before ? faces.before.is_inside[i] : faces.after.is_inside[i - before];
    (is_inside ? result.vanished_components : result.closed_holes) += group.after == 0 ? 1 : 0;
    (is_inside ? result.new_components : result.new_holes) += group.before == 0 ? group.after : 0;
    (is_inside ? result.joined_components : result.joined_holes) +=
        group.before > 1 ? group.before : 0;
    (is_inside ? result.split_components : result.split_holes) +=
        group.before > 0 && group.after > 1 ? 1 : 0;
  }
  return result;
}

struct Seen {
  std::size_t sets = 0;
  TopologyChanges changes;
};

void expect_what_is_said_is_true(const PlanarSet& set, Boundary boundary, const Rational& step,
                                 Side side, const std::string& which, Seen& seen) {
  const RoundedSet result = rounded(set, boundary, step, side);
  if (result.is_exact) return;
  const Correspondence faces = side == Side::nearest ? by_moved_boundaries(set, result.set, step)
                                                     : by_common_points(set, result.set);
  TopologyChanges said = result.changes;
  said.lost_edges_and_points = 0;
  const TopologyChanges counted = changes_in(faces);
  EXPECT_EQ(describe(said), describe(counted)) << which << "\n" << wkt(set);

  // The parts that are written are those that are counted.
  const auto inside = static_cast<std::size_t>(std::ranges::count(faces.after.is_inside, true));
  EXPECT_EQ(result.region.components.size(), inside) << which;
  std::size_t holes = 0;
  for (const Component& c : region_of(result.set).components) holes += c.holes.size();
  EXPECT_EQ(holes, faces.after.is_inside.size() - inside - 1) << which;

  ++seen.sets;
  seen.changes.vanished_components += counted.vanished_components;
  seen.changes.joined_components += counted.joined_components;
  seen.changes.split_components += counted.split_components;
  seen.changes.new_components += counted.new_components;
  seen.changes.closed_holes += counted.closed_holes;
  seen.changes.joined_holes += counted.joined_holes;
  seen.changes.split_holes += counted.split_holes;
  seen.changes.opened_holes += counted.opened_holes;
  seen.changes.new_holes += counted.new_holes;
}

/// Triangles with vertices on quarters, or a plate without them: components and holes touch often, and are less than a
/// step apart.
PlanarSet random_triangles(Random& random, bool are_holes) {
  ClaimedSum all;
  for (int i = 0; i < 24; ++i) {
    const auto number = [&](const Rational& low, int range) -> Rational {
      Rational quarters(uniform(random, 0, range), 4);
      quarters.canonicalize();
      return low + quarters;
    };
    const Point corner{number(-1, 48), number(-1, 48)};
    Chain chain;
    for (int k = 0; k < 3; ++k) chain.push_back({number(corner.x, 24), number(corner.y, 24)});
    const int turn = orientation(chain[0], chain[1], chain[2]);
    if (turn == 0) continue;
    if (turn < 0) std::swap(chain[0], chain[1]);
    all.region.components.push_back({std::move(chain), {}});
  }
  std::vector<Segment> boundary = Overlay(all, {}).boundary_of_given();
  if (are_holes) {
    for (Segment& e : boundary) e = reversed(e);
    for (Segment& e : edges(Chain{{-2, -2}, {18, -2}, {18, 18}, {-2, 18}}))
      boundary.push_back(std::move(e));
  }
  return canonical_sum(BoundaryFeatures{std::move(boundary), {}, {}});
}

const std::vector<std::pair<Side, std::string>> sides = {
    {Side::nearest, "nearest"}, {Side::contain, "contain"}, {Side::contained, "contained"}};

/// Each change that a side can make is seen, and no other one.
void expect_changes_of_side(Side side, const TopologyChanges& seen) {
  const bool shrinks = side != Side::contain, grows = side != Side::contained;
  EXPECT_EQ(seen.vanished_components > 0, shrinks);
  EXPECT_EQ(seen.split_components > 0, shrinks);
  EXPECT_EQ(seen.joined_holes > 0, shrinks);
  EXPECT_EQ(seen.opened_holes > 0, shrinks);
  EXPECT_EQ(seen.joined_components > 0, grows);
  EXPECT_EQ(seen.closed_holes > 0, grows);
  EXPECT_EQ(seen.split_holes > 0, grows);
  EXPECT_EQ(seen.new_components, 0U);
}

TEST(TopologyChanges, of_random_sets_and_of_sums_are_what_happened) {
  constexpr int rounds = 60;
  for (const auto& [side, name] : sides) {
    Random random(7);
    Seen seen;
    const Region triangle = polygon({{0, 0}, {Rational(1, 5), 0}, {0, Rational(1, 3)}});
    for (int round = 0; round < rounds; ++round) {
      const PlanarSet set = random_triangles(random, round % 2 == 1);
      const std::string which = name + " " + std::to_string(round);
      expect_what_is_said_is_true(set, Boundary::closed, 1, side, which, seen);
      for (const Boundary boundary : {Boundary::closed, Boundary::open})
        expect_what_is_said_is_true(slide_sum(region_of(set), triangle, boundary).sum, boundary, 1,
                                    side, which + " sum", seen);
    }
    EXPECT_GE(seen.sets, 3U * rounds - 5);
    expect_changes_of_side(side, seen.changes);
  }
}

TEST(TopologyChanges, of_sums_of_all_families_are_what_happened) {
  Seen seen;
  for (const Family& family : families()) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const auto [p, q] =
          generate(family, std::min(family.typical, family.smallest + 1 + seed % 2), seed);
      for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
        const PlanarSet sum = slide_sum(p, q, boundary).sum;
        Rational low = sum.outer[0][0].x, high = low;
        for (const Point& v : sum.outer[0]) low = std::min(low, v.x), high = std::max(high, v.x);
        const Rational step = (high - low) / (seed % 2 == 0 ? 7 : 40) * Rational(97, 101);
        for (const auto& [side, name] : sides)
          expect_what_is_said_is_true(sum, boundary, step, side,
                                      family.name + " " + std::to_string(seed) + " " + name, seen);
      }
    }
  }
  EXPECT_GE(seen.sets, 4 * families().size());
}

TEST(TopologyChanges, components_that_rounding_joins_through_an_edge_are_joined) {
  const PlanarSet two =
      canonical_sum(Region{{{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {}},
                            {{{Rational(5, 2), 0}, {4, 0}, {4, 2}, {Rational(5, 2), 2}}, {}}}});
  EXPECT_EQ(rounded(two, Boundary::closed, 1, Side::contain).changes,
            (TopologyChanges{.joined_components = 2}));
  // Of the hole's side: a wall that is lost between two holes.
  const Rational half(1, 2);
  const PlanarSet plate = canonical_sum(Region{
      {{{{0, 0}, {9, 0}, {9, 9}, {0, 9}},
        {{{2, 2}, {2, 4}, {4, 4}, {4, 2}}, {{4 + half, 2}, {4 + half, 4}, {6, 4}, {6, 2}}}}}});
  EXPECT_EQ(rounded(plate, Boundary::closed, 1, Side::contained).changes,
            (TopologyChanges{.joined_holes = 2}));
}

}  // namespace
}  // namespace oplus
