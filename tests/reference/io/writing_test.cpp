// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/io/writing.hpp"

#include <gtest/gtest.h>

#include "reference/chains/region_of.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

const Region of_two{{{box(0, 0, 1, 1), {}}, {box(2, 0, 3, 1), {}}}};

PlanarSet with_features(PlanarSet sum) {
  sum.dangling_edges = {{{1, 1}, {2, Rational(1, 3)}}, {{2, 2}, {3, 2}}};
  sum.isolated_vertices = {{1, 2}, {Rational(1, 2), 2}};
  return sum;
}

TEST(Number, that_ends_is_written_as_a_decimal) {
  EXPECT_EQ(to_string(Rational(0)), "0");
  EXPECT_EQ(to_string(Rational(-7)), "-7");
  EXPECT_EQ(to_string(Rational(1200)), "1200");
  EXPECT_EQ(to_string(Rational(1, 2)), "0.5");
  EXPECT_EQ(to_string(Rational(-1, 400)), "-0.0025");
  EXPECT_EQ(to_string(Rational(12345, 1000)), to_string(Rational(2469, 200)));
  EXPECT_EQ(to_string(Rational(2469, 200)), "12.345");
  EXPECT_EQ(to_string(Rational(1, 1024)), "0.0009765625");
  EXPECT_EQ(to_string(Rational(1, 125)), "0.008");
}

TEST(Number, that_does_not_end_is_written_as_a_fraction) {
  EXPECT_EQ(to_string(Rational(1, 3)), "1/3");
  EXPECT_EQ(to_string(Rational(-22, 7)), "-22/7");
  EXPECT_EQ(to_string(Rational(1, 30)), "1/30");
}

TEST(Number, is_rounded_half_away_from_zero) {
  EXPECT_EQ(to_string(Rational(1, 2), 0), "1");
  EXPECT_EQ(to_string(Rational(-1, 2), 0), "-1");
  EXPECT_EQ(to_string(Rational(3, 2), 0), "2");
  EXPECT_EQ(to_string(Rational(5, 2), 0), "3");
  EXPECT_EQ(to_string(Rational(49, 100), 0), "0");
  EXPECT_EQ(to_string(Rational(-49, 100), 0), "0");
  EXPECT_EQ(to_string(Rational(1, 3), 3), "0.333");
  EXPECT_EQ(to_string(Rational(2, 3), 3), "0.667");
  EXPECT_EQ(to_string(Rational(-2, 3), 1), "-0.7");
  EXPECT_EQ(to_string(Rational(245, 100), 1), "2.5");
  EXPECT_EQ(to_string(Rational(999, 1000), 2), "1");
  EXPECT_EQ(to_string(Rational(7), 4), "7");
  EXPECT_EQ(to_string(Rational(1, 4), most_digits), "0.25");
}

TEST(Number, is_written_alike_where_it_needs_more_than_64_bits) {
  const auto text = [](const char* value, std::optional<int> digits = std::nullopt) {
    return to_string(Rational(value), digits);
  };
  EXPECT_EQ(text("18446744073709551615"), "18446744073709551615");
  EXPECT_EQ(text("-18446744073709551616"), "-18446744073709551616");
  EXPECT_EQ(text("18446744073709551615/2"), "9223372036854775807.5");
  EXPECT_EQ(text("-18446744073709551617/2"), "-9223372036854775808.5");
  EXPECT_EQ(text("1/18446744073709551616").size(), 66U);
  EXPECT_EQ(text("18446744073709551615/7"), "18446744073709551615/7");
  EXPECT_EQ(text("7/18446744073709551616000000001"), "7/18446744073709551616000000001");
  EXPECT_EQ(text("9223372036854775807/7", 0), "1317624576693539401");
  EXPECT_EQ(text("9223372036854775807/6", 0), "1537228672809129301");
  EXPECT_EQ(text("18446744073709551615/2", 0), "9223372036854775808");
  EXPECT_EQ(text("18446744073709551613/3", 1), "6148914691236517204.3");
  EXPECT_EQ(text("-1/18446744073709551616", 19), "-0.0000000000000000001");
  EXPECT_EQ(text("-1/18446744073709551616", 18), "0");
}

TEST(Number, of_a_point_is_exact) {
  EXPECT_EQ(to_string(Point{Rational(1, 3), Rational(-1, 2)}), "(1/3, -0.5)");
}

TEST(FormatOf, is_by_the_ending) {
  EXPECT_EQ(format_of("a/b.dat"), Format::dat);
  EXPECT_EQ(format_of("b.wkt"), Format::wkt);
  EXPECT_EQ(format_of("b.json"), Format::geojson);
  EXPECT_EQ(format_of("b.geojson"), Format::geojson);
  EXPECT_EQ(format_of("-"), std::nullopt);
  EXPECT_EQ(format_of("dat"), std::nullopt);
  EXPECT_EQ(format_of("b.dat.gz"), std::nullopt);
}

TEST(Dat, can_hold_a_sum_without_features_only) {
  const PlanarSet sum = canonical_sum(of_two);
  EXPECT_TRUE(can_hold(Format::dat, sum));
  EXPECT_FALSE(can_hold(Format::dat, PlanarSet{{}, {}, {{{0, 0}, {1, 0}}}, {}}));
  EXPECT_FALSE(can_hold(Format::dat, PlanarSet{{}, {}, {}, {{0, 0}}}));
  EXPECT_TRUE(can_hold(Format::wkt, with_features(sum)));
  EXPECT_TRUE(can_hold(Format::geojson, with_features(sum)));
  EXPECT_EQ(written(sum, Format::dat), written(of_two, Format::dat));
}

}  // namespace
}  // namespace oplus
