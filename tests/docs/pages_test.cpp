// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <boost/algorithm/string/replace.hpp>
#include <filesystem>
#include <map>
#include <set>

#include "properties/runner/source_tree.hpp"
#include "reference/io/file_text.hpp"
#include "tests/checked/cli/page_text.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

namespace fs = std::filesystem;

const fs::path top = source_root();

/// Those below docs/, by their names.
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
    ASSERT_EQ(run("mkdir -p docs/pictures").exit_code, 0);
    for (const std::string& command : commands_of(page)) {
      const Ran ran = run(boost::algorithm::replace_all_copy(command, "oplus ", "oplus --quiet "));
      ASSERT_EQ(ran.exit_code, 0) << command << '\n' << ran.err;
      // At the head of a pipe its exit code is not that of the command.
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
  // README draws the one picture of its own.
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
    EXPECT_FALSE(found(page, "\\]\\((\\.\\./properties/[^)]+)\\)").empty()) << name;
    for (const std::string part :
         {"## Cost\n", "## What it rests on", "Tests: `", "## Where it is weak\n"})
      EXPECT_NE(page.find(part), std::string::npos) << name << " lacks " << part;
  }
}

TEST(AllPages, link_to_what_exists) {
  std::map<fs::path, std::string> texts = {{top / "README.md", text_of_file(top / "README.md")}};
  for (const auto& [name, page] : pages()) texts[top / "docs" / name] = page;
  for (const auto& entry : fs::directory_iterator(top / "docs/theorems"))
    if (entry.path().extension() == ".md") texts[entry.path()] = text_of_file(entry.path());
  std::size_t links = 0;
  for (const auto& [path, text] : texts) {
    for (const std::string& link : found(text, "\\]\\(([^)#]+)\\)")) {
      if (link.starts_with("http")) continue;
      ++links;
      EXPECT_TRUE(fs::exists(path.parent_path() / link)) << path << " links to " << link;
    }
  }
  EXPECT_GT(links, 400U);
}

/// Files and folders named in code, which are no links.
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

TEST(AllPages, name_statements_by_their_ids) {
  std::size_t statements = 0;
  for (const auto& [name, page] : pages()) {
    for (const std::string& link :
         found(page, "\\[([a-z]+-[0-9a-z.-]+\\]\\(\\.\\./properties/[^)]+)\\)")) {
      ++statements;
      const std::string id = link.substr(0, link.find(']'));
      const std::string file = link.substr(id.size() + 2);
      EXPECT_NE(text_of_file(top / "docs" / file).find(".id = \"" + id + "\""), std::string::npos)
          << name << ": " << id << " is not the id of " << file;
    }
  }
  EXPECT_GT(statements, 20U);
}

TEST(AllPages, are_linked_from_the_readme) {
  const std::string readme = text_of_file(top / "README.md");
  for (const auto& [name, page] : pages())
    EXPECT_NE(readme.find("](docs/" + name + ")"), std::string::npos) << name;
}

}  // namespace
}  // namespace oplus
