// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/properties_command.hpp"

#include <cstdlib>
#include <sstream>

#include "properties/runner/finding.hpp"
#include "properties/runner/registry.hpp"
#include "reference/io/reading.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

/// Fails where P has a vertex more than a triangle.
Statement triangles_only() {
  Statement s;
  s.id = "fact-triangles-only";
  s.text.title = "P is a triangle";
  s.sources = {{"grid", 6, 1}};
  s.cases = 40;
  s.check = [](const Summands& summands) {
    return vertex_count(summands.p) == 3 ? Outcome{}
                                         : Outcome{Outcome::Kind::fails, "P is no triangle", {}};
  };
  return s;
}

class PropertiesCommand : public Shell {
 protected:
  /// Runs the program; returns its exit code and what it wrote to both streams.
  std::pair<int, std::string> oplus_check(const std::string& arguments,
                                          const std::string& program = "oplus-check") const {
    const Ran ran = run(program + " " + arguments + " 2>&1");
    return {ran.exit_code, ran.out};
  }

  const TemporaryFolder temporary_;
  const std::filesystem::path folder_ = temporary_.path();
};

TEST_F(PropertiesCommand, WritesTheShrunkPairAndALineThatReplaysIt) {
  const Statement s = triangles_only();
  std::ostringstream out;
  EXPECT_FALSE(run_statements({s}, std::nullopt, 1, folder_ / "new" / "folder", out));
  const std::string text = out.str();
  EXPECT_NE(text.find("FAILED: P is no triangle"), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("0 passed, 1 failed\n")) << text;

  const std::string start = "oplus-check properties --theorem fact-triangles-only --pair ";
  const std::size_t line = text.find(start);
  ASSERT_NE(line, std::string::npos) << text;
  std::istringstream files(text.substr(line + start.size()));
  std::string p, q;
  files >> p >> q;
  const Summands replayed{read_region_file(p).region, read_region_file(q).region};
  EXPECT_EQ(vertex_count(replayed.p), 4U);
  EXPECT_EQ(vertex_count(replayed.q), 3U);

  std::ostringstream again;
  EXPECT_FALSE(replay_statements({s}, replayed, again));
  EXPECT_NE(again.str().find("FAILED: P is no triangle"), std::string::npos) << again.str();
  EXPECT_TRUE(again.str().ends_with("0 passed, 1 failed\n")) << again.str();
}

TEST_F(PropertiesCommand, FindingsOfDifferentPairsHaveDifferentNames) {
  const Family* grid = find_family("grid");
  ASSERT_NE(grid, nullptr);
  const Finding a = write_finding(folder_, "fact-of-a-test", generate(*grid, 5, 1));
  const Finding b = write_finding(folder_, "fact-of-a-test", generate(*grid, 5, 2));
  EXPECT_NE(a.p, b.p);
}

TEST_F(PropertiesCommand, EnumerationsAreReportedAndCountedLikeRuns) {
  Statement proved = triangles_only();
  proved.check = nullptr;
  proved.sources.clear();
  proved.enumerate = [] { return Enumeration{36, ""}; };
  Statement wrong = proved, empty = proved;
  wrong.enumerate = [] { return Enumeration{36, "a tie is lost"}; };
  empty.enumerate = [] { return Enumeration{}; };

  std::ostringstream out;
  EXPECT_TRUE(run_statements({proved}, std::nullopt, 1, folder_, out));
  EXPECT_NE(out.str().find("  proved by enumeration, 36 cases\n1 passed, 0 failed\n"),
            std::string::npos)
      << out.str();

  std::ostringstream mixed;
  EXPECT_FALSE(run_statements({proved, wrong, empty}, std::nullopt, 1, folder_, mixed));
  EXPECT_NE(mixed.str().find("FAILED: enumeration: a tie is lost"), std::string::npos);
  EXPECT_NE(mixed.str().find("FAILED: enumeration: no case was enumerated"), std::string::npos);
  EXPECT_TRUE(mixed.str().ends_with("1 passed, 2 failed\n")) << mixed.str();
}

TEST_F(PropertiesCommand, AStatementThatIsOnlyEnumeratedDoesNotApplyToAPair) {
  Statement proved = triangles_only();
  proved.check = nullptr;
  proved.enumerate = [] { return Enumeration{36, ""}; };
  std::ostringstream out;
  EXPECT_FALSE(replay_statements({proved}, {}, out));
  EXPECT_TRUE(out.str().ends_with("1 do not apply to this pair\n0 passed, 0 failed\n"));
}

TEST_F(PropertiesCommand, FailsWhereNoStatementAppliesToThePair) {
  Statement s = triangles_only();
  s.check = [](const Summands&) { return Outcome{Outcome::Kind::discarded, "not a pair", {}}; };
  std::ostringstream out;
  EXPECT_FALSE(replay_statements({s}, {}, out));
  EXPECT_NE(out.str().find("does not apply: not a pair"), std::string::npos);
  EXPECT_TRUE(out.str().ends_with("1 do not apply to this pair\n0 passed, 0 failed\n"));
}

TEST_F(PropertiesCommand, ProgramTriesAPairFromFiles) {
  const Finding finding =
      write_finding(folder_, "pair", generate(*find_family("components"), 4, 5));
  const std::string pair = " --pair " + finding.p.string() + " " + finding.q.string();
  const auto [code, text] = oplus_check("properties" + pair);
  EXPECT_EQ(code, 0) << text;
  // Some are about simple polygons only.
  EXPECT_NE(text.find("theorem-4.2.14: does not apply: not two simple polygons\n"),
            std::string::npos)
      << text;
  std::size_t not_applicable = 0;
  for (std::size_t at = text.find("does not apply: "); at != std::string::npos;
       at = text.find("does not apply: ", at + 1))
    ++not_applicable;
  EXPECT_TRUE(text.ends_with(std::to_string(not_applicable) + " do not apply to this pair\n" +
                             std::to_string(statements().size() - not_applicable) +
                             " passed, 0 failed\n"))
      << text;
  EXPECT_EQ(oplus_check("properties --cases 5" + pair).first, 2);
}

TEST_F(PropertiesCommand, ProgramRefusesInvalidUsage) {
  EXPECT_EQ(oplus_check("").first, 2);
  EXPECT_EQ(oplus_check("properties --cases 0").first, 2);
  EXPECT_EQ(oplus_check("properties --cases many").first, 2);
  EXPECT_EQ(oplus_check("properties --pair only_one.dat").first, 2);
  const auto [code, text] = oplus_check("properties --pair no_such_p.dat no_such_q.dat");
  EXPECT_EQ(code, 2);
  EXPECT_NE(text.find("no_such_p.dat"), std::string::npos) << text;
}

/// RC_PARAMS lets RapidCheck skip a run, cut it short, draw other cases or replay a stale failure.
TEST_F(PropertiesCommand, ProgramIgnoresTheEnvironmentVariablesOfRapidCheck) {
  const std::string run = "properties --theorem fact-convolution-size --cases 60 --seed 3";
  const auto [code, text] = oplus_check(run);
  EXPECT_EQ(code, 0);
  EXPECT_NE(text.find("60 cases run"), std::string::npos) << text;
  // The second string is what RapidCheck itself prints after a failure of some other test.
  for (const char* params : {"max_success=0", "reproduce=BwyehNmchxWZhNEIwdWZyAiMysGcFNHd",
                             "max_size=1 seed=5", "noshrinking=1", "reproduce=", "no parameters"}) {
    ASSERT_EQ(setenv("RC_PARAMS", params, 1), 0);
    EXPECT_EQ(oplus_check(run), std::pair(code, text)) << params;
    unsetenv("RC_PARAMS");
  }
}

TEST_F(PropertiesCommand, ProgramUnderstandsTheLineThatReplays) {
  const Summands pair = generate(*find_family("components"), 4, 5);
  const std::string line =
      replay_line("section-3.2", write_finding(folder_ / "it's a folder", "section-3.2", pair));
  const std::string program = "oplus-check ";
  ASSERT_EQ(line.find(program), 0U);
  const auto [code, text] = oplus_check(line.substr(program.size()));
  EXPECT_EQ(code, 0) << line << '\n' << text;
  EXPECT_TRUE(text.ends_with("1 passed, 0 failed\n")) << text;
}

/// A pair from an earlier run, changed since: not tried, and no success.
TEST_F(PropertiesCommand, ProgramRefusesAPairThatIsInvalid) {
  const Finding finding = write_finding(folder_, "pair", generate(*find_family("grid"), 5, 1));
  std::ofstream(finding.q) << "1\n4\n0 0\n1 1\n1 0\n0 1\n";
  const auto [code, text] = oplus_check("properties --theorem lemma-4.1.4 --pair " +
                                        finding.p.string() + " " + finding.q.string());
  EXPECT_EQ(code, 2) << text;
  EXPECT_NE(text.find(finding.q.string()), std::string::npos) << text;
}

TEST_F(PropertiesCommand, ProgramListsStatements) {
  const auto [code, text] = oplus_check("theorems");
  EXPECT_EQ(code, 0);
  for (const Statement& s : statements()) {
    EXPECT_NE(text.find(s.id), std::string::npos) << text;
    EXPECT_NE(text.find(relative_file(s)), std::string::npos) << text;
  }
  const auto [entry_code, entry] = oplus_check("theorems theorem-2.3.2");
  EXPECT_EQ(entry_code, 0);
  EXPECT_NE(entry.find("reflex"), std::string::npos) << entry;
  const auto [proved_code, proved] = oplus_check("theorems lemma-4.1.4");
  EXPECT_EQ(proved_code, 0);
  for (const char* part : {"\nBacked by: machine-checked as printed, ", "; sampled, ", " pairs\n",
                           "\nPage: docs/theorems/lemma-4.1.4.md\n"})
    EXPECT_NE(proved.find(part), std::string::npos) << part << " in " << proved;
}

TEST_F(PropertiesCommand, ProgramSuggestsTheNearestStatement) {
  for (const std::string command : {"theorems", "properties --theorem"}) {
    const auto [code, text] = oplus_check(command + " lema-4.1.4");
    EXPECT_EQ(code, 2);
    EXPECT_EQ(text,
              "oplus-check: unknown statement 'lema-4.1.4'; did you mean lemma-4.1.4? 'oplus-check "
              "theorems' lists all\n");
  }
  const auto [code, text] = oplus_check("theorems gravity");
  EXPECT_EQ(code, 2);
  EXPECT_EQ(text, "oplus-check: unknown statement 'gravity'; 'oplus-check theorems' lists all\n");
}

}  // namespace
}  // namespace oplus
