// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "properties/runner/source_tree.hpp"
#include "reference/io/file_text.hpp"
#include "tests/checked/cli/page_text.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class CertifyCommand : public Shell {};

TEST_F(CertifyCommand, has_a_page_that_shows_what_its_commands_print) {
  const std::string page = text_of_file(source_root() / "docs/certificates.md");
  const std::vector<std::string> commands = commands_of(page);
  ASSERT_EQ(commands.size(), 2U);
  for (const std::string& command : commands)
    EXPECT_TRUE(has(page, "\nprints\n\n```\n" + run(command).out + "```\n"));
}

}  // namespace
}  // namespace oplus
