// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/differential.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "properties/compare/differential_cases.hpp"
#include "properties/compare/differential_report.hpp"
#include "properties/runner/checked_engines.hpp"
#include "properties/runner/temporary_folder.hpp"
#include "reference/families/fork.hpp"
#include "reference/io/reading.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {
namespace {

constexpr std::size_t any_size = 1000000;

const Summands frame_and_square{
    {{{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{2, 2}, {2, 7}, {7, 7}, {7, 2}}}}}},
    polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}})};
const Summands frame_and_plug{
    {{{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}}}}},
    polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}})};

MinkowskiSum without_holes(const Region& p, const Region& q, Boundary boundary) {
  MinkowskiSum sum = oracle_sum(p, q, boundary);
  sum.holes.clear();
  return sum;
}

MinkowskiSum without_isolated_vertices(const Region& p, const Region& q, Boundary boundary) {
  MinkowskiSum sum = oracle_sum(p, q, boundary);
  sum.isolated_vertices.clear();
  return sum;
}

MinkowskiSum throwing(const Region&, const Region&, Boundary) {
  throw std::runtime_error("no such luck");
}

template <typename Sum>
std::vector<Engine> only(const std::string& name, Sum sum) {
  return {named_engine(name, sum)};
}

TEST(Differential, agrees_with_what_is_right_and_says_what_it_saw) {
  const DifferentialResult result =
      differential(frame_and_square, only("oracle itself", oracle_sum), any_size);
  EXPECT_EQ(result.kind, DifferentialResult::Kind::agreed);
  EXPECT_TRUE(result.holes_in_sum);
  EXPECT_TRUE(result.holes_in_summand);
  EXPECT_FALSE(result.low_dimensional_features);
  EXPECT_FALSE(result.several_components);
}

TEST(Differential, sees_a_lost_hole_in_the_closed_sum_and_a_point_that_shows_it) {
  const DifferentialResult result =
      differential(frame_and_square, only("careless", without_holes), any_size);
  ASSERT_EQ(result.kind, DifferentialResult::Kind::disagreed);
  EXPECT_EQ(result.disagreement->implementation, "careless");
  EXPECT_EQ(result.disagreement->boundary, Boundary::closed);
  ASSERT_TRUE(result.disagreement->witness);
  EXPECT_EQ(locate(*result.disagreement->witness, result.disagreement->by_oracle),
            Location::outside);
  EXPECT_EQ(locate(*result.disagreement->witness, *result.disagreement->by_implementation),
            Location::inside);
}

TEST(Differential, sees_a_lost_isolated_vertex_in_the_open_sum_only) {
  const DifferentialResult result =
      differential(frame_and_plug, only("careless", without_isolated_vertices), any_size);
  ASSERT_EQ(result.kind, DifferentialResult::Kind::disagreed);
  EXPECT_EQ(result.disagreement->boundary, Boundary::open);
  EXPECT_EQ(result.disagreement->witness, (Point{3, 3}));
  EXPECT_TRUE(result.low_dimensional_features);
}

TEST(Differential, takes_an_exception_for_a_disagreement) {
  const DifferentialResult result =
      differential(frame_and_square, only("throwing", throwing), any_size);
  ASSERT_EQ(result.kind, DifferentialResult::Kind::disagreed);
  EXPECT_EQ(result.disagreement->what, "it threw: no such luck");
  EXPECT_FALSE(result.disagreement->by_implementation);
}

TEST(Differential, skips_what_is_too_large_and_says_so) {
  const DifferentialResult result = differential(fork_and_l(3), only("throwing", throwing), 10);
  EXPECT_EQ(result.kind, DifferentialResult::Kind::skipped);
  EXPECT_NE(result.why.find("at most 10"), std::string::npos) << result.why;
}

TEST(Differential, finds_a_second_implementation_wrong_after_a_right_one) {
  const std::vector<Engine> two = {named_engine("right", oracle_sum),
                                   named_engine("careless", without_holes)};
  const DifferentialResult result = differential(frame_and_square, two, any_size);
  ASSERT_EQ(result.kind, DifferentialResult::Kind::disagreed);
  EXPECT_EQ(result.disagreement->implementation, "careless");
}

TEST(Differential, shrinks_to_a_pair_that_still_shows_it) {
  const std::vector<Engine> careless = only("careless", without_holes);
  const DifferentialResult result = differential(frame_and_square, careless, any_size);
  const ShrunkDisagreement shrunk = shrink(frame_and_square, *result.disagreement, careless);
  EXPECT_LT(vertex_count(shrunk.summands.p) + vertex_count(shrunk.summands.q), 12U);
  EXPECT_EQ(differential(shrunk.summands, careless, any_size).kind,
            DifferentialResult::Kind::disagreed);
}

TEST(Differential, runs_every_case_once_on_any_number_of_threads) {
  const std::vector<DifferentialCase> cases =
      cases_of_family(*find_family("grid"), 23, 5, std::nullopt);
  for (const unsigned threads : {1U, 2U, 5U}) {
    std::vector<int> seen(cases.size(), 0);
    run_differential(cases, checked_engines(), any_size, threads,
                     [&](std::size_t i, const DifferentialResult& result) {
                       ++seen[i];
                       EXPECT_EQ(result.kind, DifferentialResult::Kind::agreed);
                     });
    EXPECT_EQ(seen, std::vector<int>(cases.size(), 1));
  }
}

TEST(Differential, passes_on_what_a_case_throws) {
  const std::vector<DifferentialCase> cases = {
      {"bad", "test", []() -> Summands { throw std::runtime_error("cannot be made"); }}};
  EXPECT_THROW(run_differential(cases, checked_engines(), any_size, 2, [](auto, const auto&) {}),
               std::runtime_error);
}

class InFolder : public testing::Test {
 protected:
  void put(const std::string& name, const std::string& content) {
    std::ofstream(folder_ / name) << content;
  }

  const TemporaryFolder temporary_;
  const std::filesystem::path folder_ = temporary_.path();
};

class CasesOfFolder : public InFolder {};

TEST_F(CasesOfFolder, pair_parts_and_everything_else_with_each_other) {
  const std::string triangle = "3\n0 0\n1 0\n0 1\n";
  for (const std::string name : {"x_part1.dat", "x_part2.dat", "a.dat", "b.dat", "lone_part1.dat"})
    put(name, triangle);
  put("readme.txt", "no polygon");
  std::vector<std::string> names;
  for (const DifferentialCase& c : cases_of_folder(folder_)) names.push_back(c.name);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"a a", "a b", "a lone_part1", "b b", "b lone_part1",
                                             "lone_part1 lone_part1", "x_part1 x_part2"}));
}

class WrittenDisagreement : public InFolder {};

TEST_F(WrittenDisagreement, is_two_files_a_picture_an_explanation_and_a_report_that_say_the_same) {
  const std::vector<Engine> careless = only("careless", without_holes);
  const DifferentialResult result = differential(frame_and_square, careless, any_size);
  const ReportedDisagreement reported = write_disagreement(
      (folder_ / "made").string(), "a test", {frame_and_square, *result.disagreement});
  EXPECT_EQ(read_region_file(reported.p_file).region, frame_and_square.p);
  EXPECT_EQ(read_region_file(reported.q_file).region, frame_and_square.q);
  EXPECT_GT(std::filesystem::file_size(reported.picture), 0U);

  const std::string text = explanation(reported);
  EXPECT_NE(text.find("the first is the oracle: 1 outer chain, 1 hole"), std::string::npos) << text;
  EXPECT_NE(text.find("the second is careless: 1 outer chain, 0 holes"), std::string::npos) << text;
  EXPECT_NE(text.find("they differ at ("), std::string::npos) << text;
  EXPECT_NE(text.find("diff --pair " + reported.p_file + " " + reported.q_file), std::string::npos);

  DifferentialReport report;
  report.all.add(result);
  report.groups["test"].add(result);
  report.disagreements.push_back(reported);
  const nlohmann::json json = to_json(report);
  EXPECT_EQ(json.at("all").at("ran"), 1);
  EXPECT_EQ(json.at("all").at("disagreed"), 1);
  EXPECT_EQ(json.at("groups").at("test").at("holes_in_sum"), 1);
  EXPECT_EQ(json.at("disagreements").at(0).at("boundary"), "closed");
  EXPECT_NE(summary(report).find("1 cases run, each closed and open, 0 skipped, 1 with a"),
            std::string::npos)
      << summary(report);
}

}  // namespace
}  // namespace oplus
