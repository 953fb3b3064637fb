// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/text_mutation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "properties/fuzz/reader_check.hpp"

namespace oplus {
namespace {

constexpr Format formats[] = {Format::dat, Format::wkt, Format::geojson};

std::string joined(const std::vector<std::string>& tokens) {
  std::string text;
  for (const std::string& token : tokens) text += token;
  return text;
}

TEST(TextMutation, tokens_are_the_text) {
  EXPECT_EQ(tokens("POINT (1/3 -2.5e1)"),
            (std::vector<std::string>{"POINT", " ", "(", "1/3", " ", "-2.5e1", ")"}));
  EXPECT_TRUE(tokens("").empty());
  Random random(1);
  for (const Format format : formats) {
    const std::string text = new_sum_text(random, format);
    EXPECT_EQ(joined(tokens(text)), text);
  }
}

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
        std::vector<std::string> all = tokens(new_region_text(random, format));
        const std::string before = joined(all);
        changed = (change.apply(random, all, format) && joined(all) != before) || changed;
      }
    EXPECT_TRUE(changed) << change.name;
  }
}

TEST(TextMutation, of_nothing_and_of_anything_is_a_text) {
  Random random(5);
  std::string text;
  for (int i = 0; i < 300; ++i) {
    text = mutated_text(random, text, formats[i % 3]);
    text = crossed_text(random, text, i % 2 == 0 ? "" : text);
    EXPECT_NO_THROW(check_sum_reader(text)) << text;
    if (text.size() > 2000) text.clear();
  }
}

}  // namespace
}  // namespace oplus
