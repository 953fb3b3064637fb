// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <boost/algorithm/string.hpp>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "properties/runner/child_process.hpp"
#include "properties/runner/source_tree.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

using Cells = std::vector<std::string>;

/// A CSV without quotes: the header, then the rows.
std::vector<Cells> cells(const std::string& csv) {
  std::vector<Cells> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);)
    boost::split(rows.emplace_back(), line, boost::is_any_of(","));
  return rows;
}

/// The cells of a column, by its header.
Cells column(const std::string& csv, const std::string& name) {
  const std::vector<Cells> rows = cells(csv);
  const Cells& header = rows.at(0);
  const auto at = std::find(header.begin(), header.end(), name) - header.begin();
  Cells result;
  for (const Cells& row : rows) result.push_back(row.at(static_cast<std::size_t>(at)));
  return {result.begin() + 1, result.end()};
}

class ExperimentsCommand : public Shell {
 protected:
  Ran experiments(const std::string& options, const std::string& before = "") {
    return run(before + "'" + program_beside("oplus-bench") + "' experiments " + options);
  }

  std::string out(const std::string& file) const { return content("oplus-experiments/" + file); }

  std::set<std::string> written() const {
    std::istringstream names(run("ls oplus-experiments").out);
    return {std::istream_iterator<std::string>(names), {}};
  }

  /// Runs the smallest size of an experiment. Expects a table of this many rows whose cells all have a
  /// header, its page, these plots, and an index that names them.
  void expect_written(const std::string& name, std::size_t rows, const Cells& plots) {
    const Ran ran = experiments("--scale 0 --only " + name);
    EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
    EXPECT_EQ(ran.err, "");
    std::set<std::string> expected = {"index.md", name + ".csv", name + ".md"};
    for (const std::string& plot : plots) {
      expected.insert({plot + ".gp", plot + ".svg"});
      EXPECT_NE(out(plot + ".svg").find("</svg>"), std::string::npos) << plot;
      EXPECT_LT(out(plot + ".svg").size(), 100'000U) << plot;
      EXPECT_NE(out("index.md").find("(" + plot + ".svg)"), std::string::npos) << plot;
    }
    EXPECT_EQ(written(), expected);
    const std::vector<Cells> table = cells(out(name + ".csv"));
    ASSERT_EQ(table.size(), rows + 1);
    EXPECT_EQ(std::set<std::string>(table[0].begin(), table[0].end()).size(), table[0].size());
    for (const Cells& row : table) EXPECT_EQ(row.size(), table[0].size());
    EXPECT_NE(out("index.md").find("](" + name + ".md)"), std::string::npos);
  }
};

TEST_F(ExperimentsCommand, convex_star) {
  expect_written("convex-star", 1, {"figure-6.9", "figure-6.20a"});
  EXPECT_EQ(column(out("convex-star.csv"), "m"), Cells({"50"}));
  EXPECT_EQ(column(out("convex-star.csv"), "n"), Cells({"100"}));
  EXPECT_EQ(column(out("convex-star.csv"), "same_sum"), Cells({"true"}));
}

TEST_F(ExperimentsCommand, star_star) { expect_written("star-star", 1, {"figure-6.10"}); }

TEST_F(ExperimentsCommand, simple_simple) {
  expect_written("simple-simple", 1, {"figure-6.11", "figure-6.12", "figure-6.13", "figure-6.20b"});
}

TEST_F(ExperimentsCommand, fork_l) {
  expect_written("fork-l", 1, {"figure-6.14", "figure-6.15", "figure-6.16", "fork-ratio"});
  EXPECT_EQ(column(out("fork-l.csv"), "sum_holes"), Cells({"100"}));
  EXPECT_EQ(column(out("fork-l.csv"), "rca_hole_tests"), Cells({"100"}));
}

TEST_F(ExperimentsCommand, cycles) {
  expect_written("cycles", 4, {"cycles-factor", "cycles-steps"});
  EXPECT_EQ(column(out("cycles.csv"), "same_segments"), Cells(4, "true"));
  for (const std::string& share : column(out("cycles.csv"), "steps_by_bound"))
    EXPECT_LT(std::stod(share), 1);
}

TEST_F(ExperimentsCommand, table_6_1_measures_existing_pairs_and_counts_missing_ones) {
  expect_written("table-6.1", 9, {});
  std::size_t there = 0;
  for (const std::string name :
       {"cavity", "chain", "comb", "conc_chain", "fork", "knife", "rand3015", "random", "stars"})
    there += std::filesystem::exists(data_folder() / (name + "_part1.dat"));
  EXPECT_NE(out("index.md")
                .find(std::to_string(there) + " pairs measured, " + std::to_string(9 - there) +
                      " skipped"),
            std::string::npos);
  const auto count = [&](const std::string& name, const std::string& cell) {
    const Cells all = column(out("table-6.1.csv"), name);
    return static_cast<std::size_t>(std::count(all.begin(), all.end(), cell));
  };
  EXPECT_EQ(count("same_rca_edges", "true"), there);
  EXPECT_EQ(count("rca_outcome", "missing"), 9 - there);
}

TEST_F(ExperimentsCommand, hole_tests) {
  const Ran ran = experiments("--scale 0 --only hole-tests");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  const Cells outcomes = column(out("hole-tests.csv"), "sweep_outcome");
  EXPECT_GE(outcomes.size(), 4U);
  EXPECT_EQ(outcomes, Cells(outcomes.size(), "done"));
  const Cells order = column(out("hole-tests.csv"), "order");
  EXPECT_EQ(std::count(order.back().begin(), order.back().end(), '<'), 3);
  EXPECT_TRUE(written().contains("hole-tests-fork.svg"));
  EXPECT_TRUE(written().contains("hole-tests-simple.svg"));
}

TEST_F(ExperimentsCommand, same_seed_same_sizes_another_seed_others) {
  const auto sizes = [&](const std::string& folder, const std::string& seed) {
    const Ran ran =
        experiments("--scale 0 --only cycles --only fork-l --seed " + seed + " --out " + folder);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    Cells all = column(content(folder + "/cycles.csv"), "segments");
    for (const std::string edges : {"rca_edges", "winding_edges", "sum_edges"}) {
      const Cells more = column(content(folder + "/fork-l.csv"), edges);
      all.insert(all.end(), more.begin(), more.end());
    }
    return all;
  };
  const Cells first = sizes("one", "3");
  EXPECT_EQ(first, sizes("two", "3"));
  EXPECT_NE(first, sizes("three", "4"));
}

TEST_F(ExperimentsCommand, a_measurement_that_runs_out_of_memory_is_a_row) {
  const Ran ran = experiments("--scale 0 --only fork-l --memory 1");
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(column(out("fork-l.csv"), "rca_outcome"), Cells({"out of memory"}));
  EXPECT_EQ(column(out("fork-l.csv"), "winding_outcome"), Cells({"out of memory"}));
  EXPECT_EQ(column(out("fork-l.csv"), "ratio"), Cells({""}));
  EXPECT_EQ(written(), std::set<std::string>({"fork-l.csv", "fork-l.md", "index.md"}));
}

TEST_F(ExperimentsCommand, without_gnuplot_tables_are_written_and_one_line_says_so) {
  const Ran ran = experiments("--scale 0 --only fork-l", "PATH=/nowhere\n");
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_EQ(ran.lines_of_err(), 1) << ran.err;
  EXPECT_NE(ran.err.find("gnuplot is missing"), std::string::npos) << ran.err;
  EXPECT_EQ(cells(out("fork-l.csv")).size(), 2U);
  EXPECT_TRUE(written().contains("figure-6.14.gp"));
  EXPECT_FALSE(written().contains("figure-6.14.svg"));
}

TEST_F(ExperimentsCommand, a_gnuplot_that_fails_is_named) {
  put("gnuplot", "#!/bin/sh\nexit 1\n");
  const Ran ran = experiments("--scale 0 --only cycles", "chmod +x gnuplot\nPATH=\"$PWD:$PATH\"\n");
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_EQ(ran.err, "oplus-bench: gnuplot failed on cycles-factor cycles-steps\n");
}

TEST_F(ExperimentsCommand, refuses_invalid_usage_in_one_line) {
  put("file", "");
  for (const std::string options :
       {"--only nonsense", "--scale -1", "--scale x", "--scale nan", "--seed x", "--memory -1",
        "--memory x", "--rows x", "--nonsense", "nonsense", "--out file", "--out file/folder"}) {
    const Ran ran = experiments(options + " --only fork-l");
    EXPECT_EQ(ran.exit_code, 2) << options << '\n' << ran.err;
    EXPECT_EQ(ran.out, "") << options;
    EXPECT_EQ(ran.lines_of_err(), 1) << options << '\n' << ran.err;
    EXPECT_EQ(ran.err.substr(0, 13), "oplus-bench: ") << options << '\n' << ran.err;
  }
  EXPECT_EQ(files(), std::set<std::string>({"file"}));
}

}  // namespace
}  // namespace oplus
