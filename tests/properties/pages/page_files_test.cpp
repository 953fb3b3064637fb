// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/pages/page_files.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>

#include "properties/runner/source_tree.hpp"
#include "properties/runner/temporary_folder.hpp"
#include "reference/io/file_text.hpp"
#include "reference/io/invalid_input.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

/// One statement that kills one mutant and is cited by one page.
Registry sound_registry() {
  const Summands pair = {Region{{{{{0, 0}, {1, 0}, {0, 1}}, {}}}},
                         Region{{{{{0, 0}, {2, 0}, {0, 3}}, {}}}}};
  Statement s;
  s.id = "lemma-9.9.9";
  s.title = "Edges exist";
  s.statement = "There are edges.";
  s.why = "See the definition, and docs/findings.md, on Lemma 9.9.9.";
  s.hypotheses = {"P is valid"};
  s.kills = {"sign-flipped"};
  s.promises = {{"holes", 15}};
  s.check = [](const Summands&) { return Outcome{}; };
  s.file = "/nowhere/lemma_9_9_9.cpp";
  return {{s},
          {{"sign-flipped", "a sign is wrong", "reference/a.cpp"}},
          {{s.id,
            {.statement = s.id,
             .enumeration = Enumeration{12, ""},
             .run = 40,
             .discarded = 3,
             .classes = {{"holes", 10}},
             .families = {{"grid", 40}},
             .counts = {{"edges", 99}},
             .typical = pair}}},
          {{"sign-flipped", s.id, true, false, 5, "at (1, 2) it has none", pair, Point{1, 2}}},
          {{s.id, false, "edges_exist", "edges.v", "There is one.", "All.", "Nothing.",
            "Theorem edges_exist : True."}},
          {{"lemma-9.9.9.sign", s.id, "sign.cpp", {{"x is positive", "x = 0"}}, "x is not 0"}},
          {{s.id, {"rca", "slide"}}},
          {"Findings", "Lemma 9.9.9: no edges"}};
}

class PageFiles : public testing::Test {
 protected:
  const TemporaryFolder temporary_;
  const fs::path docs_ = temporary_.path();
};

TEST_F(PageFiles, AreCurrentOnceWritten) {
  const std::vector<Page> pages = all_pages(sound_registry());
  EXPECT_EQ(stale_files(pages, docs_).size(), pages.size());
  write_pages(pages, docs_);
  EXPECT_EQ(stale_files(pages, docs_), Lines{});
}

TEST_F(PageFiles, AreOutOfDateWhereChangedMissingOrSuperfluous) {
  const std::vector<Page> pages = all_pages(sound_registry());
  write_pages(pages, docs_);
  std::ofstream(docs_ / "theorems.md", std::ios::app) << "more\n";
  fs::remove(docs_ / "theorems/lemma-9.9.9.md");
  std::ofstream(docs_ / "theorems/lemma-9.9.8.md") << "of no statement\n";
  std::ofstream(docs_ / "theorems/runs.json") << "a record, not a page\n";
  EXPECT_EQ(stale_files(pages, docs_),
            (Lines{"theorems.md: out of date", "theorems/lemma-9.9.9.md: missing",
                   "theorems/lemma-9.9.8.md: not generated"}));
  write_pages(pages, docs_);
  EXPECT_EQ(stale_files(pages, docs_), Lines{});
  EXPECT_FALSE(fs::exists(docs_ / "theorems/lemma-9.9.8.md"));
  EXPECT_TRUE(fs::exists(docs_ / "theorems/runs.json"));
}

TEST_F(PageFiles, ChangeWithTheirSources) {
  write_pages(all_pages(sound_registry()), docs_);
  const std::string page = "theorems/lemma-9.9.9.md: out of date";
  const auto stale_with = [&](auto change) {
    Registry registry = sound_registry();
    change(registry);
    return stale_files(all_pages(registry), docs_);
  };
  EXPECT_EQ(stale_with([](Registry& r) { r.statements[0].why += "!"; }), Lines{page});
  EXPECT_EQ(stale_with([](Registry& r) { r.statements[0].promises[0].percent = 16; }), Lines{page});
  EXPECT_EQ(stale_with([](Registry& r) { r.statements[0].hypotheses = {}; }), Lines{page});
  EXPECT_EQ(stale_with([](Registry& r) { r.runs.begin()->second.counts["edges"] = 98; }),
            Lines{page});
  EXPECT_EQ(stale_with([](Registry& r) { r.kills[0].cases = 6; }),
            (Lines{"mutants.md: out of date", page}));
  EXPECT_EQ(stale_with([](Registry& r) { r.kills[0].shrunk->p.components[0].outer[1].x = 2; }),
            (Lines{"theorems/pictures/lemma-9.9.9-shrunk.svg: out of date", page}));
  EXPECT_EQ(stale_with([](Registry& r) {
              r.kills[0].at = Point{1, 3};
            }),
            Lines{"theorems/pictures/lemma-9.9.9-shrunk.svg: out of date"});
  EXPECT_EQ(stale_with([](Registry& r) { r.citing.begin()->second.pop_back(); }), Lines{page});
  EXPECT_EQ(stale_with([](Registry& r) { r.findings[1] += " there"; }), Lines{page});
}

TEST_F(PageFiles, LinkWordsPagesThatCiteThemAndFindings) {
  write_pages(all_pages(sound_registry()), docs_);
  const std::string page = text_of_file(docs_ / "theorems/lemma-9.9.9.md");
  for (const std::string part :
       {"[notation](../notation.md)", "Cited by: [rca](../rca.md), [slide](../slide.md).",
        "[docs/findings.md, on Lemma 9.9.9](../findings.md#lemma-999-no-edges)"})
    EXPECT_TRUE(has(page, part));
}

TEST_F(PageFiles, ShowTheShrunkCounterexample) {
  write_pages(all_pages(sound_registry()), docs_);
  EXPECT_TRUE(has(text_of_file(docs_ / "theorems/lemma-9.9.9.md"),
                  "    P: POLYGON ((0 0, 1 0, 0 1, 0 0))\n"
                  "    Q: POLYGON ((0 0, 2 0, 0 3, 0 0))\n"));
  const auto picture = [&](const std::string& which) {
    return text_of_file(docs_ / ("theorems/pictures/lemma-9.9.9-" + which + ".svg"));
  };
  EXPECT_TRUE(has(picture("shrunk"), "where the statement fails"));
  EXPECT_EQ(picture("typical").find("where the statement fails"), std::string::npos);
}

TEST_F(PageFiles, ChangeWithProofs) {
  write_pages(all_pages(sound_registry()), docs_);
  Registry registry = sound_registry();
  registry.theorems[0].formal += "!";
  EXPECT_EQ(stale_files(all_pages(registry), docs_), Lines{"theorems/lemma-9.9.9.md: out of date"});
  registry.theorems[0].is_whole = true;
  EXPECT_EQ(stale_files(all_pages(registry), docs_),
            (Lines{"theorems.md: out of date", "theorems/graph.dot: out of date",
                   "theorems/lemma-9.9.9.md: out of date"}));
  registry = sound_registry();
  registry.queries[0].hypotheses[0].counterexample = "x = -1";
  EXPECT_EQ(stale_files(all_pages(registry), docs_), Lines{"theorems/lemma-9.9.9.md: out of date"});
}

TEST(Records, OfAValidRegistryHaveNoDefect) {
  EXPECT_EQ(defects_of_records(sound_registry()), Lines{});
}

TEST(Records, MustFitTheRegistry) {
  Registry registry = sound_registry();
  registry.statements[0].id = "lemma-9.9.8";
  EXPECT_EQ(
      defects_of_records(registry),
      (Lines{"lemma-9.9.8: no run is recorded", "lemma-9.9.8: no kill of sign-flipped is recorded",
             "lemma-9.9.9: a run is recorded, but there is no such statement",
             "lemma-9.9.9: a kill of sign-flipped is recorded, which it does not name",
             "edges_exist: is to back lemma-9.9.9, but there is no such statement",
             "lemma-9.9.9.sign: is to back lemma-9.9.9, but there is no such statement",
             "docs/rca.md: links to lemma-9.9.9, but there is no such statement"}));
  registry = sound_registry();
  registry.kills[0].killed = false;
  EXPECT_EQ(defects_of_records(registry), Lines{"lemma-9.9.9: has not killed sign-flipped"});
  registry = sound_registry();
  registry.runs.begin()->second.complaints = {"no case was run"};
  EXPECT_EQ(defects_of_records(registry), Lines{"lemma-9.9.9: the recorded run has not passed"});
  registry = sound_registry();
  registry.findings.pop_back();
  EXPECT_EQ(defects_of_records(registry),
            Lines{"lemma-9.9.9: docs/findings.md has no heading with Lemma 9.9.9"});
}

TEST(Records, ThatAreMissingAreInvalidInput) {
  EXPECT_THROW(registry_with_records({"/nowhere", "/nowhere", "/nowhere"}), InvalidInput);
}

/// Each node and each arrow of graph.dot is drawn, and nothing else.
TEST(GraphOfStatements, IsDrawnAsItIs) {
  const fs::path theorems = source_root() / "docs/theorems";
  const std::string dot = text_of_file(theorems / "graph.dot"),
                    svg = text_of_file(theorems / "graph.svg");
  std::istringstream lines(dot);
  std::size_t nodes = 0, arrows = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t label = line.find("[label=\"");
    const std::size_t arrow = line.find("->");
    if (label != std::string::npos) {
      ++nodes;
      const std::string id = line.substr(label + 8, line.find('"', label + 8) - label - 8);
      const std::string drawn_id = std::regex_replace(id, std::regex("-"), "&#45;");
      EXPECT_NE(svg.find(">" + drawn_id + "</text>"), std::string::npos) << id << " is not drawn";
    } else if (arrow != std::string::npos) {
      ++arrows;
      const std::string title =
          "<title>" + line.substr(0, arrow) + "&#45;&gt;" +
          line.substr(arrow + 2, line.find_first_of(" ;", arrow) - arrow - 2) + "</title>";
      EXPECT_NE(svg.find(title), std::string::npos) << line << " is not drawn";
    }
  }
  const auto drawn = [&](const std::string& what) {
    std::size_t count = 0;
    for (std::size_t at = svg.find(what); at != std::string::npos; at = svg.find(what, at + 1))
      ++count;
    return count;
  };
  EXPECT_GT(nodes, 30U);
  EXPECT_EQ(drawn("class=\"node\""), nodes);
  EXPECT_EQ(drawn("class=\"edge\""), arrows);
}

}  // namespace
}  // namespace oplus
