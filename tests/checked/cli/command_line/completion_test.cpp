// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include "tests/checked/cli/command_line/help_pages.hpp"

namespace oplus {
namespace {

using Words = std::set<std::string>;

class Completion : public HelpPages {
 protected:
  void SetUp() override {
    HelpPages::SetUp();
    ASSERT_EQ(run("mkdir parts && touch a.wkt b.wkt 'with space.wkt'").exit_code, 0);
  }

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

const Words all_files = {"a.wkt", "b.wkt", "with space.wkt", "parts"};

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

TEST_F(Completion, offers_names_where_only_they_are_taken) {
  const Words engines = {"slide", "rca", "loops", "winding", "oracle"};
  EXPECT_EQ(offered("oplus sum --engine ''"), engines);
  EXPECT_EQ(offered("oplus sum a.wkt b.wkt --engine ''"), engines);
  EXPECT_EQ(offered("oplus sum --engine = ''"), engines);
  EXPECT_EQ(offered("oplus sum --engine ="), engines);
  EXPECT_EQ(offered("oplus sum --engine l"), Words({"loops"}));
  EXPECT_EQ(offered("oplus sum --format ''"), Words({"wkt", "dat", "geojson", "wkb"}));
  EXPECT_EQ(offered("oplus help re"), Words({"reflect", "repair"}));
  EXPECT_EQ(offered("oplus gen st"), Words({"star"}));
  EXPECT_EQ(offered("oplus gen star --summand ''"), Words({"P", "Q"}));
  EXPECT_EQ(offered("oplus draw --view fa"), Words({"faces"}));
  EXPECT_EQ(offered("oplus --color ''"), Words({"auto", "always", "never"}));
  EXPECT_EQ(offered("oplus --color never s"), Words({"sum"}));
  EXPECT_EQ(offered("oplus completion ''"), Words({"bash", "fish", "zsh"}));
  EXPECT_EQ(offered("oplus-check properties --theorem lemma-4.1."),
            Words({"lemma-4.1.3", "lemma-4.1.4", "lemma-4.1.5", "lemma-4.1.8"}));
  EXPECT_EQ(offered("oplus-check theorems theorem-3"), Words({"theorem-3.2.8", "theorem-3.2.10"}));
  EXPECT_EQ(offered("oplus-check diff --family gri"), Words({"grid"}));
  EXPECT_EQ(offered("oplus-maintain fuzz wk"), Words({"wkt"}));
}

TEST_F(Completion, offers_files_and_folders) {
  for (const std::string words : {"oplus sum ''", "oplus sum a.wkt ''", "oplus sum --engine rca ''",
                                  "oplus sum -o ''", "oplus draw a.wkt a.wkt a.wkt ''",
                                  "oplus-check diff --pair ''", "oplus-check diff --pair a.wkt ''"})
    EXPECT_EQ(offered(words), all_files) << words;
  EXPECT_EQ(offered("oplus compare w"), Words({"with space.wkt"}));
  EXPECT_EQ(offered("oplus-check diff --out ''"), Words({"parts"}));
  Words also = all_files;
  also.insert("merge");
  EXPECT_EQ(offered("oplus batch ''"), also);
  EXPECT_EQ(offered("oplus batch m"), Words({"merge"}));
  EXPECT_EQ(offered("oplus batch merge a.wkt ''"), all_files);
  EXPECT_EQ(offered("oplus batch merge --o"), Words({"--output"}));
}

TEST_F(Completion, offers_nothing_where_nothing_is_known) {
  for (const std::string words : {"oplus sum --threads ''", "oplus sum a.wkt b.wkt ''",
                                  "oplus nonsense ''", "oplus gen star --n ''"})
    EXPECT_EQ(offered(words), Words()) << words;
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
      "command -v fish >/dev/null || exit 77\n"
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
