// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/properties_command.hpp"

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
  /// What it writes to both streams; expects that exit code.
  std::string oplus_check(const std::string& arguments, int exit_code) const {
    return run("oplus-check " + arguments + " 2>&1", exit_code).out;
  }
};

TEST_F(PropertiesCommand, WritesTheShrunkPairAndALineThatReplaysIt) {
  const Statement s = triangles_only();
  std::ostringstream out;
  EXPECT_FALSE(run_statements({s}, std::nullopt, 1, folder() / "new" / "folder", out));
  const std::string text = out.str();
  EXPECT_TRUE(has(text, "FAILED: P is no triangle"));
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
  EXPECT_TRUE(has(again.str(), "FAILED: P is no triangle"));
  EXPECT_TRUE(again.str().ends_with("0 passed, 1 failed\n")) << again.str();
}

TEST_F(PropertiesCommand, FindingsOfDifferentPairsHaveDifferentNames) {
  const Family* grid = find_family("grid");
  ASSERT_NE(grid, nullptr);
  const Finding a = write_finding(folder(), "fact-of-a-test", generate(*grid, 5, 1));
  const Finding b = write_finding(folder(), "fact-of-a-test", generate(*grid, 5, 2));
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
  EXPECT_TRUE(run_statements({proved}, std::nullopt, 1, folder(), out));
  EXPECT_TRUE(has(out.str(), "  proved by enumeration, 36 cases\n1 passed, 0 failed\n"));

  std::ostringstream mixed;
  EXPECT_FALSE(run_statements({proved, wrong, empty}, std::nullopt, 1, folder(), mixed));
  EXPECT_TRUE(has(mixed.str(), "FAILED: enumeration: a tie is lost"));
  EXPECT_TRUE(has(mixed.str(), "FAILED: enumeration: no case was enumerated"));
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
  EXPECT_TRUE(has(out.str(), "does not apply: not a pair"));
  EXPECT_TRUE(out.str().ends_with("1 do not apply to this pair\n0 passed, 0 failed\n"));
}

TEST_F(PropertiesCommand, ProgramTriesAPairFromFiles) {
  const Finding finding =
      write_finding(folder(), "pair", generate(*find_family("components"), 4, 5));
  const std::string pair = " --pair " + finding.p.string() + " " + finding.q.string();
  const std::string text = oplus_check("properties" + pair, 0);
  // Some are about simple polygons only.
  EXPECT_TRUE(has(text, "theorem-4.2.14: does not apply: not two simple polygons\n"));
  std::size_t not_applicable = 0;
  for (std::size_t at = text.find("does not apply: "); at != std::string::npos;
       at = text.find("does not apply: ", at + 1))
    ++not_applicable;
  EXPECT_TRUE(text.ends_with(std::to_string(not_applicable) + " do not apply to this pair\n" +
                             std::to_string(statements().size() - not_applicable) +
                             " passed, 0 failed\n"))
      << text;
  oplus_check("properties --cases 5" + pair, 2);
}

TEST_F(PropertiesCommand, ProgramUnderstandsTheLineThatReplays) {
  const Summands pair = generate(*find_family("components"), 4, 5);
  const std::string line =
      replay_line("section-3.2", write_finding(folder() / "it's a folder", "section-3.2", pair));
  const std::string program = "oplus-check ";
  ASSERT_EQ(line.find(program), 0U);
  const std::string text = oplus_check(line.substr(program.size()), 0);
  EXPECT_TRUE(text.ends_with("1 passed, 0 failed\n")) << text;
}

/// A pair from an earlier run, changed since: not tried, and no success.
TEST_F(PropertiesCommand, ProgramRefusesAPairThatIsInvalid) {
  const Finding finding = write_finding(folder(), "pair", generate(*find_family("grid"), 5, 1));
  std::ofstream(finding.q) << "1\n4\n0 0\n1 1\n1 0\n0 1\n";
  const std::string text = oplus_check(
      "properties --theorem lemma-4.1.4 --pair " + finding.p.string() + " " + finding.q.string(),
      2);
  EXPECT_TRUE(has(text, finding.q.string()));
}

TEST_F(PropertiesCommand, ProgramListsStatements) {
  const std::string text = oplus_check("theorems", 0);
  for (const Statement& s : statements()) {
    EXPECT_TRUE(has(text, s.id));
    EXPECT_TRUE(has(text, relative_file(s)));
  }
}

}  // namespace
}  // namespace oplus
