// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

/// Scripts of a line stand for the fuzz programs, which another build makes.
class FuzzCommand : public Shell {
 protected:
  /// `script` is what oplus-fuzz-dat does.
  Ran fuzz_dat(const std::string& script, const std::string& options, int exit_code) const {
    put("program", "#!/bin/sh\n" + script + "\n");
    return run(
        "mkdir bin && mv program bin/oplus-fuzz-dat && chmod +x bin/oplus-fuzz-dat\n"
        "oplus-maintain fuzz dat --binaries bin " +
            options,
        exit_code);
  }
};

constexpr const char* good =
    "echo '#9 DONE   cov: 77 ft: 9'; echo 'stat::number_of_executed_units: 9'; "
    "echo 'oplus: reached 4, rejected 5' >&2";

TEST_F(FuzzCommand, lists_its_targets) {
  const Ran ran = run("oplus-maintain fuzz --list", 0);
  for (const std::string target : {"dat", "wkt", "geojson", "sums", "layouts", "slide"})
    EXPECT_TRUE(has("\n" + ran.out, "\n" + target + " "));
}

TEST_F(FuzzCommand, reports_a_run) {
  const Ran ran = fuzz_dat(good, "--runs 9", 0);
  EXPECT_EQ(ran.out, "dat      9 runs, 77 edges, 4 inputs reached, 5 rejected; no finding\n");
}

TEST_F(FuzzCommand, passes_its_options_to_the_program) {
  fuzz_dat("echo \"$@\"", "--seconds 7 --seed 3 --corpus kept --out found", 0);
  const std::string log = content("found/dat.log");
  for (const std::string argument :
       {"-seed=3 ", "-entropic=0 ", "-max_total_time=7 ", "-artifact_prefix=found/dat-",
        " kept/dat ", "/seeds/dat", "/dictionaries/dat.dict"})
    EXPECT_TRUE(has(log, argument));
}

TEST_F(FuzzCommand, has_exit_code_one_for_a_finding) {
  const Ran ran = fuzz_dat("echo 'oplus: finding: wrong'; exit 77", "--json", 1);
  EXPECT_EQ(nlohmann::json::parse(ran.out).at("targets").at(0).at("finding"), "wrong");
}

TEST_F(FuzzCommand, says_how_to_build_what_is_missing) {
  const Ran ran = run("mkdir none && oplus-maintain fuzz dat --binaries none", 2);
  EXPECT_EQ(ran.lines_of_err(), 1);
  EXPECT_TRUE(has(ran.err, "cmake --preset fuzz && cmake --build --preset fuzz"));
}

TEST_F(FuzzCommand, shows_the_pair_of_an_input) {
  put("p.wkt", "POLYGON ((0 0, 4 0, 0 4, 0 0))");
  put("q.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 0))");
  const Ran ran =
      run("oplus-maintain fuzz --encode p.wkt q.wkt input && "
          "oplus-maintain fuzz slide --show input --out shown",
          0);
  EXPECT_TRUE(has(ran.out, "P: POLYGON ((0 0, 4 0, 0 4, 0 0))"));
  EXPECT_TRUE(has(ran.out, "no finding"));
  run("ls shown/*-p.dat shown/*-q.dat", 0);
}

TEST_F(FuzzCommand, refuses_a_pair_that_cannot_be_an_input) {
  put("p.wkt", "POLYGON ((0 0, 400 0, 0 4, 0 0))");
  const Ran ran = run("oplus-maintain fuzz --encode p.wkt p.wkt input", 2);
  EXPECT_EQ(ran.lines_of_err(), 1);
}

}  // namespace
}  // namespace oplus
