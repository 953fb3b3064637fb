// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class ConformanceCommand : public Shell {
 protected:
  ConformanceCommand() { run("mkdir a"); }

  Ran conformance(const std::string& options, int exit_code) {
    return run("oplus-check conformance " + options, exit_code);
  }
};

TEST_F(ConformanceCommand, an_engine_of_oplus_conforms) {
  const std::string options = "--engine slide --budget 60 --seed 5 ";
  const Ran ran = conformance(options + "--report a/c.md --report a/c.json --report a/c.xml", 0);
  EXPECT_TRUE(has(ran.out, "slide conforms: "));
  const auto report = nlohmann::json::parse(content("a/c.json"));
  EXPECT_EQ(report.at("campaign").at("engines"), nlohmann::json({"slide"}));
  EXPECT_EQ(report.at("all").at("disagreed"), 0);
  EXPECT_TRUE(content("a/c.md").starts_with("# Conformance of slide\n"));
  EXPECT_TRUE(content("a/c.xml").starts_with("<?xml"));
  const Ran again =
      conformance(options + "--threads 1 --report two.json --report two.md --json", 0);
  EXPECT_EQ(again.out, content("two.json"));
  EXPECT_EQ(content("two.json"), content("a/c.json"));
  EXPECT_EQ(content("two.md"), content("a/c.md"));
}

TEST_F(ConformanceCommand, is_of_the_parts_of_files_alone_where_there_are) {
  put("two.wkt", "POLYGON((0 0,2 0,2 1,0 1,0 0))\nPOLYGON((0 0,2 0,0 3,0 0))\n");
  conformance("--engine slide --parts two.wkt --parts two.wkt --report r.json", 0);
  const auto report = nlohmann::json::parse(content("r.json"));
  EXPECT_EQ(report.at("pairs"), 8);
  EXPECT_EQ(report.at("all").at("sums").at("passed"), 16);
}

}  // namespace
}  // namespace oplus
