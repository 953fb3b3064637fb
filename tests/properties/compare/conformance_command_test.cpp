// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class ConformanceCommand : public Shell {
 protected:
  Ran conformance(const std::string& options) { return run("oplus-check conformance " + options); }
};

TEST_F(ConformanceCommand, an_engine_of_oplus_conforms) {
  const std::string options = "--engine slide --budget 60 --seed 5 ";
  const Ran ran = conformance(options + "--report a/c.md --report a/c.json --report a/c.xml");
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  EXPECT_TRUE(has(ran.out, "slide conforms: "));
  const auto report = nlohmann::json::parse(content("a/c.json"));
  EXPECT_EQ(report.at("campaign").at("engines"), nlohmann::json({"slide"}));
  EXPECT_EQ(report.at("all").at("disagreed"), 0);
  EXPECT_TRUE(content("a/c.md").starts_with("# Conformance of slide\n"));
  EXPECT_TRUE(content("a/c.xml").starts_with("<?xml"));
  const Ran again = conformance(options + "--threads 1 --report two.json --report two.md --json");
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(again.out, content("two.json"));
  EXPECT_EQ(content("two.json"), content("a/c.json"));
  EXPECT_EQ(content("two.md"), content("a/c.md"));
}

TEST_F(ConformanceCommand, refuses_requests_without_sense) {
  EXPECT_EQ(conformance("").exit_code, 2);
  EXPECT_EQ(conformance("--engine nonsense").exit_code, 2);
  EXPECT_EQ(conformance("--engine slide --part nonsense").exit_code, 2);
  EXPECT_EQ(conformance("--engine slide --budget 0").exit_code, 2);
  EXPECT_EQ(conformance("--engine slide --report r.txt").exit_code, 2);
  EXPECT_EQ(conformance("--engine slide --pair nowhere.dat nowhere.dat").exit_code, 2);
  for (const char* const shard : {"0/2", "3/2", "1", "1/", "/2", "1/2/3", "-1/2", "a/b", "1/0"}) {
    const Ran ran = conformance(std::string("--engine slide --shard ") + shard);
    EXPECT_EQ(ran.exit_code, 2) << shard;
    EXPECT_TRUE(has(ran.err, "names no shard"));
  }
}

}  // namespace
}  // namespace oplus
