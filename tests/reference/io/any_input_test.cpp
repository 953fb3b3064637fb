// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "reference/definitions/validity.hpp"
#include "reference/io/writing.hpp"
#include "tests/reference/io/from_text.hpp"

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
        {"type": "LineString", "coordinates": [[5, 2], [6, 2.5]]}]})"};

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

  void change(std::string& text) {
    static const std::vector<std::string> pieces{"0",      "1",
                                                 "9",      "-",
                                                 "/",      ".",
                                                 "e",      " ",
                                                 "\n",     ",",
                                                 "(",      ")",
                                                 "[",      "]",
                                                 "{",      "}",
                                                 "\"",     ":",
                                                 "EMPTY",  "null",
                                                 "1e4096", "1/0",
                                                 "nan",    "1/3",
                                                 "\\",     "\\u",
                                                 "\xff",   "99999999999999999999",
                                                 "\x01",   std::string(1, '\0')};
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = std::min<std::size_t>(below(4), text.size() - at);
    switch (below(4)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, pieces[below(pieces.size())]);
        break;
      case 2:
        text.replace(at, length, pieces[below(pieces.size())]);
        break;
      default:
        text.insert(at, text.substr(below(text.size() + 1), below(20)));
    }
  }

  std::mt19937 bits_{20};
};

bool is_one_line(std::string_view message) {
  return std::all_of(message.begin(), message.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

/// Whatever the input: either a valid value that survives being written, or one line that says
/// where, what and what else. `read` returns the value; `written` its texts.
template <typename Read, typename Written>
void expect_value_or_one_line(Read read, Written written, int least_accepted) {
  Mutations mutations;
  int accepted = 0;
  int refused = 0;
  for (int i = 0; i < 6000; ++i) {
    const std::string text = mutations.mutated();
    decltype(read(text)) value;
    const std::string message = refusal([&] { value = read(text); });
    if (message == "accepted") {
      ++accepted;
      for (const std::string& again : written(value)) ASSERT_EQ(read(again), value) << text;
    } else {
      ++refused;
      ASSERT_TRUE(is_one_line(message)) << message;
      ASSERT_TRUE(message.starts_with("file:")) << message;
      ASSERT_NE(message.find("; expected "), std::string::npos) << message;
    }
  }
  EXPECT_GT(accepted, least_accepted);
  EXPECT_GT(refused, 3000);
}

template <typename Value>
std::vector<std::string> texts_of(const Value& value) {
  std::vector<std::string> texts;
  for (const Format format : {Format::dat, Format::wkt, Format::geojson}) {
    if constexpr (std::is_same_v<Value, MinkowskiSum>)
      if (!can_hold(format, value)) continue;
    std::ostringstream out;
    write(out, value, format);
    texts.push_back(out.str());
  }
  return texts;
}

TEST(AnyInput, is_a_valid_region_or_refused_in_one_line) {
  expect_value_or_one_line([](const std::string& text) { return region_from(text).region; },
                           [](const Region& region) {
                             EXPECT_FALSE(find_defect(region));
                             return texts_of(region);
                           },
                           200);
}

TEST(AnyInput, is_a_sum_or_refused_in_one_line) {
  expect_value_or_one_line([](const std::string& text) { return sum_from(text).sum; },
                           texts_of<MinkowskiSum>, 300);
}

}  // namespace
}  // namespace oplus
