// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>

#include "properties/runner/source_tree.hpp"
#include "reference/io/writing.hpp"
#include "tests/reference/io/from_text.hpp"

namespace oplus {
namespace {

const Rational third(1, 3);
const Rational large("123456789012345678901234567890123456789");
const Rational huge("1" + std::string(5000, '0'));

struct NamedRegion {
  std::string name;
  Region region;

  friend void PrintTo(const NamedRegion& named, std::ostream* out) { *out << named.name; }
};

class RoundTrip : public testing::TestWithParam<NamedRegion> {
 protected:
  static constexpr Format formats[] = {Format::dat, Format::wkt, Format::geojson};
};

TEST_P(RoundTrip, of_a_region_is_the_identity) {
  for (const Format format : formats) {
    std::ostringstream out;
    write(out, GetParam().region, format);
    const ReadRegion read = region_from(out.str());
    EXPECT_EQ(read.region, GetParam().region) << out.str();
    EXPECT_TRUE(read.notes.empty()) << out.str();
  }
}

TEST_P(RoundTrip, of_a_sum_is_the_identity) {
  const MinkowskiSum sum = canonical_sum(GetParam().region);
  for (const Format format : formats) {
    std::ostringstream out;
    write(out, sum, format);
    const ReadSum read = sum_from(out.str());
    EXPECT_EQ(read.sum, sum) << out.str();
    EXPECT_TRUE(read.notes.empty()) << out.str();
  }
}

TEST_P(RoundTrip, of_a_sum_with_features_is_the_identity) {
  MinkowskiSum sum = canonical_sum(GetParam().region);
  sum.dangling_edges = {{{third, third}, {1, large}}, {{1, 1}, {2, 1}}, {{1, 1}, {2, 2}}};
  sum.isolated_vertices = {{-third, third}, {0, 7}};
  for (const Format format : {Format::wkt, Format::geojson}) {
    std::ostringstream out;
    write(out, sum, format);
    EXPECT_EQ(sum_from(out.str()).sum, sum) << out.str();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Handmade, RoundTrip,
    testing::Values(
        NamedRegion{"empty", {}}, NamedRegion{"triangle", polygon({{0, 0}, {1, 0}, {0, 1}})},
        NamedRegion{"collinear_vertex", polygon({{0, 0}, {1, 0}, {2, 0}, {0, 1}})},
        NamedRegion{"fractions", polygon({{-third, third}, {Rational(22, 7), 0}, {0, 5}})},
        NamedRegion{"decimals", polygon({{Rational(-1, 10), 0}, {Rational(1, 1024), 0}, {0, 5}})},
        NamedRegion{"large_numbers", polygon({{-large, 0}, {large / 3, -large / 8}, {0, 1}})},
        NamedRegion{"huge_numbers", polygon({{0, 0}, {huge, -1 / huge}, {-huge / 3, huge}})},
        NamedRegion{
            "holes",
            {{{box(0, 0, 9, 9), {backwards(box(1, 1, 2, 2)), backwards(box(3, third, 5, 5))}}}}},
        NamedRegion{"components",
                    {{{box(0, 0, 1, 1), {}},
                      {box(2, 0, 5, 5), {backwards(box(3, 3, 4, 4))}},
                      {box(7, 0, 8, 1), {}}}}},
        NamedRegion{"component_in_a_hole",
                    {{{box(0, 0, 9, 9), {backwards(box(1, 1, 8, 8))}}, {box(2, 2, 3, 3), {}}}}},
        NamedRegion{"components_that_touch", {{{box(0, 0, 1, 1), {}}, {box(1, 1, 2, 2), {}}}}},
        NamedRegion{"hole_that_touches_vertices",
                    {{{box(0, 0, 4, 4), {{{0, 0}, {1, 2}, {4, 4}, {2, 1}}}}}}},
        NamedRegion{"hole_that_touches_edges",
                    {{{box(0, 0, 4, 4), {{{0, 2}, {2, 4}, {4, 2}, {2, 0}}}}}}},
        NamedRegion{
            "holes_that_touch",
            {{{box(0, 0, 9, 9), {backwards(box(1, 1, 2, 2)), backwards(box(2, 2, 3, 3))}}}}}),
    [](const auto& test) { return test.param.name; });

class PublishedFile : public testing::TestWithParam<std::string> {};

TEST_P(PublishedFile, is_valid_and_round_trips) {
  const std::filesystem::path path = data_folder() / GetParam();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
  const ReadRegion published = read_region_file(path);
  EXPECT_FALSE(published.region.components.empty());
  const MinkowskiSum sum = canonical_sum(published.region);
  for (const Format format : {Format::dat, Format::wkt, Format::geojson}) {
    std::ostringstream out;
    write(out, published.region, format);
    EXPECT_EQ(region_from(out.str()).region, published.region) << out.str();
    std::ostringstream sum_out;
    write(sum_out, sum, format);
    EXPECT_EQ(sum_from(sum_out.str()).sum, sum) << sum_out.str();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Data, PublishedFile,
    testing::Values("E.dat", "G.dat", "comb_part1.dat", "comb_part2.dat", "deg_square.dat",
                    "fork_part1.dat", "fork_part2.dat", "isolated_vertex_part1.dat",
                    "isolated_vertex_part2.dat", "l_shape.dat", "pwh1.dat", "pwh2.dat", "pwh3.dat",
                    "pwh4.dat", "pwh5.dat", "stars_part1.dat", "stars_part2.dat"),
    [](const auto& test) { return test.param.substr(0, test.param.find('.')); });

}  // namespace
}  // namespace oplus
