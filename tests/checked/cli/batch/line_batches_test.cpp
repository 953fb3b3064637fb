// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/batch/line_batches.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "properties/runner/temporary_folder.hpp"
#include "reference/io/invalid_input.hpp"
#include "reference/io/writing.hpp"

namespace oplus {
namespace {

using Lines = std::vector<std::pair<std::size_t, std::string>>;

class LineBatchesOf : public testing::Test {
 protected:
  std::string file() const { return (folder_.path() / "lines").string(); }

  Lines lines(const std::string& text, std::size_t* count_of_batches = nullptr) const {
    write_file(file(), text);
    LineBatches batches(file());
    EXPECT_EQ(batches.bytes(), text.size());
    Lines result;
    std::size_t count = 0;
    while (const std::optional<LineBatch> batch = batches.next()) {
      ++count;
      EXPECT_FALSE(batch->text.empty());
      each_line(*batch, [&](std::string_view line, std::size_t number) {
        result.emplace_back(number, line);
      });
    }
    if (count_of_batches != nullptr) *count_of_batches = count;
    return result;
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(LineBatchesOf, any_text_are_its_lines) {
  EXPECT_EQ(lines(""), Lines());
  EXPECT_EQ(lines("\n"), (Lines{{1, ""}}));
  EXPECT_EQ(lines("a"), (Lines{{1, "a"}}));
  EXPECT_EQ(lines("a\r\n\nb\r\n"), (Lines{{1, "a"}, {2, ""}, {3, "b"}}));
  EXPECT_EQ(lines("a\nb"), (Lines{{1, "a"}, {2, "b"}}));
  EXPECT_EQ(lines("\xEF\xBB\xBF"
                  "a\nb"),
            (Lines{{1, "a"}, {2, "b"}}));
  EXPECT_EQ(lines("\xEF\xBB"), (Lines{{1, "\xEF\xBB"}}));
}

TEST_F(LineBatchesOf, lines_of_any_length_are_whole) {
  std::string text;
  Lines expected;
  for (const std::size_t length :
       {0UL, 1UL, 8190UL, 8191UL, 8192UL, 8193UL, 3UL, 65535UL, 65536UL, 1000000UL, 70000UL, 5UL}) {
    expected.emplace_back(expected.size() + 1, std::string(length, 'x'));
    text += expected.back().second + '\n';
  }
  std::size_t batches = 0;
  EXPECT_EQ(lines(text, &batches), expected);
  EXPECT_GE(batches, 6U);
  text.pop_back();
  EXPECT_EQ(lines(text), expected);
  std::string many;
  for (int i = 0; i < 100000; ++i) many += std::to_string(i) + '\n';
  const Lines all = lines(many, &batches);
  ASSERT_EQ(all.size(), 100000U);
  for (std::size_t i = 0; i < all.size(); ++i)
    EXPECT_EQ(all[i], std::pair(i + 1, std::to_string(i)));
  EXPECT_LE(batches, 200U);
}

TEST_F(LineBatchesOf, what_cannot_be_read_are_refused) {
  EXPECT_THROW(LineBatches((std::filesystem::path(file()).parent_path() / "missing").string()),
               InvalidInput);
  LineBatches folder(std::filesystem::path(file()).parent_path().string());
  EXPECT_THROW(folder.next(), InvalidInput);
}

}  // namespace
}  // namespace oplus
