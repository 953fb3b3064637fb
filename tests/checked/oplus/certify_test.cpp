// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "checked/oplus/oplus.hpp"
#include "tests/reference/io/refusal.hpp"

namespace oplus {
namespace {

const ValidRegion square = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});

std::string refusal_of(const ClaimedSum& given) {
  return refusal([&] { certify(square, square, given); });
}

TEST(Certify, a_certificate_of_the_sum) {
  const std::string text =
      certify(square, square, {minkowski_sum(square, square).region().region(), {}, {}});
  EXPECT_TRUE(text.starts_with("oplus certificate 2\nclaim sum\nunit 1\nsummand p\n"));
  EXPECT_TRUE(text.ends_with("\nend\n"));
}

TEST(Certify, P_and_Q_in_their_order) {
  const ValidRegion triangle = polygon({{0, 0}, {3, 0}, {0, 3}});
  const std::string text =
      certify(triangle, square, {minkowski_sum(triangle, square).region().region(), {}, {}});
  const std::size_t of_q = text.find("summand q");
  EXPECT_EQ(text.find("0 1 2\n"), text.find("pieces 1\n") + 9);
  EXPECT_EQ(text.find("0 1 2 3\n", of_q), text.find("pieces 1\n", of_q) + 9);
}

TEST(Certify, points_are_written_in_lowest_terms) {
  const ValidRegion p = read_wkt("MULTIPOLYGON(((0 0,1 0,0 1,0 0)),((2 0,3 0,3 1,2 0)))");
  Rational two;
  two.get_num() = 4;
  two.get_den() = 2;
  ClaimedSum given;
  // One vertex is inside an edge.
  given.region.components = {{{{0, 0}, {4, 0}, {4, 1}, {3, 2}, {2, 1}, {two, 0}, {0, 2}}, {}}};
  const std::string text = certify(p, polygon({{0, 0}, {1, 0}, {0, 1}}), given);
  EXPECT_NE(text.find(" 2 0\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("4/2"), std::string::npos) << text;
}

TEST(Certify, what_is_not_the_sum_is_refused_with_the_reason) {
  EXPECT_TRUE(refusal_of({square.region(), {}, {}}).starts_with("S: it is not the sum: "));
  ClaimedSum with_point = {minkowski_sum(square, square).region().region(), {}, {{5, 5}}};
  EXPECT_TRUE(
      refusal_of(with_point).starts_with("S: it is not the sum: additional isolated vertex: "));
  with_point.isolated_vertices.push_back({7, 8});
  EXPECT_NE(refusal_of(with_point).find("at (5, 5)"), std::string::npos) << refusal_of(with_point);
}

TEST(Certify, sums_of_closed_regions_and_of_their_interiors) {
  const ValidRegion frame =
      polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}});
  const ValidRegion part = polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  const ValidSet open = minkowski_sum(frame, part, {.boundary = Boundary::open});
  ASSERT_EQ(open.isolated_vertices().size(), 1u);
  const ClaimedSum given{open.region().region(), open.dangling_edges(), open.isolated_vertices()};
  const ClaimedSum without_points{given.region, {}, {}};
  EXPECT_THROW(certify(frame, part, given), InvalidInput);
  EXPECT_NE(certify(frame, part, without_points), "");
  EXPECT_TRUE(certify(frame, part, given, Boundary::open)
                  .starts_with("oplus certificate 2\nclaim open-sum\n"));
  EXPECT_THROW(certify(frame, part, without_points, Boundary::open), InvalidInput);
  const ValidRegion flat = polygon({{0, 0}, {2, 0}, {2, 1}, {0, 1}});
  const ValidSet with_edge = minkowski_sum(frame, flat, {.boundary = Boundary::open});
  ASSERT_EQ(with_edge.dangling_edges().size(), 1u);
  EXPECT_NE(certify(frame, flat, {with_edge.region().region(), with_edge.dangling_edges(), {}},
                    Boundary::open),
            "");
}

TEST(Certify, a_vertex_may_not_repeat_the_one_before) {
  ClaimedSum given;
  given.region.components = {{{{0, 0}, {0, 0}, {2, 0}, {2, 2}, {0, 2}}, {}}};
  EXPECT_EQ(refusal_of(given),
            "S: the vertex (0, 0) twice in a row; expected an edge between them");
}

TEST(Certify, summands_are_bounded) {
  EXPECT_THROW(certify(complement(square), square, {}), InvalidInput);
}

}  // namespace
}  // namespace oplus
