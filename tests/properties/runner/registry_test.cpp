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

Defects defects_with(const std::function<void(Statement&)>& change) {
  Statement s = sound_entry();
  change(s);
  return defects_of_entries({s}, one_mutant);
}

TEST(Registry, HasNoDefects) {
  EXPECT_EQ(defects_of_entries(statements(), mutants()), Defects{});
  EXPECT_EQ(defects_of_files(statements(), source_root()), Defects{});
}

TEST(Registry, HoldsTheFirstStatementsInTheOrderOfTheirNumbers) {
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

TEST(Registry, KnowsTheFileThatHoldsAStatement) {
  EXPECT_EQ(relative_file(Statement{}), "tests/properties/runner/registry_test.cpp");
}

TEST(RegistryDefects, NoneInASoundEntry) {
  EXPECT_EQ(defects_with([](Statement&) {}), Defects{});
}

TEST(RegistryDefects, DuplicateId) {
  EXPECT_EQ(defects_of_entries({sound_entry(), sound_entry()}, one_mutant),
            Defects{"lemma-9.9.9: two statements of this id"});
}

TEST(RegistryDefects, NoMutant) {
  EXPECT_EQ(defects_with([](Statement& s) { s.kills.clear(); }),
            (Defects{"lemma-9.9.9: it names no mutant that it kills",
                     "sign-flipped: no statement names this mutant"}));
}

TEST(RegistryDefects, UnknownMutant) {
  EXPECT_EQ(defects_with([](Statement& s) { s.kills.push_back("sign-kept"); }),
            Defects{"lemma-9.9.9: there is no mutant sign-kept"});
}

TEST(RegistryDefects, DuplicateMutant) {
  EXPECT_EQ(defects_of_entries({sound_entry()}, {one_mutant[0], one_mutant[0]}),
            Defects{"sign-flipped: two mutants of this name"});
}

TEST(RegistryDefects, IdWithoutItsKind) {
  EXPECT_EQ(defects_with([](Statement& s) { s.id = "lemma"; }).size(), 1U);
  EXPECT_EQ(defects_with([](Statement& s) { s.id = "guess-9.9.9"; }).size(), 1U);
}

TEST(RegistryDefects, UnknownFamilyOrClassOrNothingToRun) {
  EXPECT_EQ(defects_with([](Statement& s) { s.sources[0].family = "cubes"; }),
            Defects{"lemma-9.9.9: there is no family cubes"});
  EXPECT_EQ(defects_with([](Statement& s) { s.sources[0].largest = 1; }).size(), 1U);
  EXPECT_EQ(defects_with([](Statement& s) { s.sources.clear(); }),
            Defects{"lemma-9.9.9: it names no family"});
  EXPECT_EQ(defects_with([](Statement& s) { s.promises[0].classification = "beauty"; }),
            Defects{"lemma-9.9.9: there is no class beauty"});
  EXPECT_EQ(defects_with([](Statement& s) { s.promises[0].percent = 0; }).size(), 1U);
  EXPECT_EQ(defects_with([](Statement& s) { s.cases = 0; }),
            Defects{"lemma-9.9.9: a run has no case"});
  EXPECT_EQ(defects_with([](Statement& s) { s.check = nullptr; }).size(), 1U);
}

TEST(RegistryDefects, EnumerationInPlaceOfPairs) {
  const auto enumerate_only = [](Statement& s) {
    s.check = nullptr;
    s.enumerate = [] { return Enumeration{1, ""}; };
    s.cases = 0;
    s.sources.clear();
    s.promises.clear();
  };
  EXPECT_EQ(defects_with(enumerate_only), Defects{});
  const Defects nothing_to_try = {"lemma-9.9.9: without a check there is nothing to try on pairs"};
  EXPECT_EQ(defects_with([&](Statement& s) { enumerate_only(s), s.cases = 5; }), nothing_to_try);
  EXPECT_EQ(defects_with([&](Statement& s) {
              enumerate_only(s);
              s.sources = sound_entry().sources;
            }),
            nothing_to_try);
  EXPECT_EQ(defects_with([&](Statement& s) { enumerate_only(s), s.enumerate = nullptr; }),
            Defects{"lemma-9.9.9: it has neither check nor enumeration"});
  EXPECT_EQ(defects_with([](Statement& s) { s.enumerate = [] {
                                              return Enumeration{1, ""};
                                            }; }),
            Defects{});
}

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
