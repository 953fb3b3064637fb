// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "properties/compare/report_json.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

class Merge : public Shell {};

/// As if a shard had not come to the same end twice.
TEST_F(Merge, refuses_shards_that_do_not_fit_together) {
  for (const std::string shard : {"1", "2", "3"})
    run("oplus-check exhaustive --engine slide --grid 2 --vertices 4 --shard " + shard +
            "/3 --report s" + shard + ".json",
        0);
  const CampaignReport right = opened(content("s3.json"), "s3.json");
  const auto expect_refused = [&](const std::string& reports, const std::string& part,
                                  const auto& change) {
    CampaignReport different = right;
    change(different);
    put("different.json", sealed(different));
    expect_refusal("oplus-check merge " + reports + " different.json -o merged.json", part);
  };
  expect_refused("s1.json s2.json s3.json", "shard 3 is there twice with different content",
                 [](CampaignReport& r) { r.sources[0].counts.disagreed = 1; });
  expect_refused("s1.json s2.json", R"(version is "0.0.9")",
                 [](CampaignReport& r) { r.version = "0.0.9"; });
  expect_refused("s1.json s2.json", "the shard was interrupted: 0 of",
                 [](CampaignReport& r) { r.done = 0; });
}

}  // namespace
}  // namespace oplus
