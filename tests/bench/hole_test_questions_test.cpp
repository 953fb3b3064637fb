// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/hole_test_questions.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "checked/arrangement/hole_test.hpp"
#include "reference/families/fork.hpp"

namespace oplus {
namespace {

TEST(HoleTestQuestions, rca_asks_about_each_hole_of_the_fork) {
  EXPECT_EQ(questions_of_rca(fork_and_l(3)).size(), 9U);
}

TEST(HoleTestQuestions, about_edges_have_both_answers_and_all_methods_agree) {
  const Summands pair = fork_and_l(2);
  const std::vector<Segment> questions = questions_about_edges(pair);
  ASSERT_GT(questions.size(), 20U);
  std::vector<std::vector<bool>> answers;
  for (const auto& [name, method] : hole_test_methods()) {
    const std::unique_ptr<HoleTest> test = method(pair.p, pair.q);
    std::vector<bool>& own = answers.emplace_back();
    for (const Segment& question : questions) own.push_back(test->is_hole_right_of(question));
    EXPECT_EQ(own, answers.front()) << name;
  }
  EXPECT_NE(answers.front(), std::vector<bool>(questions.size(), true));
  EXPECT_NE(answers.front(), std::vector<bool>(questions.size(), false));
}

TEST(HoleTestQuestions, thinned_out_evenly) {
  const auto segment = [](int x) { return Segment{{x, 0}, {x, 1}}; };
  std::vector<Segment> questions;
  for (int x = 0; x < 10; ++x) questions.push_back(segment(x));
  EXPECT_EQ(thinned_out(questions, 20), questions);
  EXPECT_EQ(thinned_out(questions, 4),
            std::vector<Segment>({segment(0), segment(2), segment(5), segment(7)}));
  EXPECT_TRUE(thinned_out({}, 4).empty());
}

}  // namespace
}  // namespace oplus
