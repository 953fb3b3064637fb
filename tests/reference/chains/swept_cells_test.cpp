// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/chains/swept_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "reference/definitions/cut_at_intersections.hpp"
#include "tests/reference/chains/random_segments.hpp"
#include "tests/reference/definitions/print.hpp"

namespace oplus {
namespace {

TEST(SweptCells, pieces_are_those_of_all_pairs) {
  Random random(21);
  for (int i = 0; i < 3000; ++i) {
    const std::vector<Segment> segments = random_segments(random);
    ASSERT_EQ(swept_pieces(segments), cut_at_intersections(segments))
        << testing::PrintToString(segments);
  }
}

TEST(SweptCells, are_those_of_all_pairs) {
  Random random(25);
  for (int i = 0; i < 3000; ++i) {
    const std::vector<Segment> segments = random_segments(random);
    const Cells swept = swept_cells(segments), expected = cells(segments);
    const std::string of = testing::PrintToString(segments);
    ASSERT_EQ(swept.vertices, expected.vertices) << of;
    ASSERT_EQ(swept.faces, expected.faces) << of;
    ASSERT_EQ(swept.edges.size(), expected.edges.size()) << of;
    for (std::size_t e = 0; e < swept.edges.size(); ++e) {
      const Cells::Edge &a = swept.edges[e], &b = expected.edges[e];
      ASSERT_EQ(a.segment, b.segment) << of;
      ASSERT_EQ(std::pair(a.source, a.target), std::pair(b.source, b.target)) << of;
      ASSERT_EQ(std::pair(a.left_face, a.right_face), std::pair(b.left_face, b.right_face)) << of;
    }
  }
}

TEST(NumberedCells, are_those_of_all_pairs) {
  Random random(26);
  for (int i = 0; i < 3000; ++i) {
    const std::vector<Segment> segments = random_segments(random);
    const std::string of = testing::PrintToString(segments);
    SweptEdges swept;
    for (const Segment& s : segments) swept.add(s);
    std::vector<Point> places;
    const NumberedCells numbered =
        numbered_cells(swept, [&](const SweptPlace& place) { places.push_back(place.point); });
    // Of each edge, pieces from its smaller end to its larger one.
    std::vector<std::vector<Segment>> pieces(segments.size());
    std::map<Segment, std::pair<std::size_t, std::size_t>> edges;
    for (const auto& [from, to, above, below, edge] : numbered.pieces) {
      const Segment piece{places[from], places[to]};
      pieces[edge].push_back(piece);
      const std::pair<std::size_t, std::size_t> faces(above, below);
      ASSERT_EQ(edges.try_emplace(piece, faces).first->second, faces) << of;
    }
    const Cells expected = cells(segments);
    ASSERT_EQ(numbered.face_count, expected.faces.size()) << of;
    ASSERT_EQ(edges.size(), expected.edges.size()) << of;
    for (const Cells::Edge& e : expected.edges)
      ASSERT_EQ(edges.at(e.segment), std::pair(e.left_face, e.right_face)) << of;
    const std::vector<std::vector<Segment>> cut = cut_at_intersections(segments);
    for (std::size_t e = 0; e < segments.size(); ++e) {
      std::vector<Segment> along = pieces[e];
      if (segments[e].target < segments[e].source) {
        std::reverse(along.begin(), along.end());
        for (Segment& piece : along) piece = reversed(piece);
      }
      ASSERT_EQ(along, cut[e]) << of;
    }
  }
}

}  // namespace
}  // namespace oplus
