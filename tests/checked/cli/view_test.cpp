// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "checked/arrangement/hole_test.hpp"
#include "checked/arrangement/nesting.hpp"
#include "checked/arrangement/rca.hpp"
#include "checked/cli/face_drawing.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "checked/cycles/fiber_grid_picture.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/definitions/original_convolution.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/writing.hpp"
#include "tests/reference/definitions/pairs_of_shapes.hpp"
#include "tests/reference/pictures/parsed_picture.hpp"

namespace oplus {
namespace {

using boost::property_tree::ptree;
using Halfedge = ConvolutionArrangement::Halfedge;

/// The panel beside those of the summands.
ptree drawing_of(const std::string& document) {
  const std::vector<ptree> panels = groups(parsed(document), "panel");
  EXPECT_EQ(panels.size(), 3U);
  return panels.back();
}

std::string title(const ptree& panel) { return panel.get<std::string>("text"); }

/// How many segments the lines of these layers have.
std::size_t segments_in(const std::vector<ptree>& layers) {
  std::size_t count = 0;
  for (const ptree& layer : layers) {
    for (const auto& [tag, path] : layer) {
      if (tag != "path" || !path.get_optional<std::string>("<xmlattr>.stroke")) continue;
      const auto data = path.get<std::string>("<xmlattr>.d");
      count += static_cast<std::size_t>(std::count(data.begin(), data.end(), 'M'));
    }
  }
  return count;
}

std::size_t points_in(const std::vector<ptree>& layers) {
  std::size_t count = 0;
  for (const ptree& layer : layers) count += layer.count("circle");
  return count;
}

TEST(View, draws_any_regions_the_same_way_twice) {
  std::vector<Shape> all = shapes();
  all.push_back({"nothing", {}});
  for (const View& view : views()) {
    for (const Shape& shape : all) {
      const Region square = polygon(box(0, 0, 1, 2));
      for (const auto& [p, q] :
           {std::pair{shape.region, square}, std::pair{square, shape.region}}) {
        const std::string document = view.draw(p, q, {1, Rational(1, 3)});
        EXPECT_NO_THROW(parsed(document)) << view.name << " of " << shape.name;
        EXPECT_EQ(document, view.draw(p, q, {1, Rational(1, 3)}));
        EXPECT_EQ(document.find("nan"), std::string::npos);
        EXPECT_EQ(document.find("inf"), std::string::npos);
      }
    }
  }
}

TEST(View, fiber_grid_has_a_grid_for_each_pair_of_chains) {
  for_each_pair_of_shapes([](const Region& p, const Region& q) {
    const std::string document = fiber_grid_view(p, q);
    std::size_t pairs = 0;
    for (const Chain& of_p : chains(p)) {
      for (const Chain& of_q : chains(q)) {
        // Without the start of the tag, where a nested one has its place.
        EXPECT_NE(document.find(svg(fiber_grid(of_p, of_q)).substr(4)), std::string::npos);
        ++pairs;
      }
    }
    EXPECT_EQ(parsed(document).count("svg"), pairs == 1 ? 0U : pairs);
  });
}

TEST(View, cycles_are_layers_of_all_segments) {
  for_each_pair_of_shapes([](const Region& p, const Region& q) {
    const ConvolutionCycles traced = convolution_cycles(p, q);
    const std::size_t size = convolution(p, q).size();
    const ptree drawing = drawing_of(cycles_view(p, q));
    EXPECT_EQ(groups(drawing, "cycle").size(), traced.cycles.size());
    EXPECT_EQ(segments_in(groups(drawing, "cycle")), size);
    EXPECT_EQ(title(drawing), "Convolution: " + counted(size, "segment", "segments") + " in " +
                                  counted(traced.cycles.size(), "cycle", "cycles"));
  });
}

TEST(View, cycles_say_how_often_they_go_round) {
  // docs/findings.md, on Corollary 4.1.9.
  const ptree page = parsed(
      cycles_view(polygon({{0, 0}, {1, 0}, {0, 1}}), polygon({{0, 0}, {2, 1}, {0, 2}, {1, 1}})));
  EXPECT_EQ(legend_of(page).count("10 segments: P 2\u00d7, Q 1\u00d7"), 1U);
  const Region frame{{{box(0, 0, 3, 3), {backwards(box(1, 1, 2, 2))}}}};
  const std::multiset<std::string> legend = legend_of(parsed(cycles_view(frame, frame)));
  EXPECT_EQ(legend.count("8 segments: P chain 0 1\u00d7, Q chain 0 1\u00d7"), 1U);
}

TEST(View, faces_are_candidates_where_rca_asks_and_holes_where_the_sum_has_them) {
  std::size_t of_holes = 0;
  for_each_pair_of_shapes([&](const Region& p, const Region& q) {
    const ComputedSum computed = rca(p, q, Boundary::closed);
    const ConvolutionArrangement arrangement(traced_reduced_convolution(p, q));
    const FaceDrawing drawing(arrangement);
    std::size_t holes = 0;
    for (ConvolutionArrangement::Face f = 1; f < arrangement.face_count(); ++f) {
      const std::optional<FreeDisk> disk = drawing.free_disk(f);
      ASSERT_TRUE(disk);
      if (locate(disk->centre, computed.sum) == Location::outside) ++holes;
    }
    const std::string document = faces_view(p, q);
    const std::string of_faces = title(drawing_of(document));
    EXPECT_NE(
        of_faces.find(", " +
                      counted(computed.statistics.count("hole tests"), "candidate", "candidates") +
                      ", " + counted(holes, "hole", "holes")),
        std::string::npos)
        << of_faces;
    EXPECT_EQ(groups(drawing_of(document), "holes").empty(), holes == 0);
    EXPECT_EQ(groups(drawing_of(document), "candidate-in-sum").empty(),
              computed.statistics.count("hole tests") == holes);
    of_holes += holes;
  });
  EXPECT_GT(of_holes, 20U);
}

TEST(View, loops_draw_each_edge_and_those_of_the_boundary_as_such) {
  for_each_pair_of_shapes([](const Region& p, const Region& q) {
    const ConvolutionArrangement arrangement(traced_reduced_convolution(p, q));
    const PlanarSet sum = rca(p, q, Boundary::closed).sum;
    std::size_t directed = 0;
    std::size_t on_boundary = 0;
    for (Halfedge h = 0; h < 2 * arrangement.edge_count(); ++h) {
      if (arrangement.along(h).empty()) continue;
      ++directed;
      const auto [source, target] = arrangement.geometry(h);
      if (locate(midpoint(source, target), sum) == Location::boundary) ++on_boundary;
    }
    const ptree drawing = drawing_of(loops_view(p, q));
    const auto drawn = [&](const std::string& layer) {
      return segments_in(groups(drawing, layer));
    };
    EXPECT_EQ(drawn("boundary-loop"), on_boundary);
    EXPECT_EQ(drawn("on-no-loop") + drawn("boundary-loop") + drawn("not-nested-loop") +
                  drawn("not-boundary-loop"),
              directed);
  });
}

TEST(View, loops_count_their_verdicts) {
  for_each_pair_of_shapes([](const Region& p, const Region& q) {
    const ConvolutionArrangement arrangement(traced_reduced_convolution(p, q));
    const std::unique_ptr<HoleTest> naive = naive_hole_test(p, q);
    const std::vector<LoopVerdict> verdicts =
        judge(arrangement, orientable_loops(arrangement),
              [&](Halfedge h) { return naive->is_hole_right_of(arrangement.geometry(h)); });
    const auto count = [&](LoopVerdict verdict) {
      return std::to_string(std::count(verdicts.begin(), verdicts.end(), verdict));
    };
    EXPECT_EQ(title(drawing_of(loops_view(p, q))),
              "Orientable loops: " + count(LoopVerdict::boundary) + " of the boundary, " +
                  count(LoopVerdict::not_nested) + " not nested, " +
                  count(LoopVerdict::not_boundary) + " not of the boundary");
  });
}

/// The numbers written into faces, and how many the legend says are left out.
struct Notes {
  std::multiset<std::string> written;
  std::size_t left_out = 0;
};

Notes notes_of(const std::string& document) {
  Notes notes;
  const ptree drawing = drawing_of(document);
  for (const ptree& layer : groups(drawing, "winding-number")) {
    for (const auto& [tag, text] : layer)
      if (tag == "text") notes.written.insert(text.data());
  }
  for (const std::string& line : legend_of(parsed(document))) {
    if (line.starts_with("no room for ")) notes.left_out = std::stoul(line.substr(12));
  }
  return notes;
}

/// Expects the winding numbers by definition, of all bounded faces but those left out.
void expect_winding_numbers(const std::string& document,
                            const std::vector<ConvolutionSegment>& all) {
  const ConvolutionArrangement arrangement(all);
  const FaceDrawing drawing(arrangement);
  std::multiset<std::string> expected;
  for (ConvolutionArrangement::Face f = 1; f < arrangement.face_count(); ++f) {
    const std::optional<FreeDisk> disk = drawing.free_disk(f);
    if (disk) expected.insert(std::to_string(winding_number(disk->centre, segments(all))));
  }
  const Notes notes = notes_of(document);
  EXPECT_TRUE(
      std::includes(expected.begin(), expected.end(), notes.written.begin(), notes.written.end()));
  EXPECT_EQ(notes.written.size() + notes.left_out, arrangement.face_count() - 1);
  EXPECT_GT(notes.written.size(), 0U);
}

TEST(View, winding_numbers_are_those_of_the_definition) {
  for_each_pair_of_shapes([](const Region& p, const Region& q) {
    expect_winding_numbers(winding_view(p, q), convolution(p, q));
  });
}

TEST(View, original_has_its_own_winding_numbers_and_its_flipped_segments) {
  for_each_pair_of_shapes([](const Region& p, const Region& q) {
    const std::vector<ConvolutionSegment> all = original_convolution(p, q);
    const std::string document = original_view(p, q);
    expect_winding_numbers(document, all);
    const ptree drawing = drawing_of(document);
    const std::size_t kept = reduced_convolution(p, q).size();
    EXPECT_EQ(segments_in(groups(drawing, "reduced-convolution")), kept);
    EXPECT_EQ(segments_in(groups(drawing, "flipped")), all.size() - kept);
    EXPECT_NE(title(drawing).find(", " + std::to_string(all.size() - kept) + " flipped"),
              std::string::npos);
  });
}

/// What the picture of a placement says.
struct Placed {
  std::string title;
  bool has_common_interior;
  std::size_t overlaps;
  std::size_t crossings;
  std::size_t weak_intersections;
  std::size_t touching;

  std::size_t contacts() const { return overlaps + crossings + weak_intersections + touching; }
};

Placed placed(const Region& p, const Region& q, const Point& x) {
  const ptree drawing = drawing_of(placement_view(p, q, x));
  return {title(drawing),
          !groups(drawing, "common-interior").empty(),
          segments_in(groups(drawing, "overlap")),
          points_in(groups(drawing, "crossing")),
          points_in(groups(drawing, "weak-intersection")),
          points_in(groups(drawing, "touching"))};
}

bool boundaries_meet(const Region& a, const Region& b) {
  for (const Segment& s : edges(a))
    for (const Segment& t : edges(b))
      if (!intersection(s, t).empty()) return true;
  return false;
}

TEST(View, placement_tells_whether_interiors_and_boundaries_meet) {
  std::size_t meeting = 0;
  std::size_t touching_only = 0;
  for_each_pair_of_shapes([&](const Region& p, const Region& q) {
    for (const Point& x : {Point{1, 1}, Point{Rational(5, 2), 3}, Point{4, 2}}) {
      const Region other = translated(reflected(q), x);
      const bool meet = interiors_meet(p, other);
      const bool touch = boundaries_meet(p, other);
      const Placed picture = placed(p, q, x);
      EXPECT_EQ(picture.title.find("do not meet") == std::string::npos, meet) << picture.title;
      EXPECT_EQ(picture.has_common_interior, meet) << to_string(x);
      EXPECT_EQ(picture.contacts() > 0, touch) << to_string(x);
      EXPECT_TRUE(meet || picture.crossings + picture.weak_intersections == 0) << to_string(x);
      meeting += meet;
      touching_only += touch && !meet;
    }
  });
  EXPECT_GT(meeting, 100U);
  EXPECT_GT(touching_only, 50U);
}

TEST(View, placement_tells_contacts_apart) {
  const Region square = polygon(box(0, 0, 2, 2));
  struct Case {
    Point x;  ///< where -square, whose corner is its upper right one, is put
    std::size_t overlaps, crossings, weak_intersections, touching;
  };
  for (const Case& c :
       {Case{{3, 3}, 0, 2, 0, 0}, Case{{4, 4}, 0, 0, 0, 1}, Case{{4, 2}, 1, 0, 0, 0},
        Case{{2, 2}, 4, 0, 0, 0}, Case{{3, 2}, 2, 0, 0, 0}, Case{{9, 9}, 0, 0, 0, 0}}) {
    const Placed picture = placed(square, square, c.x);
    EXPECT_EQ(picture.overlaps, c.overlaps) << to_string(c.x);
    EXPECT_EQ(picture.crossings, c.crossings) << to_string(c.x);
    EXPECT_EQ(picture.weak_intersections, c.weak_intersections) << to_string(c.x);
    EXPECT_EQ(picture.touching, c.touching) << to_string(c.x);
  }
  // Its corners pass through the middles of the square's sides, and then do not.
  const Region diamond = polygon({{1, 0}, {2, 1}, {1, 2}, {0, 1}});
  EXPECT_EQ(placed(square, diamond, {2, 2}).weak_intersections, 4U);
  EXPECT_EQ(placed(square, diamond, {4, 2}).touching, 1U);
  EXPECT_EQ(placed(square, diamond, {4, 2}).weak_intersections, 0U);
}

TEST(View, placement_names_its_place_in_a_line) {
  const Region square = polygon(box(0, 0, 2, 2));
  EXPECT_EQ(placed(square, square, {Rational(1, 3), Rational(5, 2)}).title,
            "x = (1/3, 2.5): the interiors meet");
  const Rational third = Rational("1" + std::string(400, '0')) / 3;
  EXPECT_EQ(placed(square, square, {third, 0}).title,
            "x near (3.3333e+399, 0): the interiors do not meet");
}

}  // namespace
}  // namespace oplus
