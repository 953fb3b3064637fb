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

/// The panel of a picture of one layer.
ptree panel_of(const Layer& layer) { return first_panel(svg({{"", {layer}}})); }

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

TEST(Picture, legend_is_in_the_order_of_places_numbers_and_labels) {
  const std::vector<Style> styles = {{.name = "a", .label = "first", .place = 0},
                                     {.name = "b", .label = "second", .place = 1, .number = -3},
                                     {.name = "b", .label = "also second", .place = 1, .number = 2},
                                     {.name = "b", .label = "in the end", .place = 1, .number = 2}};
  const std::string document =
      svg({{"", {some(styles[3]), some(styles[1])}}, {"", {some(styles[2]), some(styles[0])}}});
  std::size_t at = document.find("class=\"legend\"");
  for (const Style& one : styles) {
    at = document.find(one.label, at);
    EXPECT_NE(at, std::string::npos) << one.label;
  }
}

TEST(Picture, empty_layers_are_left_out) {
  const ptree tree =
      parsed(svg({{"nothing", {{style::sum}, {style::holes}, {style::convolution}}}}));
  EXPECT_TRUE(legend_of(tree).empty());
  EXPECT_TRUE(groups(groups(tree, "panel").at(0), "sum").empty());
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

TEST(Picture, same_panels_same_bytes) {
  for (const Shape& a : shapes()) {
    const std::vector<Panel> panels = panels_of(a.region, shapes().back().region);
    EXPECT_EQ(svg(panels), svg(panels)) << a.name;
    EXPECT_EQ(groups(parsed(svg(panels)), "panel").size(), 4U) << a.name;
  }
}

TEST(Picture, y_axis_is_up) {
  const auto points = drawn_points(panel_of({style::dangling_edges, {}, {{{0, 0}, {1, 1}}}}));
  ASSERT_EQ(points.size(), 2U);
  EXPECT_LT(points[0].first, points[1].first);
  EXPECT_GT(points[0].second, points[1].second);
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

TEST(Picture, directed_segments_have_arrow_heads_and_others_none) {
  const auto paths = [](const Style& style) {
    return groups(panel_of({style, {}, {{{0, 0}, {9, 0}}}}), style.name).at(0).count("path");
  };
  EXPECT_EQ(paths(style::convolution), 2U);
  EXPECT_EQ(paths(style::reduced_convolution), 2U);
  EXPECT_EQ(paths(style::dangling_edges), 1U);
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

TEST(Picture, layers_of_a_sum_are_its_parts) {
  PlanarSet sum = canonical_sum(
      together({holed(box(0, 0, 6, 6), {box(1, 1, 5, 5)}), polygon(box(2, 2, 4, 4))}));
  EXPECT_EQ(layers_of(sum).size(), 2U);
  sum.dangling_edges = {{{0, 0}, {1, 1}}};
  sum.isolated_vertices = {{3, 3}};
  const std::vector<Layer> layers = layers_of(sum);
  ASSERT_EQ(layers.size(), 4U);
  EXPECT_EQ(layers[0].style.name, style::holes.name);
  EXPECT_EQ(canonical_sum(layers[0].region), canonical_sum(polygon(box(1, 1, 5, 5))));
  EXPECT_EQ(layers[1].style.name, style::sum.name);
  EXPECT_EQ(area(layers[1].region), 36 - 16 + 4);
  EXPECT_EQ(layers[2].segments, sum.dangling_edges);
  EXPECT_EQ(layers[3].points, sum.isolated_vertices);
}

TEST(Picture, numbered_layers_differ_in_their_look) {
  std::set<std::string> looks;
  for (int number = 0; number < 28; ++number)
    looks.insert(svg({{"", {some(labelled(style::cycle(number), "same"))}}}));
  EXPECT_EQ(looks.size(), 28U);
}

TEST(Picture, layers_of_one_style_may_have_labels_of_their_own) {
  const Layer labelled_dot = some(labelled(dot_style, "3 dots"));
  EXPECT_EQ(legend_of(parsed(svg({{"", {labelled_dot, some(dot_style)}}}))),
            (std::multiset<std::string>{"3 dots", "a dot"}));
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

TEST(Picture, a_written_note_stays_in_its_disk) {
  for (const Rational& radius : {Rational(1, 20), Rational(1, 10), Rational(1, 2)}) {
    Layer layer = some(area_style);
    layer.notes = {{"12", {11, 11}, radius * radius}};
    const ptree note = groups(panel_of(layer), "area").at(0).get_child("text");
    const auto size = note.get<double>("<xmlattr>.font-size");
    EXPECT_GT(size, 6);
    EXPECT_LE(2 * 0.6 * size, 2 * 160 * radius.get_d());
    // Its middle, not its foot, is at the point.
    EXPECT_NEAR(note.get<double>("<xmlattr>.y") - 0.365 * size, 42 + 160, 0.1);
  }
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

TEST(Picture, columns_stand_beside_each_other_and_their_panels_below) {
  const Panel flat = filled(polygon(box(0, 0, 3, 1))), square = filled(polygon(box(0, 0, 2, 2)));
  const std::vector<Drawn> panels = drawn_panels(svg_in_columns({{flat, flat}, {square}}));
  ASSERT_EQ(panels.size(), 3U);
  EXPECT_EQ(panels[0].left, panels[1].left);
  EXPECT_EQ(panels[0].right, panels[1].right);
  EXPECT_GT(panels[1].top, panels[0].bottom + 40);  // caption and title between
  EXPECT_GT(panels[2].left, panels[0].right);
}

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

TEST(Picture, with_one_panel_per_column_is_the_picture_of_the_panels) {
  const std::vector<Panel> panels = panels_of(shapes()[0].region, shapes()[1].region);
  EXPECT_EQ(svg_in_columns({{panels[0]}, {panels[1]}, {panels[2]}, {panels[3]}}), svg(panels));
}

}  // namespace
}  // namespace oplus
