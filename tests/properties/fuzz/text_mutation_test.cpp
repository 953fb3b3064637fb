// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/text_mutation.hpp"

#include <gtest/gtest.h>

#include <set>

#include "properties/fuzz/reader_check.hpp"

namespace oplus {
namespace {

constexpr Format formats[] = {Format::dat, Format::wkt, Format::geojson};

TEST(TextMutation, new_texts_are_read) {
  Random random(2);
  for (int i = 0; i < 40; ++i)
    for (const Format format : formats) {
      const std::string region = new_region_text(random, format);
      EXPECT_EQ(check_region_reader(region), FuzzOutcome::reached) << region;
      const std::string sum = new_sum_text(random, format);
      EXPECT_NO_THROW(check_sum_reader(sum)) << sum;
    }
}

/// Neither all read nor all refused: of valid texts a tenth at least stays valid, and a fifth does not.
TEST(TextMutation, keeps_a_share_of_texts_valid) {
  for (const Format format : formats) {
    Random random(3);
    int reached = 0;
    constexpr int cases = 150;
    for (int i = 0; i < cases; ++i) {
      const std::string text = mutated_text(random, new_region_text(random, format), format);
      reached += check_region_reader(text) == FuzzOutcome::reached;
    }
    EXPECT_GT(reached, cases / 10);
    EXPECT_LT(reached, cases * 4 / 5);
  }
}

TEST(TextMutation, every_change_changes_something) {
  for (const TextChange& change : text_changes()) {
    Random random(4);
    bool changed = false;
    for (int i = 0; i < 20 && !changed; ++i)
      for (const Format format : formats) {
        std::string text = new_region_text(random, format);
        const std::string before = text;
        changed = (change.apply(random, text, format) && text != before) || changed;
      }
    EXPECT_TRUE(changed) << change.name;
  }
}

TEST(TextMutation, ends_where_the_last_number_becomes_a_word) {
  Random random(7);
  std::set<std::string> seen;
  for (int i = 0; i < 1000; ++i) seen.insert(mutated_text(random, "7", Format::wkt));
  EXPECT_TRUE(seen.contains("nan"));
}

/// A number is replaced as a whole, whatever stands beside it.
TEST(TextMutation, takes_numbers_as_a_whole) {
  Random random(6);
  std::set<std::string> seen;
  for (int i = 0; i < 200; ++i) {
    std::string text = "POINT (1/3 -2.5e1)";
    for (const TextChange& change : text_changes())
      if (change.name == "copy_number") change.apply(random, text, Format::wkt);
    seen.insert(text);
  }
  EXPECT_EQ(seen, (std::set<std::string>{"POINT (1/3 -2.5e1)", "POINT (1/3 1/3)",
                                         "POINT (-2.5e1 -2.5e1)"}));
}

/// What libFuzzer does of itself: bytes left out, some from elsewhere in the text, any byte.
std::string with_bytes_changed(Random& random, std::string text) {
  const std::size_t from = uniform_index(random, text.size() + 1);
  const std::string part = text.substr(from, uniform_index(random, 32));
  const std::size_t at = uniform_index(random, text.size() + 1);
  text.replace(at, uniform_index(random, 32), part);
  return text.insert(at, 1, static_cast<char>(uniform(random, 0, 255)));
}

TEST(TextMutation, of_nothing_and_of_anything_is_a_text) {
  Random random(5);
  std::string text;
  for (int i = 0; i < 300; ++i) {
    text = with_bytes_changed(random, mutated_text(random, text, formats[i % 3]));
    EXPECT_NO_THROW(check_sum_reader(text)) << text;
    if (text.size() > 2000) text.clear();
  }
}

/// Texts of forms that no fuzz target starts from: any change gives either a valid value that can be written and
/// read again, or one line with the place, what is wrong, and what was expected. The check throws where neither holds.
TEST(TextMutation, of_other_forms_is_a_value_or_refused_in_one_line) {
  const std::vector<std::string> valid{
      "SRID=4326;POLYGON Z ((0 0 1, 9 0 1, 9 9 NaN, 0 0 1))\nPOLYGON ((9 9, 10 9, 9 10, 9 9))\n",
      R"({"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": null},
        {"type": "Feature", "geometry": {"type": "Polygon", "coordinates":
         [[[0, 0, 5], [9, 0], [9, "9/1"], [0, 0]]]}}]})",
      "[[[0, 0], [9, 0], [9, 9], [0, 9]], [[1, 1], [1, 2.5], [2, 1e0], [1, 1]]]",
      "M0 0H9V9L0,9/1ZM1 1v1.5l1-1.5Zm11 11 1 0-1 1z"};
  Random random(20);
  int accepted = 0, refused = 0;
  for (int i = 0; i < 6000; ++i) {
    std::string text = valid[uniform_index(random, valid.size())];
    text = one_in(random, 2) ? with_bytes_changed(random, text)
                             : mutated_text(random, text, formats[uniform_index(random, 3)]);
    for (const auto check : {check_region_reader, check_sum_reader})
      ASSERT_NO_THROW(++(check(text) == FuzzOutcome::reached ? accepted : refused)) << text;
  }
  EXPECT_GT(accepted, 200);
  EXPECT_GT(refused, 3000);
}

}  // namespace
}  // namespace oplus
