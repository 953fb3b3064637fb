// SPDX-License-Identifier: GPL-3.0-or-later
#include <sstream>

#include "properties/runner/source_tree.hpp"
#include "reference/io/file_text.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

std::string text_of(const std::string& path) {
  return text_of_file(source_root() / path, "a file of ours");
}

class Readme : public Shell {};

/// The lines of "Five minutes" that call `oplus`, in their order.
std::vector<std::string> commands_of_readme() {
  std::vector<std::string> commands;
  std::istringstream readme(text_of("README.md"));
  for (std::string line; std::getline(readme, line);) {
    if (line.starts_with("    oplus ")) commands.push_back(line.substr(4, line.find(" #") - 4));
  }
  return commands;
}

TEST_F(Readme, commands_do_what_it_says_and_draw_its_picture) {
  const std::vector<std::string> commands = commands_of_readme();
  ASSERT_EQ(commands.size(), 11U);
  for (const std::string& command : commands) {
    const Ran ran = run(command);
    const bool unequal = command.find("compare sum.wkt room.wkt") != std::string::npos;
    EXPECT_EQ(ran.exit_code, unequal ? 1 : 0) << command << '\n' << ran.err;
  }
  EXPECT_EQ(content("same.wkt"), content("sum.wkt"));
  EXPECT_EQ(content("picture.svg"), text_of("docs/pictures/room_and_diamond.svg"))
      << "docs/pictures/room_and_diamond.svg is out of date";
}

}  // namespace
}  // namespace oplus
