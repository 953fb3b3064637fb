// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <filesystem>
#include <map>
#include <set>

#include "properties/pages/links.hpp"
#include "properties/runner/source_tree.hpp"
#include "reference/io/file_text.hpp"
#include "tests/checked/cli/page_text.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

namespace fs = std::filesystem;

const fs::path top = source_root();

/// The pages of docs/ itself, by file name.
std::map<std::string, std::string> pages() {
  std::map<std::string, std::string> result;
  for (const auto& entry : fs::directory_iterator(top / "docs"))
    if (entry.path().extension() == ".md")
      result[entry.path().filename().string()] = text_of_file(entry.path());
  return result;
}

class Pages : public Shell {};

TEST_F(Pages, draw_their_pictures) {
  std::set<std::string> drawn;
  for (const auto& [name, page] : pages()) {
    SCOPED_TRACE(name);
    ASSERT_EQ(run("mkdir -p docs/pictures && ln -sfn '" + (top / "docs/shapes").string() +
                  "' docs/shapes")
                  .exit_code,
              0);
    for (const std::string& command : commands_of(page)) {
      const Ran ran = run(boost::algorithm::replace_all_copy(command, "oplus ", "oplus --quiet "));
      ASSERT_EQ(ran.exit_code, 0) << command << '\n' << ran.err;
      // In a pipe, the exit code is that of the last command.
      EXPECT_EQ(ran.err.find("oplus: "), std::string::npos) << command << '\n' << ran.err;
      for (const std::string& picture : found(command, "(docs/pictures/\\S+\\.svg)")) {
        EXPECT_EQ(content(picture), text_of_file(top / picture))
            << picture << " is out of date: " << command;
        drawn.insert(picture);
      }
    }
    for (const std::string& shown : found(page, "\\]\\((pictures/[^)]+)\\)"))
      EXPECT_TRUE(drawn.contains("docs/" + shown)) << shown << " is not drawn on its page";
  }
  // README draws one picture.
  drawn.insert("docs/pictures/room_and_diamond.svg");
  for (const auto& entry : fs::directory_iterator(top / "docs/pictures"))
    EXPECT_TRUE(drawn.contains("docs/pictures/" + entry.path().filename().string()))
        << entry.path() << " is drawn by no page";
}

TEST(AlgorithmPages, show_a_picture_and_what_they_rest_on) {
  const std::map<std::string, std::string> all = pages();
  for (const std::string name : {"cycles.md", "collision.md", "winding.md", "loops.md", "rca.md",
                                 "original_convolution.md"}) {
    ASSERT_TRUE(all.contains(name)) << name;
    const std::string& page = all.at(name);
    EXPECT_FALSE(found(page, "!\\[[^\\]]+\\]\\((pictures/[^)]+\\.svg)\\)").empty()) << name;
    EXPECT_FALSE(found(page, "\\]\\((theorems/[^)]+\\.md)\\)").empty()) << name;
    EXPECT_TRUE(has(page, "](notation.md)")) << name;
    for (const std::string part :
         {"## Cost\n", "## What it rests on", "Tests: `", "## Where it is weak\n"})
      EXPECT_NE(page.find(part), std::string::npos) << name << " lacks " << part;
  }
}

/// Only the statement's own page links to its source.
TEST(AllPages, link_to_the_page_of_a_statement_not_to_its_source) {
  std::size_t statements = 0;
  for (const auto& [name, page] : pages()) {
    EXPECT_EQ(found(page, "(\\]\\([^)]*properties/statements/[^)]+\\.cpp\\))"),
              std::vector<std::string>{})
        << name;
    for (const std::string& link :
         found(page, "(\\[[a-z]+-[0-9a-z.-]+\\]\\(theorems/[^)]+)\\.md\\)")) {
      ++statements;
      const std::string id = link.substr(1, link.find(']') - 1);
      EXPECT_EQ(link, "[" + id + "](theorems/" + id) << name;
    }
  }
  EXPECT_GT(statements, 100U);
}

/// Files, folders, and headings of pages.
TEST(AllPages, link_to_what_exists) {
  std::map<fs::path, std::string> texts = {{top / "README.md", text_of_file(top / "README.md")}};
  for (const auto& entry : fs::recursive_directory_iterator(top / "docs"))
    if (entry.path().extension() == ".md") texts[entry.path()] = text_of_file(entry.path());
  std::size_t links = 0, anchors = 0;
  for (const auto& [path, text] : texts) {
    for (const std::string& link : found(text, "\\]\\(([^)]+)\\)")) {
      if (link.starts_with("http")) continue;
      ++links;
      const std::size_t hash = std::min(link.find('#'), link.size());
      const fs::path file =
          hash == 0 ? path : (path.parent_path() / link.substr(0, hash)).lexically_normal();
      EXPECT_TRUE(fs::exists(file)) << path << " links to " << link;
      if (hash == link.size() || !texts.contains(file)) continue;
      ++anchors;
      const std::vector<std::string> headings = headings_of(texts.at(file));
      EXPECT_TRUE(std::ranges::any_of(
          headings, [&](const std::string& h) { return anchor_of(h) == link.substr(hash + 1); }))
          << path << " links to " << link;
    }
  }
  EXPECT_GT(links, 400U);
  EXPECT_GT(anchors, 10U);
}

/// Files and folders that are named, without a link.
TEST(AllPages, name_files_that_exist) {
  std::size_t names = 0;
  for (const auto& [name, page] : pages()) {
    for (const std::string& path :
         found(page, "`((?:checked|reference|properties|tests)/[a-z0-9_/.]*)`")) {
      ++names;
      EXPECT_TRUE(fs::exists(top / path)) << name << " names " << path;
    }
  }
  EXPECT_GT(names, 20U);
}

TEST(AllPages, are_linked_from_the_readme) {
  const std::string readme = text_of_file(top / "README.md");
  for (const auto& [name, page] : pages())
    EXPECT_NE(readme.find("](docs/" + name + ")"), std::string::npos) << name;
}

}  // namespace
}  // namespace oplus
