// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/pages/proof_record.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "properties/runner/temporary_folder.hpp"
#include "reference/io/invalid_input.hpp"

namespace oplus {
namespace {

namespace fs = std::filesystem;

class ProofRecord : public testing::Test {
 protected:
  ProofRecord() {
    write("edges.v",
          "Lemma edges_are : True.\nProof. easy. Qed.\n\n"
          "Theorem edges (a : nat) :\n  a = a.\nProof. easy. Qed.\n");
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  static std::string theorem(const std::string& name, const std::string& extent) {
    return R"([{"statement": "lemma-9", "extent": ")" + extent + R"(", "theorem": ")" + name +
           R"(", "file": "edges.v", "gloss": "g", "covers": "c", "not_covered": "n"}])";
  }
  static std::string query(const std::string& proof, const std::string& twin) {
    return R"({"queries": [{"id": "lemma-9.a", "statement": "lemma-9",
      "file": "a.cpp", "hypotheses": {"one": "x is 1", "two": "y is 2"}, "conclusion": "x is not y",
      "answers": {"proof": {"z3": "unsat", "cvc5": ")" +
           proof + R"("}, "hypotheses": {"z3": "sat", "cvc5": "sat"},
      "twin-one": {"z3": "sat", "cvc5": "sat"}, "twin-two": {"z3": "sat", "cvc5": ")" +
           twin + R"("}}, "counterexamples": {"one": {"x": "2"},
      "two": {"x": "1/2", "f": true, "v.x": "1", "v.y": "2", "d.t": "3/4", "e.t": "5",
      "d.positive": false, "d.slanted": true, "e.positive": true, "e.slanted": false}}}]})";
  }
  void expect_refused(const std::string& what) const {
    try {
      proved_theorems(folder_);
      answered_queries(folder_);
      FAIL() << what;
    } catch (const InvalidInput& e) {
      EXPECT_NE(std::string(e.what()).find(what), std::string::npos) << e.what();
    }
  }

  const TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path();
};

TEST_F(ProofRecord, has_the_formal_statement_of_a_theorem) {
  write("theorems.json", theorem("edges", "part"));
  const std::vector<ProvedTheorem> theorems = proved_theorems(folder_);
  ASSERT_EQ(theorems.size(), 1U);
  EXPECT_EQ(theorems[0].formal, "Theorem edges (a : nat) :\n  a = a.");
  EXPECT_FALSE(theorems[0].is_whole);
  EXPECT_EQ(theorems[0].statement, "lemma-9");
  EXPECT_EQ(theorems[0].not_covered, "n");
}

TEST_F(ProofRecord, has_a_counterexample_without_each_hypothesis) {
  write("results.json", query("unsat", "sat"));
  const std::vector<AnsweredQuery> queries = answered_queries(folder_);
  ASSERT_EQ(queries.size(), 1U);
  ASSERT_EQ(queries[0].hypotheses.size(), 2U);
  EXPECT_EQ(queries[0].hypotheses[0].says, "x is 1");
  EXPECT_EQ(queries[0].hypotheses[0].counterexample, "x = 2");
  EXPECT_EQ(queries[0].hypotheses[1].says, "y is 2");
  EXPECT_EQ(queries[0].file, "a.cpp");
  EXPECT_EQ(queries[0].hypotheses[1].counterexample,
            "x = 1/2, f = true, v = (1, 2), d = (3/4, -1), e = (1, 0)");
}

TEST_F(ProofRecord, refuses_what_is_not_proved) {
  expect_refused("theorems.json:1: cannot be read");
  write("theorems.json", theorem("corners", "whole"));
  expect_refused("edges.v:1: no theorem corners");
  write("theorems.json", theorem("edges", "most"));
  expect_refused("an extent of 'most'");
  write("theorems.json", "[{}]");
  expect_refused("theorems.json:1: ");
  write("theorems.json", theorem("edges", "whole"));
  expect_refused("results.json:1: cannot be read");
  write("results.json", query("none", "sat"));
  expect_refused("lemma-9.a: cvc5 answers \"none\" to proof");
  write("results.json", query("unsat", "unsat"));
  expect_refused("lemma-9.a: cvc5 answers \"unsat\" to twin-two");
  std::string text = query("unsat", "sat");
  write("results.json", text.replace(text.find("\"1/2\""), 5, "\"one\""));
  expect_refused("results.json:1: not a number");
  write("results.json", "{");
  expect_refused("results.json:1: ");
}

}  // namespace
}  // namespace oplus
