// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/layouts/reading.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "reference/definitions/region.hpp"
#include "reference/families/random.hpp"
#include "reference/io/invalid_input.hpp"
#include "reference/io/writing.hpp"

namespace oplus {
namespace {

const Rational error(1, 1000);

/// What was read, for the last test.
std::vector<std::string>& texts() {
  static std::vector<std::string> all;
  return all;
}

Layout read(const std::string& text) {
  texts().push_back(text);
  return read_layout(text, "in", "", error);
}

/// Container, defects and parts of each sheet.
std::string described(const Layout& layout) {
  std::string text;
  for (const Sheet& sheet : layout.sheets) {
    text += sheet.name + "[";
    if (sheet.container) text += wkt(*sheet.container);
    for (const DefectiveZone& zone : sheet.defects)
      text += " - " + wkt(zone.region) + " " + std::to_string(zone.quality);
    text += "]";
    for (const PlacedPart& part : sheet.parts) {
      text += "\n" + part.name + ":" + std::to_string(part.line) + " " +
              wkt(translated(*part.shape, part.at));
      if (part.least_quality) text += " " + std::to_string(*part.least_quality);
    }
  }
  return text;
}

void expect_refusal(const std::string& text, const std::string& message) {
  try {
    read(text);
    ADD_FAILURE() << "read: " << text;
  } catch (const InvalidInput& refused) {
    EXPECT_EQ(std::string(refused.what()).substr(0, message.size()), message) << text;
  }
}

const std::string square = R"~([[0,0],[2,0],[2,1],[0,1]])~";

TEST(ReadingALayout, of_polygons_where_they_lie) {
  EXPECT_EQ(
      described(read(
          "POLYGON((0 0,1 0,0 1,0 0))\nMULTIPOLYGON(((0 0,2 0,0 2,0 0)),((5 5,6 5,5 6,5 5)))")),
      "[]\n:1 POLYGON ((0 0, 1 0, 0 1, 0 0))\n:2 POLYGON ((0 0, 2 0, 0 2, 0 0))\n"
      ":2 POLYGON ((5 5, 6 5, 5 6, 5 5))");
  EXPECT_EQ(
      described(read(R"~({"type": "Polygon", "coordinates": [[[0,0],[0,0.1],[1,0],[0,0]]]})~")),
      "[]\n:1 POLYGON ((0 0, 1 0, 0 0.1, 0 0))");
  EXPECT_EQ(read("POLYGON((0 0,0 1,1 0,0 0))").notes.at(0),
            "in: 1 chain was turned the other way round");
  expect_refusal("POLYGON((0 0,1 0,0 1,0 0))\nPOLYGON((0 0,1 1,1 0,0 1,0 0))",
                 "in:2:18: part 2: two edges of outer chain of component 1 cross at (0.5, 0.5)");
}

TEST(ReadingALayout, of_parts_and_placements) {
  const std::string start =
      R"~({"container": "POLYGON((0 0,9 0,9 9,0 9,0 0))", "parts": {"a": )~" + square;
  const auto placed = [&](const std::string& placement) {
    return start + "},\n\"placements\": [\n" + placement + "]}";
  };
  EXPECT_EQ(
      described(read(placed(R"~({"part": "a"}, {"part": "a", "at": ["1/3", 5], "rotation": 90},
{"part": "a", "rotation": ["3/5", "4/5"]}, {"part": "a", "mirrored": true, "rotation": 90})~"))),
      "[POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))]\na:3 POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))\n"
      "a:3 POLYGON ((1/3 5, 1/3 7, -2/3 7, -2/3 5, 1/3 5))\n"
      "a:4 POLYGON ((0 0, 1.2 1.6, 0.4 2.2, -0.8 0.6, 0 0))\n"
      "a:4 POLYGON ((0 0, -1 0, -1 -2, 0 -2, 0 0))");
  const Layout turned = read(placed(R"~({"part": "a", "rotation": 30})~"));
  EXPECT_EQ(
      wkt(*turned.sheets[0].parts[0].shape),
      "POLYGON ((0 0, 81090/46817 46816/46817, 57682/46817 87361/46817, -23408/46817 40545/46817, 0 0))");
  EXPECT_EQ(turned.notes.at(0).find("in: 1 rotation is not by a multiple of 90 degrees"), 0U);
  expect_refusal(placed(R"~({"part": "b"})~"), "in:3:10: placement 1: there is no part 'b'");
  expect_refusal(placed(R"~({"part": "a", "rotation": "east"})~"),
                 "in:3:27: placement 1: 'rotation': ");
  expect_refusal(placed(R"~({"part": "a", "rotation": [1, 1]})~"),
                 "in:3:27: placement 1: a cosine and a sine");
  expect_refusal(placed(R"~({"part": "a", "at": [1]})~"), "in:3:21: placement 1: 'at' has 1 items");
  expect_refusal(placed(R"~({"part": "a", "mirrored": 1})~"),
                 "in:3:27: placement 1: 'mirrored' is a number");
  expect_refusal(R"~({"parts": {"a": [[0,0],[1,1],[1,0],[0,1]]}, "placements": []})~",
                 "in:1:30: part 'a': two edges of outer chain of component 1 cross");
  expect_refusal(R"~({"parts": {"a": "POLYGON((0 0,1 1,1 0,0 1,0 0))"}, "placements": []})~",
                 "in:1:35: part 'a': two edges of outer chain of component 1 cross");
  expect_refusal(R"~({"placements": []})~", "in:1:1: the layout is without 'parts'");
  expect_refusal("{}", "in:1:1: an object without 'placements', 'items' and 'bins'");
  expect_refusal("", "in:1:1: the input is empty");
  expect_refusal("{\"parts\": \n" + std::string(1, '\0') + "}",
                 "in:2:1: the byte '\\x00' is not text");
}

TEST(ReadingALayout, of_files_beside_it) {
  const std::filesystem::path folder = testing::TempDir();
  std::ofstream(folder / "oplus-part.wkt") << "POLYGON((0 0,1 0,0 1,0 0))";
  std::ofstream(folder / "oplus-layout.json") << R"~({"parts": {"a": {"file": "oplus-part.wkt"}},
"placements": [{"part": "a"}], "defects": ["POLYGON((5 5,6 5,5 6,5 5))"],
"container": {"type": "Polygon", "coordinates": [[[0,0],[9,0],[9,9],[0,0]]]}})~";
  EXPECT_EQ(
      described(read_layout_file((folder / "oplus-layout.json").string(), error)),
      "[POLYGON ((0 0, 9 0, 9 9, 0 0)) - POLYGON ((5 5, 6 5, 5 6, 5 5)) 0]\na:2 POLYGON ((0 0, 1 0, 0 1, 0 0))");
}

TEST(ReadingALayout, after_a_byte_order_mark_and_beyond_the_plane) {
  const Layout layout = read(
      "\xEF\xBB\xBF{\"type\": \"Polygon\", \"coordinates\": [[[0,0,5],[1,0,5],[0,1,5],[0,0,5]]]}");
  EXPECT_EQ(described(layout), "[]\n:1 POLYGON ((0 0, 1 0, 0 1, 0 0))");
  EXPECT_EQ(layout.notes.at(0),
            "in: of 4 vertices with more than two coordinates, only x and y were read");
}

const std::string items =
    R"~({"items": [{"id": 7, "demand": 1, "min_quality": 1, "shape": {"type": "simple_polygon", "data":
[[0.5,0],[2,0],[2,0],[2,1],[0.5,0]]}}, {"id": 8, "shape": {"type": "rectangle", "data": {"x_min": 0, "y_min": 0, "width": 2, "height": 1}}}],)~";

TEST(ReadingALayout, of_jagua_rs_and_sparrow) {
  const std::string end =
      R"~("strip_height": 4, "solution": {"strip_width": 9.5, "layout": {"container_id": 0, "placed_items": [
{"item_id": 7, "transformation": {"rotation": -90.0, "translation": [3, 3.25]}},
{"item_id": 8, "transformation": {"rotation": 0.0, "translation": [0, 0]}}], "density": 0.5}}})~";
  EXPECT_EQ(
      described(read(items + end)),
      "[POLYGON ((0 0, 9.5 0, 9.5 4, 0 4, 0 0))]\nitem 7:3 POLYGON ((3 2.75, 3 1.25, 4 1.25, 3 2.75)) 1\n"
      "item 8:4 POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))");
  const std::string bins =
      R"~("bins": [{"id": 3, "stock": 1, "shape": {"type": "polygon", "data": {"outer":
[[0,0],[9,0],[9,9],[0,9]], "inner": [[[4,4],[5,4],[5,5]]]}}, "zones": [{"quality": 2, "shape": {"type": "multi_polygon", "data": [{"outer": [[1,1],[2,1],[2,2]]}]}}]}],
"solution": {"layouts": [{"container_id": 3, "placed_items": [{"item_id": ITEM, "transformation": {"rotation": 0, "translation": [1, 1]}}]}]}})~";
  const auto with = [&](const std::string& item) {
    std::string text = items + bins;
    return text.replace(text.find("ITEM"), 4, item);
  };
  EXPECT_EQ(
      described(read(with("8"))),
      "layout 1[POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (4 4, 5 5, 5 4, 4 4)) - POLYGON ((1 1, 2 1, 2 2, 1 1)) 2]\n"
      "item 8:4 POLYGON ((1 1, 3 1, 3 2, 1 2, 1 1))");
  expect_refusal(with("9"), "in:4:75: part 1: there is no item 9; expected the id of an item");
  expect_refusal(items.substr(0, items.size() - 1) + "}", "in:1:1: items without a 'solution'");
  std::string other = with("8");
  expect_refusal(other.replace(other.find("container_id\": 3"), 16, "container_id\": 4"),
                 "in:4:43: there is no container 4; expected the id of one");
  std::string holes = with("8");
  expect_refusal(
      holes.replace(holes.find("[[4,4],"), 19, "[[1,1],[1,2],[2,2]],\n[[4,4],[6,4],[4,6],[6,6]]"),
      "in:4:20: container 3: two edges of hole 2 of component 1 cross");
  std::string untold = with("8");
  expect_refusal(untold.replace(untold.find("\"polygon\""), 9, "5"),
                 "in:2:191: container 3: 'type' is a number; expected a string");
  for (const std::string quality : {"1.5", "1e10"}) {
    std::string text = with("7");
    expect_refusal(text.replace(text.find("min_quality\": 1"), 15, "min_quality\": " + quality),
                   "in:1:50: item 7: 'min_quality' is '" + quality + "'; expected an integer");
  }
  std::string without = with("7");
  without.replace(without.find("min_quality\": 1"), 15, "min_quality\": null");
  EXPECT_FALSE(read(without).sheets[0].parts[0].least_quality);
  without.insert(without.find("\"layouts\""),
                 R"~("containers": [{"id": 5, "shape": {"type": "rectangle",
"data": {"x_min": 0, "y_min": 0, "width": 7, "height": 7}}}],)~");
  without.replace(without.find("container_id\": 3"), 16, "container_id\": 5");
  EXPECT_EQ(wkt(*read(without).sheets[0].container), "POLYGON ((0 0, 7 0, 7 7, 0 7, 0 0))");
}

TEST(ReadingALayout, of_packingsolver) {
  const auto line = [](const std::string& xs, const std::string& ys, const std::string& xe,
                       const std::string& ye) {
    return R"~({"type": "LineSegment", "xe": )~" + xe + R"~(, "xs": )~" + xs + R"~(, "ye": )~" +
           ye + R"~(, "ys": )~" + ys + "}";
  };
  const auto triangle = [&](const std::string& x) {
    return "[" + line("0", "0", x, "0") + "," + line("4", "0", "0", "4") + "," +
           line("0", "4", "0", "0") + "]";
  };
  const auto bin = [&](const std::string& x) {
    return R"~({
"bins": [{"copies": 1, "id": 0, "defects": [{"shape": )~" +
           triangle("4") +
           R"~(}], "items": [
{"angle": 0.0, "id": 5, "item_shapes": [{"shape": )~" +
           triangle(x) + R"~(}], "x": 0.0}],
"shape": )~" +
           triangle("4") + "}]}";
  };
  EXPECT_EQ(described(read(bin("4.0"))),
            "bin 1[POLYGON ((0 0, 4 0, 0 4, 0 0)) - POLYGON ((0 0, 4 0, 0 4, 0 0)) 0]\n"
            "item 5:3 POLYGON ((0 0, 4 0, 0 4, 0 0))");
  expect_refusal(
      bin("4.5"),
      "in:3:114: bin 1: part 1: an element starts at (4, 0), and the one before it ends at (4.5, 0)");
  std::string open = bin("4");
  open.replace(open.rfind("\"xe\": 0"), 7, "\"xe\": 1");
  expect_refusal(
      open, "in:4:11: bin 1: an element starts at (0, 0), and the one before it ends at (1, 0)");
  std::string with_hole = bin("4");
  with_hole.insert(with_hole.rfind('}') - 2, ", \"holes\": [[" + line("1", "1", "1", "2") + "," +
                                                 line("1", "2", "2", "1") + "," +
                                                 line("2", "1", "1", "1") + "]]");
  EXPECT_EQ(wkt(*read(with_hole).sheets[0].container),
            "POLYGON ((0 0, 4 0, 0 4, 0 0), (1 1, 1 2, 2 1, 1 1))");
  std::string arc = bin("4");
  arc.replace(arc.rfind("LineSegment"), 11, "CircularArc");
  expect_refusal(arc, "in:4:");
}

TEST(ReadingALayout, of_svg) {
  const auto svg = [](const std::string& content) {
    return "<svg xmlns=\"s\">\n" + content + "\n</svg>";
  };
  EXPECT_EQ(described(read(
                svg(R"~(<g id="container_0"><path d="M0,0 L9,0 L9,9 L0,9 z"/><title>bin</title></g>
<g id="items"><defs><g id="item_0"><path d="M0,0 L2,0 L2,1 z"/></g></defs>
<use transform="translate(5 4), rotate(-90)" xlink:href="#item_0"><title>item</title></use>
<use transform="translate(1)" href="#item_0" y="2"/></g><g id="quality_zones"/>
<g id="optionals"><path d="M0,0 L1,1"/></g><text x="0">w: 9</text>)~"))),
            "[POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))]\nitem_0:4 POLYGON ((5 4, 5 2, 6 2, 5 4))\n"
            "item_0:5 POLYGON ((1 2, 3 2, 3 3, 1 2))");
  EXPECT_EQ(described(read(svg(R"~(<rect class="bin" width="9" height="8.5"/>
<g transform="translate(1 2) rotate(90)"><polygon points="0,0 4,0 4,4 0,4"/><path class="x hole" d="M1 1 v1 h1 v-1 z"/></g>
<svg:g xmlns:svg="s" transform="matrix(0 1 -1 0 0 0) scale(2) rotate(180 1 1)"><path id="p" d="M0 0 h1 v1z"/></svg:g>
<path style="display: none" d="M0 0 h1 v1z"/><polyline points="0 0 1 1"/>)~"))),
            "[POLYGON ((0 0, 9 0, 9 8.5, 0 8.5, 0 0))]\n"
            ":3 POLYGON ((1 2, 1 6, -3 6, -3 2, 1 2), (0 3, -1 3, -1 4, 0 4, 0 3))\n"
            "p:4 POLYGON ((-4 4, -4 2, -2 2, -4 4))");
  EXPECT_EQ(described(read("<?xml version=\"1.0\"?><!DOCTYPE svg>" +
                           svg(R"~(<!-- <g> > --><style><![CDATA[<g>]]></style><symbol id="s"/>
<g display="none"><path d="M0 0 h1 v1z"/></g><rect class="the bin of them" width="9" height="9"/>
<rect class="holes pothole binary" width="1" height="1"/>)~"))),
            "[POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))]\n:4 POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))");
  EXPECT_EQ(described(read(
                svg("<path class=\"hole\" d=\"M0 0 h1 v1z\"/>\n<rect width=\"9\" height=\"9\"/>\n"
                    "<path class=\"hole\" d=\"M1 1 v1 h1 v-1 z\"/>"))),
            "[]\n:2 POLYGON ((0 0, 1 0, 1 1, 0 0))\n"
            ":3 POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1))");
  expect_refusal("<!DOCTYPE svg [<!ENTITY a 'b'>]>" + svg(""),
                 "in:1:1: a document type with declarations");
  const std::pair<std::string, std::string> refused[] = {
      {R"~(<path d="M0 0 L 1 1 1 0 0 1z"/>)~",
       "in:2:21: part 1: two edges of outer chain of component 1 cross"},
      {R"~(<path d="M0 0 L 1 1 C 1 0 0 1 0 0z"/>)~", "in:2:21: part 1: command 3, 'C', is a curve"},
      {R"~(<path d="M0 0 L 1 1 1 0"/>)~",
       "in:2:21: part 1: outer chain of component 1 is not closed"},
      {R"~(<polygon points="0 0 1 x"/>)~", "in:2:24: part 1: 'xZ' where y of vertex 2"},
      {R"~(<path d="M0 0H9V9zM1 1 2 2z"/>)~",
       "in:2:20: part 1: outer chain of component 2 has 2 vertices"},
      {R"~(<circle r="1"/>)~", "in:2:2: the element circle is a curve"},
      {R"~(<a><ellipse rx="1"/></a>)~", "in:2:5: the element ellipse is a curve"},
      {R"~(<symbol id="s"/><use href="#s"/>)~", "in:2:2: the element symbol"},
      {R"~(<rect width="2" height="1"/><path class="hole" transform="scale(1)" d="M0 0 1 0 1 1z"/>)~",
       "in:2:30: part 1: a hole with a transform of its own"},
      {R"~(<path d="M0 0h9v9h-9z"/><path class="hole" d="M1 1v1h1v-1z"/><path class="hole" d="M5 5L7 7V5L5 7z"/>)~",
       "in:2:93: part 1: two edges of hole 2 of component 1 cross"},
      {R"~(<g transform="scale(2"/>)~", "in:2:22: the end of a transform"},
      {R"~(<rect width="2" height="1" rx="0.5"/>)~",
       "in:2:32: part 1: a rectangle with round corners"},
      {R"~(<rect width="2cm" height="1"/>)~", "in:2:14: part 1: width: "},
      {R"~(<use href="#none"/>)~", "in:2:12: there is no part 'none'"},
      {R"~(<use href="other.svg"/>)~", "in:2:12: the reference 'other.svg'"},
      {R"~(<g id="quality_zones"><path d=""/></g>)~", "in:2:2: quality zones"},
      {R"~(<g id="a"><use href="#a"/></g>)~", "in:2:22: elements that use each other"},
      {R"~(<g transform="rotate(x)"/>)~", "in:2:22: a number of rotate: "},
      {"<g transform=\"tr\xFF(x)\"/>", "in:2:19: a number of tr\\xff: "},
      {R"~(<g transform="skewX(10)"/>)~", "in:2:15: 'skewX' of 1 numbers"},
      {R"~(<rect transform="scale(0)" width="2" height="1"/>)~", "in:2:2: part 1 is flat"},
      {R"~(<g id="bin"><rect width="2" height="1"/><rect width="2" height="1"/></g>)~",
       "in:2:42: a second container"},
      {R"~(<g>)~", "in:3:6: "},
      {R"~(<svg/>)~", "in:2:2: an svg inside another one"},
  };
  for (const auto& [content, message] : refused) expect_refusal(svg(content), message);
  std::string deep, beside;
  for (int i = 0; i < 1000000; ++i) deep += "<g>";
  for (int i = 0; i < 300; ++i) beside += R"~(<rect width="1" height="1"/>)~";
  EXPECT_EQ(read(svg(beside)).sheets[0].parts.size(), 300U);
  expect_refusal(svg(deep), "in:2:766: elements nested deeper than 256 levels");
  expect_refusal("<html/>", "in:1:1: markup without an element svg");
}

TEST(ReadingALayout, of_any_changed_text_ends_in_a_layout_or_a_line) {
  Random random(1);
  std::size_t refused = 0, layouts = 0;
  const std::vector<std::string> originals = texts();
  ASSERT_GT(originals.size(), 40U);
  for (int change = 0; change < 5000; ++change) {
    std::string text = originals[uniform_index(random, originals.size())];
    if (text.empty() || text.size() > 2000) continue;
    for (int i = uniform(random, 1, 3); i > 0; --i) {
      const std::size_t at = uniform_index(random, text.size());
      const std::size_t from = uniform_index(random, text.size());
      const int length = uniform(random, 0, 12);
      if (one_in(random, 2))
        text.replace(at, 1, 1, "<>\"'/{}[]()0-.,eE&#\n"[uniform_index(random, 21)]);
      else
        text.insert(at, text.substr(from, static_cast<std::size_t>(length)));
    }
    try {
      read_layout(text, "in", "", error);
      ++layouts;
    } catch (const InvalidInput& invalid) {
      ++refused;
      EXPECT_EQ(std::string(invalid.what()).find('\n'), std::string::npos) << text;
    }
  }
  EXPECT_GT(refused, 1000U);
  EXPECT_GT(layouts, 100U);
}

}  // namespace
}  // namespace oplus
