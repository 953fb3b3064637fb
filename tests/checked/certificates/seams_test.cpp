// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/certificates/seams.hpp"

#include <gtest/gtest.h>

#include "checked/operations/operations.hpp"
#include "checked/slide/by_slide.hpp"
#include "properties/compare/corpus.hpp"
#include "properties/compare/grid_polygons.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/families/family.hpp"
#include "tests/checked/certificates/seams_shown.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus::certificates {
namespace {

class SeamsOfSums : public testing::Test {
 protected:
  void look_at(const Certificate& certificate, const ClaimedSum& open_set) {
    const ShownSeams shown(certificate, open_set);
    EXPECT_EQ(shown.fault, "");
    seams += shown.seams;
    usual += shown.usual;
    points_in_sums += shown.points_in_sums;
    on_edges += shown.on_edges;
    at_vertices += shown.at_vertices;
  }

  void look_at(const Region& p, const Region& q) {
    const ClaimedSum open = parts_of(by_slide(p, q, Boundary::open));
    look_at(open_certificate(p, q, open), open);
    const ClaimedSum no_fit = parts_of(oplus::no_fit(p, q, by_slide));
    look_at(no_fit_certificate(p, q, no_fit), no_fit);
    const ClaimedSum inner_fit = parts_of(oplus::inner_fit(p, q, by_slide));
    const Certificate of_inner_fit = inner_fit_certificate(p, q, inner_fit, by_slide);
    EXPECT_TRUE(of_inner_fit.outer.dangling_edges.empty());
    EXPECT_TRUE(of_inner_fit.outer.isolated_vertices.empty());
    look_at(of_inner_fit, inner_fit);
  }

  std::size_t seams = 0, usual = 0, points_in_sums = 0, on_edges = 0, at_vertices = 0;
};

TEST_F(SeamsOfSums, of_the_corpus_hold) {
  for (const CorpusPair& row : corpus()) {
    if (vertex_count(row.p) * vertex_count(row.q) > 300) continue;
    SCOPED_TRACE(row.name);
    look_at(row.p, row.q);
  }
  EXPECT_GT(on_edges, 20U);
  EXPECT_GT(at_vertices, 10U);
}

/// Where edges are parallel and vertices in line, sums of pieces have sides in common, and dangling edges with them.
TEST_F(SeamsOfSums, of_polygons_on_a_small_grid_hold) {
  const std::vector<GridPolygon> polygons = grid_polygons(3, 6);
  for (std::size_t i = 0; i < polygons.size(); i += 23) {
    for (std::size_t j = i % 7; j < polygons.size(); j += 131) {
      SCOPED_TRACE(std::to_string(i) + ", " + std::to_string(j));
      look_at(region_of(polygons[i]), region_of(polygons[j]));
    }
  }
  EXPECT_GT(seams, 1000U);
}

TEST_F(SeamsOfSums, of_all_families_hold) {
  for (const Family& family : families()) {
    SCOPED_TRACE(family.name);
    const auto [p, q] = generate(family, std::min(family.typical, family.smallest + 3), 1);
    look_at(p, q);
  }
  EXPECT_GT(points_in_sums, 100U);
  EXPECT_GT(usual, seams / 2);
}

TEST(Seams, of_an_open_set_that_is_no_sum_there_are_none) {
  const Region frame = holed(box(0, 0, 5, 5), {box(1, 1, 4, 4)}), part = polygon(box(0, 0, 3, 3));
  ClaimedSum open = parts_of(by_slide(frame, part, Boundary::open));
  ASSERT_EQ(open.isolated_vertices.size(), 1U);
  open_certificate(frame, part, open);
  open.isolated_vertices.clear();
  EXPECT_THROW(open_certificate(frame, part, open), PointOutsideSum);
}

TEST(Seams, of_an_inner_fit_are_within_what_is_written_first) {
  Certificate made;
  made.claim = Claim::inner_fit;
  made.unit = 1;
  made.outer = {polygon({{0, 0}, {1, 0}, {0, 1}}), {{{2, 0}, {3, 0}}}, {{4, 0}}};
  EXPECT_EQ(written(made).substr(0, 98),
            "oplus certificate 2\nclaim ifp\nouter 1\n0 0 1 0 0 1\nouter-edges 1\n2 0 3 0\n"
            "outer-points 1\n4 0\nunit 1\n");
}

TEST(Seams, are_written_behind_cuts_and_by_their_ends) {
  Certificate made;
  made.claim = Claim::open_sum;
  made.unit = 1;
  made.sum.pieces = {{0, 1, 2}};
  const PieceSums::Pair pair{3, 4}, other{5, 6};
  const Seam seam{{pair, DanglingEdge{1}, pair, other},
                  {{Rational(1, 2), DanglingEdge{1}}, {2, DanglingEdge{1}}, {3, other}}};
  const Seam at_vertex{{pair, other}, {{0, IsolatedVertex{7}}}};
  made.trees = {{Cut{{1, -2, 3}, seam}, pair, Cut{{1, 0, 0}, {}}, pair, other}};
  made.diagonals = {{0, 2, at_vertex}};
  const std::string text = written(made);
  EXPECT_EQ(text.substr(text.find("\nsum\n")),
            "\nsum\npoints 0\npieces 1\n0 1 2\n"
            "cut 1 -2 3 in 3 4 at 1/2 on 1 at 2 on 1 in 3 4 at 3 in 5 6\nin 3 4\n"
            "cut 1 0 0\nin 3 4\nin 5 6\n"
            "seams 1\n0 2 in 3 4 point 7 in 5 6\nend\n");
}

}  // namespace
}  // namespace oplus::certificates
