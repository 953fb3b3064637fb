// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/registry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "properties/runner/source_tree.hpp"
#include "properties/runner/temporary_folder.hpp"

namespace oplus {
namespace {

const std::vector<Mutant> one_mutant = {{"sign-flipped", "a sign is flipped", "reference/a.cpp"}};

Statement sound_entry() {
  Statement s;
  s.id = "lemma-9.9.9";
  s.title = "A title";
  s.statement = "Something holds.";
  s.why = "It must.";
  s.sources = {{"grid", 5, 1}};
  s.promises = {{"holes", 10}};
  s.kills = {"sign-flipped"};
  s.cases = 10;
  s.check = [](const Summands&) { return Outcome{}; };
  return s;
}

using Defects = std::vector<std::string>;

TEST(Registry, HasNoDefects) {
  EXPECT_EQ(defects_of_entries(statements(), mutants()), Defects{});
  EXPECT_EQ(defects_of_files(statements(), source_root()), Defects{});
}

TEST(Registry, ListsStatementsInTheOrderOfTheirNumbers) {
  std::vector<std::string> ids;
  for (const Statement& s : statements()) ids.push_back(s.id);
  const std::vector<std::string> first = {"theorem-2.2.10", "theorem-2.3.2", "lemma-4.1.4",
                                          "theorem-4.2.1", "fact-convolution-size"};
  auto from = ids.begin();
  for (const std::string& id : first) {
    from = std::find(from, ids.end(), id);
    EXPECT_NE(from, ids.end()) << id;
  }
}

TEST(Registry, KnowsTheFileOfAStatement) {
  EXPECT_EQ(relative_file(Statement{}), "tests/properties/runner/registry_test.cpp");
}

TEST(RegistryDefects, DuplicateId) {
  EXPECT_EQ(defects_of_entries({sound_entry(), sound_entry()}, one_mutant),
            Defects{"lemma-9.9.9: two statements of this id"});
}

TEST(RegistryDefects, DuplicateMutant) {
  EXPECT_EQ(defects_of_entries({sound_entry()}, {one_mutant[0], one_mutant[0]}),
            Defects{"sign-flipped: two mutants of this name"});
}

TEST(RegistryDefects, NoMutant) {
  Statement s = sound_entry();
  s.kills.clear();
  EXPECT_EQ(defects_of_entries({s}, one_mutant),
            (Defects{"lemma-9.9.9: it names no mutant that it kills",
                     "sign-flipped: no statement names this mutant"}));
}

void enumerate_only(Statement& s) {
  s.check = nullptr;
  s.enumerate = [] { return Enumeration{1, ""}; };
  s.cases = 0;
  s.sources.clear();
  s.promises.clear();
}

struct ChangedEntry {
  std::string name;
  std::string defect;  ///< the only one; empty: there is none
  void (*change)(Statement&);
};

class RegistryDefectsOf : public testing::TestWithParam<ChangedEntry> {};

TEST_P(RegistryDefectsOf, AChangedEntry) {
  Statement s = sound_entry();
  GetParam().change(s);
  const std::string& defect = GetParam().defect;
  EXPECT_EQ(defects_of_entries({s}, one_mutant),
            defect.empty() ? Defects{} : Defects{s.id + ": " + defect});
}

const char* const nothing_to_try = "without a check there is nothing to try on pairs";

INSTANTIATE_TEST_SUITE_P(
    , RegistryDefectsOf,
    testing::Values(
        ChangedEntry{"SoundEntry", "", [](Statement&) {}},
        ChangedEntry{"UnknownMutant", "there is no mutant sign-kept",
                     [](Statement& s) { s.kills.push_back("sign-kept"); }},
        ChangedEntry{"IdOfNothing", "the id does not start with a kind",
                     [](Statement& s) { s.id = "lemma"; }},
        ChangedEntry{"UnknownKind", "the id does not start with a kind",
                     [](Statement& s) { s.id = "guess-9.9.9"; }},
        ChangedEntry{"UnknownFamily", "there is no family cubes",
                     [](Statement& s) { s.sources[0].family = "cubes"; }},
        ChangedEntry{"TooSmall", "size or weight of family grid leaves no pair",
                     [](Statement& s) { s.sources[0].largest = 1; }},
        ChangedEntry{"NoFamily", "it names no family", [](Statement& s) { s.sources.clear(); }},
        ChangedEntry{"UnknownClass", "there is no class beauty",
                     [](Statement& s) { s.promises[0].classification = "beauty"; }},
        ChangedEntry{"ShareOfACount", "",
                     [](Statement& s) { s.promises[0].classification = "cases with luck"; }},
        ChangedEntry{"NoShare", "the promised share of holes is no percentage",
                     [](Statement& s) { s.promises[0].percent = 0; }},
        ChangedEntry{"NoCase", "a run has no case", [](Statement& s) { s.cases = 0; }},
        ChangedEntry{"NothingToRun", "it has neither check nor enumeration",
                     [](Statement& s) { s.check = nullptr; }},
        ChangedEntry{"EnumerationOnly", "", enumerate_only},
        ChangedEntry{"EnumerationAndPairs", "",
                     [](Statement& s) { s.enumerate = [] {
                                          return Enumeration{1, ""};
                                        }; }},
        ChangedEntry{"EnumerationWithCases", nothing_to_try,
                     [](Statement& s) { enumerate_only(s), s.cases = 5; }},
        ChangedEntry{"EnumerationWithSources", nothing_to_try,
                     [](Statement& s) { enumerate_only(s), s.sources = sound_entry().sources; }},
        ChangedEntry{"NoEnumerationEither", "it has neither check nor enumeration",
                     [](Statement& s) { enumerate_only(s), s.enumerate = nullptr; }}),
    [](const auto& row) { return row.param.name; });

/// A source tree of its own, removed in the end.
class RegistryFiles : public testing::Test {
 protected:
  RegistryFiles() {
    write("docs/theorems/lemma-9.9.9.md", "");
    std::filesystem::create_directories(root_ / "properties/statements/chapter9");
  }

  void write(const std::string& file, const std::string& text) const {
    std::filesystem::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  Defects defects() const { return defects_of_files({sound_entry()}, root_); }

  const TemporaryFolder temporary_;
  const std::filesystem::path root_ = temporary_.path();
};

TEST_F(RegistryFiles, SoundTreeHasNoDefects) { EXPECT_EQ(defects(), Defects{}); }

TEST_F(RegistryFiles, FileOfAStatementMissing) {
  Statement s = sound_entry();
  s.file = "/nowhere/lemma_9_9_9.cpp";
  EXPECT_EQ(defects_of_files({s}, root_),
            Defects{"lemma-9.9.9: there is no file /nowhere/lemma_9_9_9.cpp"});
}

TEST_F(RegistryFiles, PageOfAStatementMissing) {
  std::filesystem::remove(root_ / "docs/theorems/lemma-9.9.9.md");
  EXPECT_EQ(defects(), Defects{"lemma-9.9.9: there is no page docs/theorems/lemma-9.9.9.md"});
}

TEST_F(RegistryFiles, FileWithoutAStatement) {
  write("properties/statements/chapter9/lemma_9_9_8_left_out.cpp", "");
  write("properties/statements/chapter9/arrangement.cpp", "");
  EXPECT_EQ(defects(),
            Defects{"properties/statements/chapter9/lemma_9_9_8_left_out.cpp: no statement is "
                    "registered from it"});
}

TEST_F(RegistryFiles, LawWithoutAStatement) {
  write("properties/statements/laws/law_left_out.cpp", "");
  write("properties/statements/laws/linear_map.cpp", "");
  EXPECT_EQ(
      defects(),
      Defects{"properties/statements/laws/law_left_out.cpp: no statement is registered from it"});
}

TEST_F(RegistryFiles, NoSourceTree) {
  EXPECT_EQ(defects_of_files({}, "/nowhere"), Defects{"/nowhere: the source tree is not there"});
}

}  // namespace
}  // namespace oplus
