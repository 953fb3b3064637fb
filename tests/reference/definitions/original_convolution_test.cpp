// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/original_convolution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "reference/definitions/intersection_components.hpp"
#include "reference/definitions/winding_number.hpp"
#include "tests/reference/definitions/print.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

const Region l = polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
const Region u = shape("U");
const Region square = polygon(box(0, 0, 1, 1));

/// The segments of a vertex, sorted.
std::vector<Segment> of_vertex(Summand of, const VertexIndex& v,
                               const std::vector<ConvolutionSegment>& convolution) {
  std::vector<Segment> result;
  for (const ConvolutionSegment& s : convolution)
    if (s.origin.edge_of == other(of) && s.origin.vertex == v) result.push_back(s.segment);
  std::sort(result.begin(), result.end());
  return result;
}

int winding_of_original(const Point& x, const Region& p, const Region& q) {
  return winding_number(x, segments(original_convolution(p, q)));
}

TEST(OriginalConvolution, of_convex_polygons_is_the_convolution) {
  const Region diamond = polygon({{0, -1}, {1, 0}, {0, 1}, {-1, 0}});
  for (const Region& q : {square, diamond, polygon({{0, 0}, {1, 0}, {2, 0}, {0, 2}})})
    EXPECT_EQ(segments(original_convolution(square, q)), segments(convolution(square, q)));
}

TEST(OriginalConvolution, flips_the_one_segment_that_the_reflex_vertex_of_an_l_leaves_out) {
  const std::vector<Segment> flip_set{{{2, 2}, {2, 1}}};
  EXPECT_EQ(of_vertex(Summand::P, {0, 3}, original_convolution(l, square)), flip_set)
      << "upwards, equal to where the vertex goes on: an edge of Q comes after it";
  EXPECT_EQ(original_convolution(l, square).size(), convolution(l, square).size() - 3 + 1);
}

TEST(OriginalConvolution, flips_another_segment_where_the_summands_are_exchanged) {
  const std::vector<Segment> flip_set{{{1, 2}, {2, 2}}};
  EXPECT_EQ(of_vertex(Summand::Q, {0, 3}, original_convolution(square, l)), flip_set)
      << "leftwards, equal to where the vertex comes from: an edge of P comes before it";
}

TEST(OriginalConvolution, flips_what_is_between_the_edges_of_a_reflex_vertex) {
  const Region triangle = polygon({{0, 0}, {3, 0}, {-1, 3}});  // its second edge runs up and left
  EXPECT_EQ(of_vertex(Summand::P, {0, 3}, original_convolution(l, triangle)),
            (std::vector<Segment>{{{0, 4}, {4, 1}}}));
}

TEST(OriginalConvolution, flips_every_segment_that_a_reflex_vertex_leaves_out_and_none_it_has) {
  for (const Shape& p : shapes()) {
    for (const Shape& q : shapes()) {
      std::map<Origin, Segment> in_convolution, in_original;
      for (const auto& s : convolution(p.region, q.region)) in_convolution[s.origin] = s.segment;
      for (const auto& s : original_convolution(p.region, q.region)) {
        EXPECT_TRUE(in_original.emplace(s.origin, s.segment).second);
      }
      for (const auto& s : vertex_edge_sum(p.region, q.region)) {
        const bool before = in_convolution.contains(s.origin);
        ASSERT_EQ(in_original.contains(s.origin), before != s.vertex_is_reflex)
            << p.name << " + " << q.name;
        if (in_original.contains(s.origin)) {
          ASSERT_EQ(in_original[s.origin], s.vertex_is_reflex ? reversed(s.segment) : s.segment);
        }
      }
    }
  }
}

TEST(OriginalConvolution, replaces_at_one_vertex_only) {
  const std::vector<ReflexVertex> reflex = reflex_vertices(u, l);
  ASSERT_EQ(reflex.size(), 3U);
  EXPECT_EQ(reflex[0].vertex, (VertexIndex{0, 4}));
  EXPECT_EQ(reflex[1].vertex, (VertexIndex{0, 5}));
  EXPECT_EQ(reflex[2].of, Summand::Q);
  const auto before = convolution(u, l), all = original_convolution(u, l);
  for (const ReflexVertex& at : reflex) {
    const auto replaced = replaced_at(at, u, l);
    for (const ReflexVertex& v : reflex) {
      const bool same = v.of == at.of && v.vertex == at.vertex;
      EXPECT_EQ(of_vertex(v.of, v.vertex, replaced),
                of_vertex(v.of, v.vertex, same ? all : before));
    }
  }
}

TEST(OriginalConvolution, counts_both_arms_of_a_u_that_a_bar_crosses) {
  const Region bar = polygon(box(0, 0, 5, 1));
  EXPECT_EQ(winding_of_original({4, Rational(5, 2)}, u, bar), 2) << "through both arms";
  EXPECT_EQ(winding_of_original({4, Rational(1, 2)}, u, bar), 1) << "through the base";
  EXPECT_EQ(winding_of_original({Rational(1, 2), Rational(5, 2)}, u, bar), 1) << "one arm";
  EXPECT_EQ(winding_of_original({4, 5}, u, bar), 0) << "above";
}

TEST(OriginalConvolution, does_not_count_a_component_with_a_hole) {
  const Region frame = holed(box(0, 0, 6, 6), {box(2, 2, 4, 4)});
  const Point covering{Rational(9, 2), Rational(9, 2)};
  EXPECT_EQ(winding_of_original(covering, frame, polygon(box(0, 0, 3, 3))), 0);
  EXPECT_EQ(winding_number(covering, segments(convolution(frame, polygon(box(0, 0, 3, 3))))), 4)
      << "the hole's four vertices";
  EXPECT_EQ(winding_of_original({Rational(3, 2), Rational(3, 2)}, frame, square), 1);
}

TEST(OriginalConvolution, does_not_count_components_of_regions_as_printed) {
  // docs/findings.md, Section 4.2.4.
  const Region pierced{{{{{-2, -1}, {1, 0}, {0, 2}}, {{{0, 0}, {-1, 0}, {0, 1}}}}}};
  const Region triangle = polygon({{2, 0}, {0, 0}, {0, -2}});
  const Point covering{Rational(3, 5), Rational(-3, 10)};
  EXPECT_EQ(intersection_components(pierced, triangle, covering), (ComponentsAndHoles{1, 1}));
  EXPECT_EQ(winding_of_original(covering, pierced, triangle), 0);

  const Region touching{{{{{-2, 0}, {0, -1}, {1, 1}}, {{{-1, 0}, {0, 0}, {0, -1}}}}}};
  const Region small = polygon({{-1, 0}, {0, 0}, {0, 1}});
  const Point around{Rational(-13, 28), Rational(-25, 28)};
  EXPECT_EQ(intersection_components(small, touching, around), (ComponentsAndHoles{2, 0}));
  EXPECT_EQ(winding_of_original(around, small, touching), 1);
}

TEST(OriginalConvolution, of_the_empty_region_is_empty) {
  EXPECT_TRUE(original_convolution(l, Region{}).empty());
}

}  // namespace
}  // namespace oplus
