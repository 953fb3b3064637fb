// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "properties/fuzz/reader_check.hpp"

namespace oplus {
namespace {

const std::vector<std::string> valid{
    "4\n0 0\n9 0\n9 9\n0 9/1\n1\n3\n1 1\n1 2.5\n2 1e0\n3 11 11 12 11 11 12\n0\n",
    "POLYGON ((0 0, 9 0, 9 9, 0 9/1, 0 0), (1 1, 1 2.5, 2 1e0, 1 1))",
    "GEOMETRYCOLLECTION (MULTIPOLYGON (((0 0, 9 0, 9 9, 0 0)), ((1 5, 1 8, -2 8, 1 5))),"
    " LINESTRING (5 2, 6 2, 6 3), MULTIPOINT (4 2, (8 3)), POINT EMPTY)",
    R"({"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, "9/1"], [0, 0]]], "a": null})",
    R"({"type": "GeometryCollection", "geometries": [{"type": "MultiPolygon", "coordinates":
        [[[[0, 0], [9, 0], [9, 1e1], [0, 0]]]]}, {"type": "Point", "coordinates": [4, 2]},
        {"type": "LineString", "coordinates": [[5, 2], [6, 2.5]]}]})",
    "SRID=4326;POLYGON Z ((0 0 1, 9 0 1, 9 9 NaN, 0 0 1))\nPOLYGON ((9 9, 10 9, 9 10, 9 9))\n",
    R"({"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": null},
        {"type": "Feature", "geometry": {"type": "Polygon", "coordinates":
         [[[0, 0, 5], [9, 0], [9, "9/1"], [0, 0]]]}}]})",
    "[[[0, 0], [9, 0], [9, 9], [0, 9]], [[1, 1], [1, 2.5], [2, 1e0], [1, 1]]]",
    "M0 0H9V9L0,9/1ZM1 1v1.5l1-1.5Zm11 11 1 0-1 1z"};

/// Numbers straight from the generator's bits, so that every compiler tries the same inputs.
class Mutations {
 public:
  std::string mutated() {
    std::string text = valid[below(valid.size())];
    for (std::size_t changes = 1 + below(3); changes > 0; --changes) change(text);
    return text;
  }

 private:
  std::size_t below(std::size_t bound) { return bits_() % bound; }

  std::string piece() {
    using namespace std::string_literals;
    static const std::string characters = "019-/.e \n,()[]{}\":\\\xff\x01\0"s;
    static const std::vector<std::string> words{"EMPTY", "null", "1e4096", "1/0",
                                                "nan",   "1/3",  "\\u",    "99999999999999999999"};
    const std::size_t i = below(characters.size() + words.size());
    return i < characters.size() ? std::string(1, characters[i]) : words[i - characters.size()];
  }

  void change(std::string& text) {
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = std::min<std::size_t>(below(4), text.size() - at);
    switch (below(4)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, piece());
        break;
      case 2:
        text.replace(at, length, piece());
        break;
      default:
        text.insert(at, text.substr(below(text.size() + 1), below(20)));
    }
  }

  std::mt19937 bits_{20};
};

/// Any input gives either a valid value that can be written and read again, or one line with the place,
/// what is wrong, and what was expected. `check` throws where neither holds.
void expect_value_or_refusal(FuzzOutcome (*check)(std::string_view), int least_accepted) {
  Mutations mutations;
  int accepted = 0;
  int refused = 0;
  for (int i = 0; i < 6000; ++i) {
    const std::string text = mutations.mutated();
    ASSERT_NO_THROW(++(check(text) == FuzzOutcome::reached ? accepted : refused)) << text;
  }
  EXPECT_GT(accepted, least_accepted);
  EXPECT_GT(refused, 3000);
}

TEST(AnyInput, is_a_valid_region_or_refused_in_one_line) {
  expect_value_or_refusal(check_region_reader, 200);
}

TEST(AnyInput, is_a_sum_or_refused_in_one_line) { expect_value_or_refusal(check_sum_reader, 300); }

}  // namespace
}  // namespace oplus
