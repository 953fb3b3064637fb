// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "properties/runner/source_tree.hpp"
#include "reference/io/file_text.hpp"
#include "tests/checked/cli/page_text.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class Readme : public Shell {};

TEST_F(Readme, commands_work_and_draw_its_picture) {
  const std::vector<std::string> commands = commands_of(text_of_file(source_root() / "README.md"));
  ASSERT_EQ(commands.size(), 15U);
  // The first computes what the program above it prints.
  const std::string sum = run(commands[0]).out;
  EXPECT_TRUE(sum.starts_with("POLYGON ((")) << sum;
  EXPECT_TRUE(has(text_of_file(source_root() / "docs/examples/cpp/room_and_robot.txt"), sum));
  for (const std::string& command : commands) {
    const Ran ran = run(command);
    const bool unequal = command.find("compare sum.wkt room.wkt") != std::string::npos;
    EXPECT_EQ(ran.exit_code, unequal ? 1 : 0) << command << '\n' << ran.err;
  }
  EXPECT_EQ(content("same.wkt"), content("sum.wkt"));
  EXPECT_EQ(content("picture.svg"),
            text_of_file(source_root() / "docs/pictures/room_and_diamond.svg"))
      << "docs/pictures/room_and_diamond.svg is out of date";
}

}  // namespace
}  // namespace oplus
