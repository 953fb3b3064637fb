// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/runner/compared_hole_tests.hpp"

#include <utility>

#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// The answer of all tests, which `ask` puts to one.
template <typename Ask>
bool common_answer(const std::vector<std::unique_ptr<HoleTest>>& tests, const std::string& question,
                   Ask ask) {
  std::vector<bool> answers;
  for (const auto& test : tests) answers.push_back(ask(*test));
  for (std::size_t i = 1; i < answers.size(); ++i) {
    if (answers[i] != answers[0])
      throw HoleTestsDiffer("the hole tests differ on whether " + question + ": " +
                            hole_test_methods()[0].first + " says " + (answers[0] ? "yes" : "no") +
                            ", " + hole_test_methods()[i].first + " the opposite");
  }
  return answers.at(0);
}

std::vector<std::unique_ptr<HoleTest>> prepared(const Region& p, const Region& q) {
  std::vector<std::unique_ptr<HoleTest>> tests;
  for (const auto& [name, method] : hole_test_methods()) tests.push_back(method(p, q));
  return tests;
}

}  // namespace

ComparedHoleTests::ComparedHoleTests(const Region& p, const Region& q)
    : ComparedHoleTests(prepared(p, q)) {}

ComparedHoleTests::ComparedHoleTests(std::vector<std::unique_ptr<HoleTest>> tests)
    : tests_(std::move(tests)) {}

bool ComparedHoleTests::is_hole_right_of(const Segment& edge) {
  return common_answer(tests_,
                       "the face right of " + to_string(edge.source) + " to " +
                           to_string(edge.target) + " is a hole",
                       [&](HoleTest& test) { return test.is_hole_right_of(edge); });
}

bool ComparedHoleTests::interiors_meet_at(const Point& x) {
  return common_answer(tests_, "the interiors meet at " + to_string(x),
                       [&](HoleTest& test) { return test.interiors_meet_at(x); });
}

}  // namespace oplus
