// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "checked/oplus/version.hpp"
#include "checked/version.hpp"
#include "properties/runner/source_tree.hpp"
#include "tests/checked/cli/command_line/help_pages.hpp"

namespace oplus {
namespace {

class Help : public HelpPages {};

/// The lines of a help text that are commands.
std::vector<std::string> example(const std::string& help) {
  std::vector<std::string> commands;
  std::istringstream lines(help.substr(std::min(help.find("Example:"), help.size())));
  for (std::string line; std::getline(lines, line);)
    if (line.rfind("  oplus ", 0) == 0) commands.push_back(line);
  return commands;
}

TEST_F(Help, every_example_works_when_copied) {
  for (const std::string command :
       {"", "sum", "compare", "verify", "certify", "draw", "batch", "batch merge", "reflect",
        "repair", "disc", "transform", "layout", "gen", "distance", "depth", "nfp"}) {
    const Ran help = run("oplus " + command + " --help", 0);
    EXPECT_EQ(help.err, "");
    const std::vector<std::string> commands = example(help.out);
    EXPECT_GE(commands.size(), 3U) << help.out;
    for (const std::string& line : commands) {
      run(line, 0);
    }
  }
}

TEST_F(Help, version_is_that_of_the_build) {
  EXPECT_EQ(version, std::to_string(OPLUS_VERSION_MAJOR) + "." +
                         std::to_string(OPLUS_VERSION_MINOR) + "." +
                         std::to_string(OPLUS_VERSION_PATCH));
  expect_output("oplus --version", "oplus " + std::string(version) + "\n");
  expect_output("oplus -V", "oplus " + std::string(version) + "\n");
  expect_output("oplus-peer --version", "oplus-peer " + std::string(version) + "\n");
}

TEST_F(Help, says_where_the_pages_are_that_it_names) {
  std::size_t names = 0;
  for (const std::string& program : programs)
    for (const std::string& command : commands(program)) {
      const std::string text = help(program + " " + command);
      const std::vector<std::string> pages = found(text, "(docs/[a-z_]+\\.md)");
      names += pages.size();
      for (const std::string& page : pages)
        EXPECT_TRUE(std::filesystem::exists(source_root() / page)) << page;
      EXPECT_EQ(has(text, "share/doc/oplus where oplus is installed"), !pages.empty()) << command;
    }
  EXPECT_GT(names, 20U);
}

TEST_F(Help, of_every_command_says_its_exit_codes) {
  for (const std::string command :
       {"oplus sum", "oplus compare", "oplus verify", "oplus draw", "oplus reflect", "oplus gen",
        "oplus completion", "oplus-check diff", "oplus-check theorems"}) {
    const std::string help = run(command + " --help").out;
    EXPECT_TRUE(has(help, "Exit codes:\n  0  ")) << command;
    EXPECT_TRUE(has(help, "\n  2  ")) << command;
  }
}

}  // namespace
}  // namespace oplus
