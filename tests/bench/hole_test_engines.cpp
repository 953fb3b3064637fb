// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>

#include "checked/arrangement/convolution_arrangement.hpp"
#include "checked/arrangement/hole_test.hpp"
#include "checked/arrangement/rca.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "checked/statistics.hpp"
#include "checked/timed.hpp"
#include "tests/bench/engine.hpp"

namespace oplus {

namespace {

// Questions for a hole test about a pair of regions: is there a hole to the right of an edge?

/// Answers with the hierarchies and records the questions.
class Recording : public HoleTest {
 public:
  Recording(const Region& p, const Region& q, std::vector<Segment>& asked)
      : answers_(hierarchy_hole_test(p, q)), asked_(asked) {}

  bool is_hole_right_of(const Segment& edge) override {
    asked_.push_back(edge);
    return answers_->is_hole_right_of(edge);
  }
  bool interiors_meet_at(const Point& x) override { return answers_->interiors_meet_at(x); }

 private:
  std::unique_ptr<HoleTest> answers_;
  std::vector<Segment>& asked_;
};

/// Those of rca about the closed sum: one per face that the other filters do not decide.
std::vector<Segment> questions_of_rca(const Summands& pair) {
  std::vector<Segment> asked;
  rca(pair.p, pair.q, Boundary::closed, {.hole_test = [&](const Region& p, const Region& q) {
        return std::make_unique<Recording>(p, q, asked);
      }});
  return asked;
}

/// One per edge of the reduced convolution's arrangement that no segment passes in the other direction:
/// all kinds of faces, as if there were no other filter.
std::vector<Segment> questions_about_edges(const Summands& pair) {
  const ConvolutionArrangement arrangement(traced_reduced_convolution(pair.p, pair.q));
  std::vector<Segment> questions;
  for (ConvolutionArrangement::Halfedge h = 0; h < 2 * arrangement.edge_count(); ++h)
    if (!arrangement.along(h).empty() && arrangement.along(ConvolutionArrangement::twin(h)).empty())
      questions.push_back(arrangement.geometry(h));
  return questions;
}

/// At most this many of them, evenly spread.
std::vector<Segment> thinned_out(const std::vector<Segment>& questions, std::size_t most) {
  std::vector<Segment> some;
  const std::size_t count = std::min(questions.size(), most);
  for (std::size_t i = 0; i < count; ++i) some.push_back(questions[i * questions.size() / count]);
  return some;
}

/// The slowest method takes milliseconds per question.
constexpr std::size_t most_questions = 100;

struct Asking {
  struct Input {
    Summands pair;
    std::size_t questions;       ///< the number of all
    std::vector<Segment> asked;  ///< some of them
  };
  struct Sum {
    Seconds preparing{};
    Seconds of_holes{};
    Seconds of_others{};
    std::string answers;

    std::size_t holes() const {
      return static_cast<std::size_t>(std::count(answers.begin(), answers.end(), 'h'));
    }
  };

  HoleTestMethod method;
  bool about_edges;

  Input converted(const Summands& pair) const {
    const std::vector<Segment> all =
        about_edges ? questions_about_edges(pair) : questions_of_rca(pair);
    return {pair, all.size(), thinned_out(all, most_questions)};
  }

  Sum sum(const Input& input) const {
    Sum result;
    const std::unique_ptr<HoleTest> test =
        timed(result.preparing, [&] { return method(input.pair.p, input.pair.q); });
    for (const Segment& question : input.asked) {
      Seconds one{};
      const bool is_hole = timed(one, [&] { return test->is_hole_right_of(question); });
      (is_hole ? result.of_holes : result.of_others) += one;
      result.answers += is_hole ? 'h' : 's';
    }
    return result;
  }

  /// Times are per question; that of `all` is extrapolated to all questions.
  void add_stages(const Input& input, const Sum& sum,
                  std::map<std::string, double>& seconds) const {
    const auto per_question = [&](const std::string& name, Seconds time, std::size_t count) {
      if (count > 0) seconds[name] += time.count() / static_cast<double>(count);
    };
    const std::size_t asked = input.asked.size();
    seconds["prepare"] += sum.preparing.count();
    per_question("hole", sum.of_holes, sum.holes());
    per_question("other", sum.of_others, asked - sum.holes());
    per_question("question", sum.of_holes + sum.of_others, asked);
    const auto all_by_asked = static_cast<double>(input.questions) / static_cast<double>(asked);
    if (asked > 0)
      seconds["all"] += (sum.preparing + all_by_asked * (sum.of_holes + sum.of_others)).count();
  }

  void describe(const Input& input, const Sum& sum, Description& description) const {
    description.count("questions", input.questions);
    description.count("asked", input.asked.size());
    description.count("holes", sum.holes());
    description.count("others", input.asked.size() - sum.holes());
    description.say("answers " + sum.answers);
  }
};

}  // namespace

std::vector<BenchEngine> hole_test_engines() {
  std::vector<BenchEngine> engines;
  for (const auto& [name, method] : hole_test_methods())
    engines.push_back({.name = name,
                       .what = "oplus: a hole test",
                       .prepare = each_pair([method = method](const Row& row) {
                         return Asking{method, row.about_edges};
                       }),
                       .kind = "hole tests"});
  return engines;
}

}  // namespace oplus
