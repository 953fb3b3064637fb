// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "reference/chains/region_of.hpp"
#include "reference/io/region_lines.hpp"
#include "reference/io/writing.hpp"
#include "tests/reference/io/from_text.hpp"
#include "tests/reference/io/published_data.hpp"

namespace oplus {
namespace {

const Rational third(1, 3);
const Rational large("123456789012345678901234567890123456789");
const Rational huge("1" + std::string(5000, '0'));

/// Written and read again, a value is the same, and nothing of it is repaired.
void expect_same_again(const Region& region, Format format) {
  const std::string text = written(region, format);
  const ReadRegion read = region_from(text);
  EXPECT_EQ(read.region, region) << text;
  EXPECT_TRUE(read.notes.empty()) << text;
}

void expect_same_again(const PlanarSet& sum, Format format) {
  const std::string text = written(sum, format);
  const ReadSum read = sum_from(text);
  EXPECT_EQ(read.sum, sum) << text;
  EXPECT_TRUE(read.notes.empty()) << text;
}

void expect_round_trips(const Region& region) {
  PlanarSet sum = canonical_sum(region);
  for (const Format format : {Format::dat, Format::wkt, Format::geojson}) {
    expect_same_again(region, format);
    expect_same_again(sum, format);
  }
  sum.dangling_edges = {{{third, third}, {1, large}}, {{1, 1}, {2, 1}}, {{1, 1}, {2, 2}}};
  sum.isolated_vertices = {{-third, third}, {0, 7}};
  for (const Format format : {Format::wkt, Format::geojson}) expect_same_again(sum, format);
}

TEST(RoundTrip, of_regions_and_sums_is_the_identity) {
  std::vector<Shape> all = shapes();
  const std::vector<Shape> more{
      {"empty", {}},
      {"fractions", polygon({{-third, third}, {Rational(22, 7), 0}, {0, 5}})},
      {"decimals", polygon({{Rational(-1, 10), 0}, {Rational(1, 1024), 0}, {0, 5}})},
      {"large numbers", polygon({{-large, 0}, {large / 3, -large / 8}, {0, 1}})},
      {"huge numbers", polygon({{0, 0}, {huge, -1 / huge}, {-huge / 3, huge}})},
      {"holes", holed(box(0, 0, 9, 9), {box(1, 1, 2, 2), box(3, third, 5, 5)})},
      {"components, the second with a hole",
       together({polygon(box(0, 0, 1, 1)), holed(box(2, 0, 5, 5), {box(3, 3, 4, 4)}),
                 polygon(box(7, 0, 8, 1))})},
      {"hole that touches vertices", {{{box(0, 0, 4, 4), {{{0, 0}, {1, 2}, {4, 4}, {2, 1}}}}}}},
      {"hole that touches edges", {{{box(0, 0, 4, 4), {{{0, 2}, {2, 4}, {4, 2}, {2, 0}}}}}}},
      {"holes that touch", holed(box(0, 0, 9, 9), {box(1, 1, 2, 2), box(2, 2, 3, 3)})}};
  all.insert(all.end(), more.begin(), more.end());
  for (const Shape& shape : all) {
    SCOPED_TRACE(shape.name);
    expect_round_trips(shape.region);
  }
}

class PublishedFile : public testing::TestWithParam<std::string> {};

TEST_P(PublishedFile, is_valid_and_round_trips) {
  const Region region = published(GetParam());
  EXPECT_FALSE(region.components.empty());
  expect_round_trips(region);
}

INSTANTIATE_TEST_SUITE_P(Data, PublishedFile,
                         testing::Values("E", "G", "comb_part1", "comb_part2", "deg_square",
                                         "fork_part1", "fork_part2", "isolated_vertex_part1",
                                         "isolated_vertex_part2", "l_shape", "pwh1", "pwh2", "pwh3",
                                         "pwh4", "pwh5", "stars_part1", "stars_part2"),
                         [](const auto& test) { return test.param; });

TEST(PublishedParts, are_valid_and_round_trip) {
  std::size_t parts = 0;
  for (const auto& instance : std::filesystem::directory_iterator(data_folder() / "esicup")) {
    for (const Region& part : read_region_lines(instance.path())) {
      SCOPED_TRACE(instance.path().string() + ": " + std::to_string(++parts));
      expect_round_trips(part);
    }
  }
  EXPECT_EQ(parts, 114U);
}

}  // namespace
}  // namespace oplus
