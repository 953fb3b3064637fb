// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/pictures/styles.hpp"

#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "reference/chains/region_of.hpp"
#include "tests/reference/definitions/shapes.hpp"
#include "tests/reference/pictures/parsed_picture.hpp"

namespace oplus {
namespace {

using Sample = Style::Sample;
using boost::property_tree::ptree;

const Style area_style{.name = "area", .label = "an area", .place = 10, .fill = "#ffffff"};
const Style dot_style{.name = "dot", .label = "a dot", .place = 12, .sample = Sample::dot};

/// One of each kind of sample, and all that this folder defines.
std::vector<Style> all_styles() {
  return {style::summand_p,
          style::summand_q,
          style::convolution,
          style::reduced_convolution,
          style::sum,
          style::holes,
          style::dangling_edges,
          style::isolated_vertices,
          style::difference,
          style::origin,
          style::cycle(0),
          area_style,
          dot_style,
          {.name = "ring", .label = "a ring", .place = 11, .sample = Sample::ring}};
}

/// Something in a style, far from the origin: a region, a segment or a point, as it suits.
Layer some(const Style& style) {
  switch (style.sample) {
    case Sample::line:
      return {style, {}, {{{10, 10}, {11, 12}}, {{11, 12}, {13, 10}}}};
    case Sample::area:
      return {style, polygon(box(10, 10, 12, 12))};
    default:
      return {style, {}, {}, {{11, 11}}};
  }
}

/// The first panel of a document.
ptree first_panel(const std::string& document) { return groups(parsed(document), "panel").at(0); }

/// Every number in the path data of a panel, but for the mark of the origin, as pairs.
std::vector<std::pair<double, double>> drawn_points(const ptree& panel) {
  std::vector<std::pair<double, double>> points;
  for (const auto& [tag, layer] : panel) {
    if (tag != "g" || layer.get<std::string>("<xmlattr>.class") == "origin") continue;
    for (const auto& [shape, content] : layer) {
      if (shape != "path") continue;
      std::string data = content.get<std::string>("<xmlattr>.d");
      for (char& c : data)
        if (c == 'M' || c == 'L' || c == 'Z' || c == ',') c = ' ';
      std::istringstream numbers(data);
      for (double x = 0, y = 0; numbers >> x >> y;) points.emplace_back(x, y);
    }
  }
  return points;
}

TEST(Picture, legend_names_each_style_that_is_drawn_once) {
  std::vector<Layer> layers;
  std::multiset<std::string> labels;
  for (const Style& one : all_styles()) {
    EXPECT_EQ(legend_of(parsed(svg({{"one", {some(one), some(one)}}, {"two", {some(one)}}}))),
              std::multiset<std::string>{one.label});
    layers.push_back(some(one));
    labels.insert(one.label);
  }
  EXPECT_EQ(legend_of(parsed(svg({{"all", layers}}))), labels);
  EXPECT_EQ(std::set<std::string>(labels.begin(), labels.end()).size(), all_styles().size());
}

TEST(Picture, nothing_at_all_is_still_a_picture) {
  EXPECT_TRUE(groups(parsed(svg({})), "panel").empty());
  for (const Panel& panel : panels_of({}, {})) {
    const ptree tree = parsed(svg({panel}));
    EXPECT_EQ(groups(tree, "panel").size(), 1U);
    EXPECT_NE(svg({panel}).find(">empty<"), std::string::npos);
  }
  EXPECT_TRUE(layers_of({}).empty());
}

TEST(Picture, stays_on_the_page_however_large_or_small_the_coordinates) {
  const Rational huge("1" + std::string(400, '0'));
  for (const Rational& size : {Rational(1), huge, Rational(1 / huge)}) {
    for (const Rational& offset : {Rational(0), huge, Rational(-huge)}) {
      const Layer layer{style::sum, polygon(box(offset, offset, offset + size, offset + 3 * size))};
      const ptree tree = parsed(svg({{"", {layer}}}));
      const double width = std::stod(tree.get<std::string>("<xmlattr>.width"));
      const double height = std::stod(tree.get<std::string>("<xmlattr>.height"));
      const auto points = drawn_points(groups(tree, "panel").at(0));
      EXPECT_GE(points.size(), 8U);
      for (const auto& [x, y] : points) {
        EXPECT_TRUE(x > 0 && x < width);
        EXPECT_TRUE(y > 0 && y < height);
      }
      // One scale for both axes.
      EXPECT_NEAR(points[2].second - points[1].second, 3 * (points[0].first - points[1].first),
                  0.1);
    }
  }
}

TEST(Picture, one_point_can_be_drawn) {
  const std::string document = svg({{"", {{style::isolated_vertices, {}, {}, {{7, 7}}}}}});
  EXPECT_EQ(document.find("nan"), std::string::npos);
  EXPECT_EQ(document.find("inf"), std::string::npos);
  EXPECT_EQ(legend_of(parsed(document)).size(), 1U);
}

TEST(Picture, titles_may_contain_anything) {
  std::string title;
  for (int c = 1; c < 256; ++c) title += static_cast<char>(c);
  title += "\xe2\x8a\x95\xef\xbf\xbf\xf0\x9f";
  const std::string drawn =
      first_panel(svg({{title, {some(style::sum)}}})).get<std::string>("text");
  for (const char c : drawn) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f);
  EXPECT_NE(drawn.find("%&'()*+"), std::string::npos) << drawn;
  EXPECT_NE(drawn.find(";<=>?"), std::string::npos) << drawn;
  EXPECT_NE(drawn.find("\xe2\x8a\x95?"), std::string::npos) << drawn;
}

TEST(Picture, a_hole_inside_a_hole_is_filled_too) {
  // By the even-odd rule the inner one would be left out of the outer one.
  const PlanarSet nested = canonical_sum(together(
      {holed(box(0, 0, 9, 9), {box(1, 1, 8, 8)}), holed(box(2, 2, 7, 7), {box(3, 3, 6, 6)})}));
  const ptree panel = first_panel(svg({{"", layers_of(nested)}}));
  const ptree fill = groups(panel, "holes").at(0).get_child("path");
  EXPECT_EQ(fill.get<std::string>("<xmlattr>.fill-rule"), "nonzero");
  const Region holes = layers_of(nested).at(0).region;
  EXPECT_EQ(holes.components.size(), 2U);
  for (const Component& hole : holes.components) EXPECT_GT(twice_area(hole.outer), 0);
}

TEST(Picture, a_long_legend_says_how_much_it_leaves_out) {
  std::vector<Layer> cycles;
  for (int number = 0; number < 100; ++number) cycles.push_back(some(style::cycle(number)));
  const std::multiset<std::string> legend = legend_of(parsed(svg({{"", cycles}})));
  EXPECT_EQ(legend.size(), 41U);
  EXPECT_EQ(legend.count("and 60 more"), 1U);
}

/// The notes that are written into the first panel.
std::multiset<std::string> notes_of(const std::string& document) {
  std::multiset<std::string> notes;
  const ptree panel = first_panel(document);
  for (const auto& [tag, layer] : panel)
    if (tag == "g")
      for (const auto& [shape, content] : layer)
        if (shape == "text") notes.insert(content.data());
  return notes;
}

TEST(Picture, notes_are_written_where_they_fit_and_counted_where_not) {
  Layer layer = some(area_style);
  layer.notes = {
      {"7", {11, 11}, Rational(1, 4)}, {"8", {11, 11}, Rational(1, 10000)}, {"9", {}, 0}};
  const std::string document = svg({{"", {layer}}});
  EXPECT_EQ(notes_of(document), std::multiset<std::string>{"7"});
  EXPECT_EQ(legend_of(parsed(document)).count("no room for 2 numbers"), 1U);
  // What fits depends on the size of the drawing and on the length of the text.
  EXPECT_EQ(notes_of(svg({{"", {layer}}}, 3200)), (std::multiset<std::string>{"7", "8"}));
  layer.notes = {{"12345678901234567890123456789012345678901234", {11, 11}, Rational(1, 4)}};
  EXPECT_TRUE(notes_of(svg({{"", {layer}}})).empty());
}

/// The least and the largest coordinates that are drawn in each panel.
struct Drawn {
  double left, right, top, bottom;
};
std::vector<Drawn> drawn_panels(const std::string& document) {
  std::vector<Drawn> result;
  for (const ptree& panel : groups(parsed(document), "panel")) {
    std::set<double> x, y;
    for (const auto& point : drawn_points(panel)) {
      x.insert(point.first);
      y.insert(point.second);
    }
    result.push_back({*x.begin(), *x.rbegin(), *y.begin(), *y.rbegin()});
  }
  return result;
}

Panel filled(const Region& region) { return {"filled", {{style::sum, region}}}; }

TEST(Picture, has_one_scale_in_all_panels) {
  const Panel small = filled(polygon(box(5, 5, 6, 6))), large = filled(polygon(box(0, 0, 4, 8)));
  for (const std::string& document :
       {svg({small, large}, 400), svg_in_columns({{small}, {small, large}}, 400)}) {
    for (const Drawn& panel : {drawn_panels(document).front(), drawn_panels(document).back()}) {
      const bool is_large = panel.bottom - panel.top > 200;
      EXPECT_NEAR(panel.right - panel.left, is_large ? 200 : 50, 0.02);
      EXPECT_NEAR(panel.bottom - panel.top, is_large ? 400 : 50, 0.02);
    }
    EXPECT_EQ(document.find("enlarged"), std::string::npos);
  }
}

TEST(Picture, a_panel_that_would_be_too_small_to_see_is_enlarged_and_says_so) {
  const std::string document =
      svg({filled(polygon(box(0, 0, 1, 1))), filled(polygon(box(0, 0, 200, 100)))}, 400);
  const std::vector<Drawn> panels = drawn_panels(document);
  EXPECT_NEAR(panels[0].right - panels[0].left, 16, 0.02);
  EXPECT_NEAR(panels[1].right - panels[1].left, 400, 0.02);
  EXPECT_NE(document.find(">x 0 \u2026 1,  y 0 \u2026 1,  enlarged 8\u00d7<"), std::string::npos)
      << document;
}

TEST(Picture, the_origin_is_marked_where_it_is_in_or_near_a_panel) {
  const Region square = polygon(box(0, 0, 10, 10));
  const auto marks = [&](const Vector& by) {
    const ptree tree = parsed(svg({filled(translated(square, by))}));
    EXPECT_EQ(legend_of(tree).count("origin"),
              groups(groups(tree, "panel").at(0), "origin").size());
    return legend_of(tree).count("origin");
  };
  for (const Vector& near : {Vector{0, 0}, Vector{-5, -10}, Vector{Rational(1, 4), 0}})
    EXPECT_EQ(marks(near), 1U);
  for (const Vector& far : {Vector{1, 0}, Vector{0, 1}, Vector{-11, 0}, Vector{0, -11}})
    EXPECT_EQ(marks(far), 0U);
}

}  // namespace
}  // namespace oplus
