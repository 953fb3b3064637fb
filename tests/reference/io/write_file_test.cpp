// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <iterator>
#include <string>
#include <system_error>

#include "properties/runner/temporary_folder.hpp"
#include "reference/io/file_text.hpp"
#include "reference/io/writing.hpp"

namespace oplus {
namespace {

namespace fs = std::filesystem;

class WriteFile : public testing::Test {
 protected:
  static std::string content(const fs::path& path) {
    return text_of_file(path, "what was written");
  }

  std::ptrdiff_t entries() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  const TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path();
};

TEST_F(WriteFile, makes_a_file) {
  const std::string text("a\0b\n", 4);
  write_file(folder_ / "new", text);
  EXPECT_EQ(content(folder_ / "new"), text);
  EXPECT_EQ(entries(), 1);
}

TEST_F(WriteFile, replaces_a_file_and_keeps_its_mode) {
  write_file(folder_ / "file", "a longer text");
  fs::permissions(folder_ / "file", fs::perms::owner_read | fs::perms::owner_write);
  write_file(folder_ / "file", "short");
  EXPECT_EQ(content(folder_ / "file"), "short");
  EXPECT_EQ(fs::status(folder_ / "file").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(entries(), 1);
}

TEST_F(WriteFile, never_changes_the_old_file_itself) {
  write_file(folder_ / "file", "old");
  fs::create_hard_link(folder_ / "file", folder_ / "other");
  write_file(folder_ / "file", "new");
  EXPECT_EQ(content(folder_ / "other"), "old");
}

TEST_F(WriteFile, keeps_links) {
  write_file(folder_ / "file", "old");
  fs::create_symlink("file", folder_ / "link");
  write_file(folder_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(content(folder_ / "file"), "new");
}

TEST_F(WriteFile, leaves_nothing_behind_where_it_fails) {
  fs::create_directory(folder_ / "is_a_folder");
  EXPECT_THROW(write_file(folder_ / "is_a_folder", "text"), std::system_error);
  EXPECT_THROW(write_file(folder_ / "absent" / "file", "text"), std::system_error);
  EXPECT_EQ(entries(), 1);
}

TEST_F(WriteFile, says_what_failed) {
  const std::string path = folder_ / "absent" / "file";
  try {
    write_file(path, "text");
    FAIL() << "written";
  } catch (const std::system_error& failed) {
    EXPECT_EQ(failed.code(), std::errc::no_such_file_or_directory);
    EXPECT_EQ(std::string(failed.what()), "cannot write " + path + ": No such file or directory");
  }
}

TEST_F(WriteFile, writes_to_a_device_and_does_not_replace_it) {
  write_file("/dev/null", "text");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_THROW(write_file("/dev/full", "text"), std::system_error);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(WriteFile, dash_is_standard_output) {
  testing::internal::CaptureStdout();
  write_file("-", "text\n");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "text\n");
  EXPECT_FALSE(fs::exists("-"));
}

}  // namespace
}  // namespace oplus
