// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "reference/families/family.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"
#include "tests/reference/io/from_text.hpp"

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

TEST(Wkb, is_read_in_bytes_in_either_order) {
  const Region expected = read_region("POLYGON ((0 0, 1 0, 1 0.5, 0 0))", "WKT").region;
  for (const std::string& digits : {triangle, other_order})
    EXPECT_EQ(read_region(bytes(digits), "bytes").region, expected);
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
  const auto refusal_of = [](const std::string& text) {
    const std::string message = refusal([&] { sum_from(text); });
    EXPECT_EQ(message.find('\n'), std::string::npos);
    return message;
  };
  const std::string whole = bytes(triangle);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_NE(refusal_of(whole.substr(0, i)), "accepted") << i;
    for (const char byte : {'\0', '\1', '\7', '\x7f', '\xff'}) {
      std::string changed = whole;
      changed[i] = byte;
      refusal_of(changed);
    }
  }
}

}  // namespace
}  // namespace oplus
