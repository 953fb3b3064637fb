// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/operation.hpp"

#include <gtest/gtest.h>

#include "checked/operations/operations.hpp"
#include "properties/compare/report_text.hpp"
#include "properties/compare/sources.hpp"
#include "reference/oracle/operations_by_definition.hpp"
#include "tests/checked/cli/shell.hpp"
#include "tests/properties/compare/faulty_engines.hpp"

namespace oplus {
namespace {

const Engine right = changed([](PlanarSet&) {});

Rules rules(const std::string& operation, const Engine& engine) {
  return rules_of_operation(operation, {.engines = {engine}});
}

/// A run on pairs of a family that fit.
CampaignReport run_of(const std::string& operation, const Engine& engine, std::size_t cases,
                      const std::string& family = "tight") {
  Campaign campaign;
  campaign.engines = {engine.name};
  campaign.operation = operation;
  campaign.largest = default_largest(campaign);
  campaign.shrink_tries = 60;
  const TaskSource source =
      pairs_that_fit(family_source(*find_family(family), cases, 1, 2), operation);
  return run_campaign(begun_report("diff", campaign, {}, {source}), {source},
                      rules(operation, engine), 2);
}

TEST(Operation, each_has_a_definition_and_agrees_with_it) {
  for (const std::string& name : compared_operations()) {
    ASSERT_NE(find_defined_operation(name), nullptr) << name;
    const CampaignReport report = run_of(name, right, 10);
    EXPECT_TRUE(report.conforms()) << name;
    EXPECT_EQ(report.all().ran, 10U) << name;
    EXPECT_EQ(report.all().count("passed"), 10U) << name;
  }
  EXPECT_EQ(defined_operations().size(), compared_operations().size());
}

TEST(Operation, counts_what_its_values_have) {
  const CampaignReport report = run_of("ifp", right, 40);
  std::map<std::string, std::size_t> expected;
  const TaskSource source = pairs_that_fit(family_source(*find_family("tight"), 40, 1, 2), "ifp");
  for (std::size_t i = 0; i < source.tasks; ++i) {
    const Summands pair = source.task(i).pair;
    const PlanarSet value = find_defined_operation("ifp")->compute(pair.p, pair.q);
    for (const std::string& part : parts_of_value(value)) ++expected[part];
  }
  EXPECT_EQ(report.all().values, expected);
  for (const char* part : {"area", "edges", "points", "unbounded", "empty"})
    EXPECT_GT(expected[part], 1U) << part;
}

TEST(Operation, finds_lost_points_and_shrinks_the_pair) {
  const Engine loses = changed([](PlanarSet& sum) { sum.isolated_vertices.clear(); });
  const CampaignReport report = run_of("ifp", loses, 80);
  EXPECT_FALSE(report.conforms());
  ASSERT_TRUE(report.counterexamples.contains("isolated vertex lost"));
  const ShrunkFailure& found = report.counterexamples.at("isolated vertex lost");
  EXPECT_LE(size_of(found.sum.pair).vertices, 8U);
  EXPECT_FALSE(find_defined_operation("ifp")
                   ->compute(found.sum.pair.p, found.sum.pair.q)
                   .isolated_vertices.empty());
  const std::string text = explanation(report, found);
  EXPECT_TRUE(has(text, "disagreement on ifp, found in gen tight")) << text;
  EXPECT_TRUE(has(text, "the first is the definition of ifp: ")) << text;
  EXPECT_TRUE(has(text, "oplus-check diff --engine changed --operation ifp --pair ")) << text;
  EXPECT_TRUE(has(to_markdown(report), "Compared with the definition of ifp. One value per pair"));
}

}  // namespace
}  // namespace oplus
