// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include "tests/checked/cli/command_line/help_pages.hpp"

namespace oplus {
namespace {

using Words = std::set<std::string>;

class Completion : public HelpPages {
 protected:
  /// What bash offers for the last of these words.
  Words offered(const std::string& words) const {
    const Ran ran = run("eval \"typed=(" + words +
                            ")\"\n"
                            "source <(${typed[0]} completion bash) || exit 1\n"
                            "read -r _ _ function _ <<<\"$(complete -p ${typed[0]})\"\n"
                            "COMP_WORDS=(\"${typed[@]}\")\n"
                            "COMP_CWORD=$((${#typed[@]} - 1))\n"
                            "$function\n"
                            "((${#COMPREPLY[@]} == 0)) || printf '%s\\n' \"${COMPREPLY[@]}\"",
                        0);
    EXPECT_EQ(ran.err, "") << words;
    std::istringstream lines(ran.out);
    Words result;
    for (std::string line; std::getline(lines, line);) result.insert(line);
    return result;
  }
};

TEST_F(Completion, offers_every_command_and_every_option_of_each) {
  for (const std::string& program : programs) {
    const std::vector<std::string> names = commands(program);
    ASSERT_GE(names.size(), 7U);
    EXPECT_EQ(offered(program + " ''"), Words(names.begin(), names.end()));
    const std::vector<std::string> of_program = options(program);
    ASSERT_GE(of_program.size(), 4U);
    EXPECT_EQ(offered(program + " -"), Words(of_program.begin(), of_program.end()));
    for (const std::string& name : names) {
      Words expected(of_program.begin(), of_program.end());
      for (const std::string& option : options(program + " " + name)) expected.insert(option);
      EXPECT_GE(expected.size(), 5U) << name;
      EXPECT_EQ(offered(program + " " + name + " -"), expected) << name;
    }
  }
}

TEST_F(Completion, is_what_the_other_shells_can_read) {
  for (const std::string shell : {"zsh", "fish"}) {
    for (const std::string& program : programs) {
      ASSERT_EQ(run(program + " completion " + shell + " -o script").exit_code, 0);
      EXPECT_NE(content("script").find(program + " --complete "), std::string::npos) << shell;
      run("! command -v " + shell + " >/dev/null || " + shell + " -n script", 0);
    }
  }
}

/// Where fish is installed.
TEST_F(Completion, of_fish_offers_the_same) {
  const Ran ran = run(
      "command -v fish >/dev/null || exit 77; touch 'with space.wkt'\n"
      "fish -c 'oplus completion fish | source; complete -C \"oplus sum --engine=l\";"
      " complete -C \"oplus compare w\"; complete -C \"oplus draw --svg=\"; complete -C \"oplus g\";"
      " complete -C \"oplus batch m\"'");
  if (ran.exit_code == 77) GTEST_SKIP() << "fish is missing";
  EXPECT_EQ(ran.out,
            "--engine=loops\nwith space.wkt\ngen\tWrite a region of a family of test pairs\n"
            "merge\tMerge all shards into the output that one run would have written\n")
      << ran.err;
}

}  // namespace
}  // namespace oplus
