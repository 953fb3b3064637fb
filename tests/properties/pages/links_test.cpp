// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/pages/links.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "properties/runner/temporary_folder.hpp"

namespace oplus {
namespace {

using Lines = std::vector<std::string>;

TEST(Anchors, AreThoseOfGitHub) {
  EXPECT_EQ(anchor_of("Section 4.2.4: components, `a_b` and m + n"),
            "section-424-components-a_b-and-m--n");
  EXPECT_EQ(anchor_of("The convolution 𝒞"), "the-convolution-𝒞");
}

TEST(Headings, AreOfAllLevelsAndNotInCode) {
  EXPECT_EQ(headings_of("# One\n#include\n### Two\n```\n# three\n```\n    # four\n"),
            (Lines{"One", "Two"}));
}

TEST(CitingPages, AreThosePagesThatLinkToAStatement) {
  const TemporaryFolder docs;
  std::ofstream(docs.path() / "rca.md") << "[a](theorems/a.md), [b](theorems/b.md#proof), "
                                           "[c](../properties/c.cpp), `theorems/d.md`\n";
  std::ofstream(docs.path() / "loops.md") << "[a](theorems/a.md) [again](theorems/a.md)\n";
  std::ofstream(docs.path() / "theorems.md") << "[a](theorems/a.md)\n";
  const std::map<std::string, Lines> expected = {{"a", {"loops", "rca"}}, {"b", {"rca"}}};
  EXPECT_EQ(citing_pages(docs.path()), expected);
}

TEST(Findings, AreLinkedByTheSectionNamed) {
  const Lines headings = {"Findings", "Lemma 2.2.50: another", "Lemmas 2.2.4, Lemma 2.2.5: a case"};
  EXPECT_EQ(
      with_links_to_findings("see docs/findings.md, on Lemma 2.2.5. So", headings),
      "see [docs/findings.md, on Lemma 2.2.5](../findings.md#lemmas-224-lemma-225-a-case). So");
  EXPECT_EQ(with_links_to_findings("(docs/findings.md)", headings),
            "([docs/findings.md](../findings.md))");
  EXPECT_EQ(missing_findings("docs/findings.md, on Lemma 2.2.5 and docs/findings.md", headings),
            Lines{});
  EXPECT_EQ(missing_findings("docs/findings.md, on Lemma 2.2.7, if", headings),
            Lines{"Lemma 2.2.7"});
}

}  // namespace
}  // namespace oplus
