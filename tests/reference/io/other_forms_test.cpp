// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <functional>

#include "reference/families/rich_regions.hpp"
#include "reference/io/writing.hpp"
#include "tests/reference/io/from_text.hpp"

namespace oplus {
namespace {

// Regions in the forms of text that are read and not written; statement fact-forms-of-input has the others.

Region component_of(const Region& region, std::size_t c) { return {{region.components[c]}}; }

std::string without_line_end(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

std::string in_lines(const Region& region) {
  std::string all;
  for (std::size_t c = 0; c < region.components.size(); ++c)
    all += "SRID=25832;" + wkt(component_of(region, c)) + "\n";
  return all;
}

std::string in_collection(const Region& region) {
  return "GEOMETRYCOLLECTION (POLYGON EMPTY, " + wkt(region) + ")";
}

std::string in_features(const Region& region) {
  std::string all = R"({"type": "FeatureCollection", "features": [)";
  for (std::size_t c = 0; c < region.components.size(); ++c)
    all += (c == 0 ? "" : ", ") +
           (R"({"type": "Feature", "properties": null, "geometry": )" +
            without_line_end(written(component_of(region, c), Format::geojson))) +
           "}";
  return all + "]}\n";
}

std::string in_array(const Region& region) {
  std::string all = "[";
  for (std::size_t c = 0; c < region.components.size(); ++c) {
    const std::string text = written(component_of(region, c), Format::geojson);
    const std::size_t start = text.find('[');
    all += (c == 0 ? "" : ", ") + text.substr(start, text.rfind(']') + 1 - start);
  }
  return all + "]";
}

TEST(OtherForms, of_a_region_are_read_as_the_same_region) {
  const std::vector<std::pair<std::string, std::function<std::string(const Region&)>>> forms{
      {"lines", in_lines},
      {"collection", in_collection},
      {"features", in_features},
      {"array", in_array}};
  const std::vector<Rational> factors{1, {1, 3}, {-1, 10}, Rational("12345678901234567890")};
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const Region plain = i % 3 == 0   ? plain_region(random, 8)
                         : i % 3 == 1 ? holed_region(random, 6)
                                      : scattered_region(random, 6);
    const Rational factor = factors[uniform_index(random, factors.size())];
    const Region region = mapped(plain, [&](const Point& p) {
      return Point{factor * p.x, factor * p.y};
    });
    for (const auto& [name, form] : forms) {
      const std::string text = form(region);
      const ReadRegion read = region_from(text);
      EXPECT_EQ(read.region, region) << name << "\n" << text;
      EXPECT_TRUE(read.notes.empty()) << name << "\n" << text;
    }
  }
}

}  // namespace
}  // namespace oplus
