// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <map>

#include "reference/families/family.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"

namespace oplus {
namespace {

/// As PostGIS writes POLYGON((0 0,1 0,1 0.5,0 0)).
const std::string triangle =
    "0103000000010000000400000000000000000000000000000000000000000000000000F03F"
    "0000000000000000000000000000F03F000000000000E03F00000000000000000000000000000000";
/// The most significant byte first, as JTS may write it.
const std::string other_order =
    "00000000030000000100000004000000000000000000000000000000003FF0000000000000000000"
    "00000000003FF00000000000003FE000000000000000000000000000000000000000000000";

std::string bytes(const std::string& digits) {
  std::string result;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    result += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  return result;
}

TEST(Wkb, is_read_in_digits_and_in_bytes_in_either_order) {
  const Region expected = read_region("POLYGON ((0 0, 1 0, 1 0.5, 0 0))", "WKT").region;
  // With a SRID, as PostGIS writes it, too.
  const std::string with_srid = "0103000020E6100000" + triangle.substr(10);
  for (const std::string& digits : {triangle, other_order, with_srid}) {
    EXPECT_EQ(read_region(digits, "digits").region, expected);
    EXPECT_EQ(read_region("\n " + digits + "\n", "digits").region, expected);
    EXPECT_EQ(read_region(bytes(digits), "bytes").region, expected);
  }
}

/// The triangle with this type and as many more coordinates of each vertex, the last of them NaN.
std::string with_type(const std::string& type, std::size_t more) {
  std::string result = "01" + type + triangle.substr(10, 16);
  for (std::size_t vertex = 0; vertex < 4; ++vertex) {
    result += triangle.substr(26 + 32 * vertex, 32);
    if (more > 1) result += "0000000000001440";
    if (more > 0) result += "000000000000F87F";
  }
  return result;
}

TEST(Wkb, is_read_without_z_and_m) {
  const Region expected = read_region(triangle, "digits").region;
  EXPECT_EQ(with_type("03000000", 0), triangle);
  for (const auto& [type, more] : std::map<std::string, std::size_t>{{"EB030000", 1},     // ISO: Z
                                                                     {"D3070000", 1},     // M
                                                                     {"BB0B0000", 2},     // ZM
                                                                     {"03000080", 1},     // EWKB: Z
                                                                     {"03000040", 1},     // M
                                                                     {"030000C0", 2}}) {  // ZM
    const std::string digits = with_type(type, more);
    for (const std::string& text : {digits, bytes(digits)}) {
      const ReadRegion read = read_region(text, "file");
      EXPECT_EQ(read.region, expected) << type;
      EXPECT_EQ(read.notes, (std::vector<std::string>{
                                "file: of 4 vertices with more than two coordinates, only x and y "
                                "were read"}))
          << type;
    }
  }
  // Of a part each its own: MULTIPOINT Z (1 2 3), and a point without Z.
  const std::string one = "000000000000F03F", two = "0000000000000040";
  const ReadSet points =
      read_set("0104000080020000000101000080" + one + two + one + "0101000000" + two + one, "file");
  EXPECT_EQ(points.points, (std::vector<Point>{{1, 2}, {2, 1}}));
  EXPECT_EQ(points.notes.size(), 1U);
}

TEST(Wkb, of_several_lines_is_one_region) {
  const std::string other = written(
      read_region("MULTIPOLYGON (((5 0, 9 0, 5 4, 5 0)), ((5 5, 6 5, 5 6, 5 5)))", "WKT").region,
      Format::wkb);
  const Region region = read_region(triangle + "\n\n  " + other, "WKB").region;
  EXPECT_EQ(
      wkt(region),
      "MULTIPOLYGON (((0 0, 1 0, 1 0.5, 0 0)), ((5 0, 9 0, 5 4, 5 0)), ((5 5, 6 5, 5 6, 5 5)))");
}

TEST(Wkb, is_what_was_written) {
  std::size_t read = 0;
  for (const Family& family : families()) {
    const Region region = generate(family, family.smallest + 2, 1).p;
    if (not_a_double(region, {})) continue;
    ++read;
    EXPECT_EQ(read_region(written(region, Format::wkb), "WKB").region, region) << family.name;
  }
  EXPECT_GT(read, 10U);
  EXPECT_TRUE(read_region(written(Region{}, Format::wkb), "WKB").region.components.empty());
  const PlanarSet sum =
      read_sum(
          "GEOMETRYCOLLECTION (MULTIPOLYGON (((0 0, 5 0, 0 5, 0 0)), ((9 9, 10 9, 9 10, 9 9))), "
          "LINESTRING (1 1, 2 1), POINT (1 2))",
          "WKT")
          .sum;
  EXPECT_EQ(read_sum(written(sum, Format::wkb), "WKB").sum, sum);
}

TEST(Wkb, of_anything_but_doubles_there_is_none) {
  const Region third = read_region("POLYGON ((0 0, 1 0, 1 1/3, 0 0))", "WKT").region;
  EXPECT_EQ(not_a_double(third, {}), Rational(1, 3));
  EXPECT_EQ(not_a_double({}, {{}, {}, {}, {{Rational(1, 10), 0}}}), Rational(1, 10));
  EXPECT_EQ(not_a_double({}, {{}, {}, {{{0, 0}, {0, Rational(1, 1024)}}}, {}}), std::nullopt);
  EXPECT_TRUE(not_a_double({}, {{}, {}, {}, {{mpz_class(1) << 2000, 0}}}).has_value());
}

/// Whatever is cut off or changed is refused with a line, or read.
TEST(Wkb, that_is_damaged_is_refused_with_a_line) {
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      read_sum(text, "file");
      return "";
    } catch (const InvalidInput& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      return error.what();
    }
  };
  for (const auto& [text, message] : std::map<std::string, std::string>{
           {triangle.substr(0, 60),
            "file:1:19: outer chain of component 1 of 4 vertices; expected no more than follow"},
           {triangle + "00", "file:1:155: 1 byte after the geometry"},
           {triangle + " 00", "file:1:156: more than one word in a line of WKB"},
           {triangle + "\n00", "file:2:3: the end of the input inside a geometry"},
           {triangle + "\n " + triangle.substr(0, 32) + "x", "file:2:34: 'x' in WKB"},
           {triangle + "\n0108000000" + triangle.substr(10), "file:2:3: the geometry type 8"},
           {triangle + "\n" + triangle, "overlap"},
           {triangle.substr(0, 33), "file:1:34: half a byte at the end"},
           {triangle.substr(0, 32) + "x", "file:1:33: 'x' in WKB"},
           {"0108000000" + triangle.substr(10), "file:1:3: the geometry type 8"},
           {"01EB030000" + triangle.substr(10),
            "file:1:19: outer chain of component 1 of 4 vertices; expected no more than follow"},
           {"01A30F0000" + triangle.substr(10), "file:1:3: the geometry type 4003"},
           {"01030000000100000000000000",
            "file:1:19: outer chain of component 1 has 0 vertices; expected at least 3"},
           {"010300000001000000FFFFFF7F" + triangle.substr(26),
            "outer chain of component 1 of 2147483647 vertices"},
           {triangle.substr(0, 26) + "000000000000F07F" + triangle.substr(42), "is not finite"},
           {triangle.substr(0, 122) + "000000000000F03F0000000000000000", "is not closed"}})
    EXPECT_NE(refusal(text).find(message), std::string::npos) << refusal(text);
  const std::string whole = bytes(triangle);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_NE(refusal(whole.substr(0, i)), "") << i;
    for (const char byte : {'\0', '\1', '\7', '\x7f', '\xff'}) {
      std::string changed = whole;
      changed[i] = byte;
      refusal(changed);
    }
  }
}

}  // namespace
}  // namespace oplus
