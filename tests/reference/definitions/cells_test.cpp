// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/cells.hpp"

#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/mpq_class.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/families/random.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

using Traits = CGAL::Arr_segment_traits_2<CGAL::Simple_cartesian<Rational>>;
using Arrangement = CGAL::Arrangement_2<Traits, CGAL::Arr_face_extended_dcel<Traits, std::size_t>>;

using Boundaries = std::vector<Segment>;

/// What CGAL finds: for each edge, from its smaller end, the boundaries of the faces to its left and to
/// its right, sorted; the unbounded one is told by itself.
struct Found {
  std::map<Segment, std::pair<Boundaries, Boundaries>> beside;
  std::vector<Point> vertices;
  std::size_t faces;
  Boundaries unbounded;

  friend bool operator==(const Found&, const Found&) = default;
};

Boundaries sorted(Boundaries boundary) {
  std::sort(boundary.begin(), boundary.end());
  return boundary;
}

/// Counts what the arrangements are made of, lest some kind is missing.
using Kinds = std::map<std::string, std::size_t>;

Found found_by_cgal(const std::vector<std::vector<Segment>>& pieces, Kinds& kinds) {
  std::vector<Traits::X_monotone_curve_2> curves;
  std::map<Segment, int> seen;
  for (const std::vector<Segment>& of_segment : pieces) {
    for (const Segment& s : of_segment) {
      const auto& [low, high] = std::minmax(s.source, s.target);
      if (seen[{low, high}]++ == 0)
        curves.emplace_back(Traits::Point_2(low.x, low.y), Traits::Point_2(high.x, high.y));
    }
  }
  Arrangement arrangement;
  CGAL::insert_non_intersecting_curves(arrangement, curves.begin(), curves.end());

  const auto point = [](const auto& vertex) {
    return Point{vertex->point().x(), vertex->point().y()};
  };
  std::vector<Boundaries> boundaries;
  Found found{{}, {}, arrangement.number_of_faces(), {}};
  for (auto face : arrangement.face_handles()) {
    Boundaries boundary;
    const auto add = [&](Arrangement::Ccb_halfedge_circulator first) {
      auto e = first;
      do {
        boundary.push_back({point(e->source()), point(e->target())});
      } while (++e != first);
    };
    for (auto ccb = face->outer_ccbs_begin(); ccb != face->outer_ccbs_end(); ++ccb) add(*ccb);
    for (auto ccb = face->inner_ccbs_begin(); ccb != face->inner_ccbs_end(); ++ccb) add(*ccb);
    const std::size_t holes = face->number_of_inner_ccbs();
    kinds["unbounded faces with several boundaries"] += face->is_unbounded() && holes > 1;
    kinds["faces with a hole"] += !face->is_unbounded() && holes == 1;
    kinds["faces with several holes"] += !face->is_unbounded() && holes > 1;
    if (!face->is_unbounded()) {
      for (auto ccb = face->inner_ccbs_begin(); ccb != face->inner_ccbs_end(); ++ccb) {
        const auto inside = (*ccb)->twin()->face();
        kinds["holes without a face"] += inside == face;
        kinds["holes in holes"] += inside != face && inside->number_of_inner_ccbs() > 0;
      }
    }
    face->set_data(boundaries.size());
    boundaries.push_back(sorted(std::move(boundary)));
    if (face->is_unbounded()) found.unbounded = boundaries.back();
  }
  for (auto vertex : arrangement.vertex_handles()) {
    found.vertices.push_back(point(vertex));
    ++kinds["vertices of degree " + std::to_string(std::min<std::size_t>(vertex->degree(), 5))];
  }
  std::sort(found.vertices.begin(), found.vertices.end());
  for (auto edge : arrangement.edge_handles()) {
    const auto e = point(edge->source()) < point(edge->target()) ? edge : edge->twin();
    found.beside[{point(e->source()), point(e->target())}] = {
        boundaries[e->face()->data()], boundaries[e->twin()->face()->data()]};
    kinds["edges inside a face"] += e->face() == e->twin()->face();
  }
  return found;
}

Found found_by_walks(const std::vector<std::vector<Segment>>& pieces) {
  const Cells cells = cells_of_pieces(pieces);
  Found found{{}, cells.vertices, cells.faces.size(), sorted(cells.faces[cells.unbounded_face])};
  for (const Cells::Edge& e : cells.edges) {
    EXPECT_EQ(cells.vertices[e.source], e.segment.source);
    EXPECT_EQ(cells.vertices[e.target], e.segment.target);
    found.beside[e.segment] = {sorted(cells.faces[e.left_face]), sorted(cells.faces[e.right_face])};
  }
  EXPECT_EQ(found.beside.size(), cells.edges.size());
  return found;
}

TEST(Cells, are_those_of_cgals_arrangement) {
  Random random(7);
  Kinds kinds;
  for (int i = 0; i < 3000; ++i) {
    const int side = uniform(random, 2, 16);
    std::vector<Segment> segments;
    const auto add_box = [&](int x, int y, int width, int height) {
      const Point a{x, y}, b{x + width, y}, c{x + width, y + height}, d{x, y + height};
      segments.insert(segments.end(), {{a, b}, {c, b}, {c, d}, {d, a}});
    };
    // Boxes in each other: holes in holes.
    for (int depth = uniform(random, 0, 3), at = 0; depth > 0 && at < side - at; --depth, at += 2)
      add_box(at, at, side - 2 * at, side - 2 * at);
    for (int count = uniform(random, 0, 5); count > 0; --count) {
      const int x = uniform(random, 0, side), y = uniform(random, 0, side);
      const int width = uniform(random, 1, 3), height = uniform(random, 1, 3);
      add_box(x, y, width, height);
    }
    for (int count = uniform(random, 0, 6); count > 0; --count) {
      const int x = uniform(random, 0, side), y = uniform(random, 0, side);
      const int dx = uniform(random, -3, 3), dy = uniform(random, -3, 3);
      if (dx != 0 || dy != 0) segments.push_back({{x, y}, {x + dx, y + dy}});
    }
    const std::vector<std::vector<Segment>> pieces = cut_at_intersections(segments);
    ASSERT_TRUE(found_by_walks(pieces) == found_by_cgal(pieces, kinds))
        << i << ": " << testing::PrintToString(segments);
  }
  for (const char* kind :
       {"unbounded faces with several boundaries", "faces with a hole", "faces with several holes",
        "holes without a face", "holes in holes", "edges inside a face", "vertices of degree 1",
        "vertices of degree 3", "vertices of degree 4", "vertices of degree 5"})
    EXPECT_GT(kinds[kind], 30u) << kind;
}

TEST(Cells, are_in_lexicographic_order) {
  const Cells found = cells(
      {{{5, 0}, {5, 1}}, {{0, 0}, {4, 0}}, {{4, 4}, {0, 0}}, {{4, 0}, {4, 4}}, {{3, 1}, {3, 2}}});
  EXPECT_TRUE(std::is_sorted(found.vertices.begin(), found.vertices.end()));
  ASSERT_EQ(found.faces.size(), 2u);
  EXPECT_EQ(found.unbounded_face, 0u);
  const std::vector<Segment> inner{
      {{0, 0}, {4, 0}}, {{4, 0}, {4, 4}}, {{4, 4}, {0, 0}}, {{3, 1}, {3, 2}}, {{3, 2}, {3, 1}}};
  EXPECT_EQ(found.faces[1], inner);
}

TEST(Cells, without_a_segment_are_the_plane) {
  const Cells plane = cells({});
  EXPECT_EQ(plane.faces, std::vector<std::vector<Segment>>(1));
  EXPECT_TRUE(plane.edges.empty());
  EXPECT_TRUE(plane.vertices.empty());
}

}  // namespace
}  // namespace oplus
