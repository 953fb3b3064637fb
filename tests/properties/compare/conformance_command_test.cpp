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
  conformance("--engine slide --parts nowhere.wkt", 2);
}

TEST_F(ConformanceCommand, refuses_invalid_usage) {
  conformance("", 2);
  conformance("--engine nonsense", 2);
  conformance("--engine slide --part nonsense", 2);
  conformance("--engine slide --budget 0", 2);
  conformance("--engine slide --report r.txt", 2);
  conformance("--engine slide --pair nowhere.dat nowhere.dat", 2);
  conformance("--engine slide --report none/r.md", 2);
  EXPECT_FALSE(files().contains("none"));
  for (const char* const shard : {"0/2", "3/2", "1", "1/", "/2", "1/2/3", "-1/2", "a/b", "1/0"}) {
    const Ran ran = conformance(std::string("--engine slide --shard ") + shard, 2);
    EXPECT_TRUE(has(ran.err, "is invalid; expected I/N"));
  }
}

TEST_F(ConformanceCommand, says_that_nothing_was_compared_where_all_is_refused) {
  const Ran ran = conformance(
      "--engine 'exec:exit 77 #' --part grids --budget 4 --report r.md --report r.json", 2);
  EXPECT_TRUE(has(ran.out, "exec:exit 77 # was compared on no pair: "));
  EXPECT_TRUE(has(ran.err, "compared nothing"));
  EXPECT_TRUE(has(content("r.md"), "**It was compared on no pair**"));
  EXPECT_FALSE(has(ran.out + content("r.md"), "conforms"));
  EXPECT_TRUE(
      has(content("r.md"), "0 failures of 0 kinds, 3 open sums unsupported, 3 refused, 0 skipped"));
  const Ran merged = run("oplus-check merge r.json", 2);
  EXPECT_TRUE(has(merged.err, "compared nothing"));
}

TEST_F(ConformanceCommand, refuses_a_command_that_cannot_be_run) {
  put("no_program", "");
  for (const std::string command : {"./nowhere {p} {q}", "./no_program"}) {
    const Ran ran = conformance("--engine 'exec:" + command + "' --report r.md", 2);
    EXPECT_EQ(ran.lines_of_err(), 1) << ran.err;
    EXPECT_TRUE(has(ran.err, "cannot run exec:" + command));
    EXPECT_FALSE(files().contains("r.md"));
  }
}

TEST_F(ConformanceCommand, gives_the_last_line_of_a_traceback_as_the_reason) {
  put("raises.py", "def f():\n    raise ValueError('odd')\nf()\n");
  const Ran ran =
      conformance("--engine 'exec:python3 raises.py' --part grids --budget 4 --shrink 1", 1);
  EXPECT_TRUE(has(ran.out, "crashed: exit code 1: ValueError: odd"));
}

}  // namespace
}  // namespace oplus
