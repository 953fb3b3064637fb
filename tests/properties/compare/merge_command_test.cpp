// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "properties/compare/report_json.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

/// Runs oplus-check, whose exit code 1 says that something was found.
class Merge : public Shell {
 protected:
  Ran check(const std::string& options, int exit_code) {
    return run("oplus-check " + options, exit_code);
  }

  /// Runs a command in three shards and in one, and merges.
  void expect_same_report(const std::string& command) {
    check(command + " --report one.json", 0);
    for (const std::string shard : {"1", "2", "3"}) {
      check(command + " --shard " + shard + "/3 --report s" + shard + ".json", 0);
    }
    EXPECT_NE(content("s1.json"), content("s2.json"));
    const Ran merged = check("merge s2.json s1.json s3.json s1.json -o merged.json", 0);
    EXPECT_EQ(content("merged.json"), content("one.json"));
    EXPECT_EQ(check("merge s1.json s2.json s3.json", 0).out, content("one.json"));
  }

  void expect_refused(const std::string& reports, const std::string& part) {
    const Ran ran = check("merge " + reports + " -o merged.json", 2);
    EXPECT_EQ(ran.lines_of_err(), 1) << ran.err;
    EXPECT_TRUE(has(ran.err, part));
    EXPECT_EQ(ran.out, "");
    EXPECT_FALSE(files().contains("merged.json"));
  }
};

TEST_F(Merge, diff_in_shards_is_diff) {
  expect_same_report("diff --engine slide --family grid --family holes --cases 7 --largest 20");
  EXPECT_FALSE(opened(content("one.json"), "one.json").skipped.empty());
}

TEST_F(Merge, diff_in_shards_shows_the_first_disagreements_of_all) {
  put("nothing", "#!/bin/sh\nexit 3\n");
  const std::string command =
      "diff --engine 'exec:sh ./nothing' --family grid --cases 12 --shrink 2 --shrink-tries 1 ";
  check(command + "--report one.json", 1);
  check(command + "--shard 1/2 --report s1.json", 1);
  check(command + "--shard 2/2 --report s2.json --out elsewhere", 1);
  check("merge s1.json s2.json -o merged.json", 1);
  EXPECT_EQ(content("merged.json"), content("one.json"));
}

TEST_F(Merge, exhaustive_in_shards_is_exhaustive) {
  expect_same_report("exhaustive --engine slide --grid 3 --vertices 3");
}

TEST_F(Merge, refuses_what_is_not_one_campaign) {
  const std::string command = "exhaustive --engine slide --grid 2 --vertices 4";
  for (const std::string shard : {"1", "2", "3"})
    check(command + " --shard " + shard + "/3 --report s" + shard + ".json", 0);
  expect_refused("s1.json", "shards these are missing: 2, 3;");
  expect_refused("s1.json s2.json nowhere.json", "nowhere.json:1: cannot be read");

  check("exhaustive --engine rca --grid 2 --vertices 4 --shard 3/3 --report other.json", 0);
  expect_refused("s1.json s2.json other.json", R"(engines is ["rca"], not ["slide"])");
  check(command + " --shard 3/4 --report quarter.json", 0);
  expect_refused("s1.json s2.json quarter.json", "shards is 4, not 3");
  check(command + " --judge convex-parts --shard 3/3 --report judge.json", 0);
  expect_refused("s1.json s2.json judge.json", R"(judge is "convex-parts", not "oracle")");
  check("conformance --engine slide --part corpus --shard 3/3 --report conformance.json", 0);
  expect_refused("s1.json s2.json conformance.json",
                 R"(report is "conformance", not "exhaustive")");

  const std::string whole = content("s3.json");
  put("s3.json", whole.substr(0, whole.size() - 20));
  expect_refused("s1.json s2.json s3.json", "s3.json:1: invalid or truncated JSON");
  put("s3.json", "");
  expect_refused("s1.json s2.json s3.json", "s3.json:1: invalid or truncated JSON");
  std::string changed = whole;
  changed.replace(changed.find("\"disagreed\": 0"), 14, "\"disagreed\": 1");
  put("s3.json", changed);
  expect_refused("s1.json s2.json s3.json", "its checksum does not match");

  // As if a shard had not come to the same end twice.
  const CampaignReport right = opened(whole, "s3.json");
  const auto put_changed = [&](const auto& change) {
    CampaignReport different = right;
    change(different);
    put("different.json", sealed(different));
  };
  put("s3.json", whole);
  put_changed([](CampaignReport& r) { r.sources[0].counts.disagreed = 1; });
  expect_refused("s1.json s2.json s3.json different.json",
                 "shard 3 is there twice with different content");
  put_changed([](CampaignReport& r) { r.version = "0.0.9"; });
  expect_refused("s1.json s2.json different.json", R"(version is "0.0.9")");
  put_changed([](CampaignReport& r) { r.done = 0; });
  expect_refused("s1.json s2.json different.json", "the shard was interrupted: 0 of");

  check("merge", 2);
  check("merge s1.json s2.json s3.json -o merged.md", 0);
}

}  // namespace
}  // namespace oplus
