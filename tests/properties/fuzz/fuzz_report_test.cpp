// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/fuzz_report.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace oplus {
namespace {

const char* const well =
    "INFO: Seed: 1\n"
    "#150\tNEW    cov: 7237 ft: 26150 corp: 107/7455b lim: 256 exec/s: 4 rss: 100Mb\n"
    "Slowest unit: 37 s:\nartifact_prefix='out/slide-'; Test unit written to out/slide-slow-unit-7\n"
    "#151\tDONE   cov: 7240 ft: 26150 corp: 107/7455b lim: 256 exec/s: 4 rss: 100Mb\n"
    "Done 151 runs in 36 second(s)\n"
    "stat::number_of_executed_units: 151\n"
    "stat::peak_rss_mb:              102\n"
    "oplus: reached 141, rejected 10\n";

TEST(FuzzReport, reads_a_run_without_a_finding) {
  const FuzzReport report = report_of("slide", well, true);
  EXPECT_EQ(report.runs, 151U);
  EXPECT_EQ(report.edges, 7240U);
  EXPECT_EQ(report.reached, 141U);
  EXPECT_EQ(report.rejected, 10U);
  EXPECT_EQ(line_of(report),
            "slide    151 runs, 7240 edges, 141 inputs reached, 10 rejected; no finding");
  EXPECT_FALSE(to_json(report).contains("finding"));
  EXPECT_FALSE(to_json(report).contains("input"));
  EXPECT_EQ(to_json(report).at("reached"), 141);
}

TEST(FuzzReport, reads_a_finding_in_words_of_oplus) {
  const FuzzReport report =
      report_of("dat",
                "#9\tNEW    cov: 77 ft: 2\n"
                "oplus: finding: written and read again, the region is another one\n"
                "==1== ERROR: libFuzzer: deadly signal\n"
                "artifact_prefix='out/dat-'; Test unit written to out/dat-crash-1a\n"
                "stat::number_of_executed_units: 12\n",
                false);
  EXPECT_EQ(report.finding, "written and read again, the region is another one");
  EXPECT_EQ(report.input, "out/dat-crash-1a");
  EXPECT_EQ(line_of(report),
            "dat      12 runs, 77 edges; finding: written and read again, the region is another "
            "one; input: out/dat-crash-1a");
  EXPECT_EQ(to_json(report).at("input"), "out/dat-crash-1a");
}

TEST(FuzzReport, reads_a_finding_of_a_sanitizer_and_a_timeout) {
  EXPECT_EQ(
      report_of("dat", "==5==ERROR: AddressSanitizer: heap-use-after-free on address\n", false)
          .finding,
      "heap-use-after-free on address");
  EXPECT_EQ(
      report_of("dat", "a.cpp:3:1: runtime error: shift exponent 64 is too large\n", false).finding,
      "shift exponent 64 is too large");
  EXPECT_EQ(report_of("dat", "==5== ERROR: libFuzzer: timeout after 120 seconds\n", false).finding,
            "timeout after 120 seconds");
}

TEST(FuzzReport, a_run_that_stopped_early_is_a_finding) {
  EXPECT_EQ(report_of("dat", well, false).finding, "the program did not run to its end");
  EXPECT_EQ(report_of("dat", "", false).finding, "the program did not run to its end");
}

}  // namespace
}  // namespace oplus
