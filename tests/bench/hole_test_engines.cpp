// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>

#include "checked/arrangement/hole_test.hpp"
#include "checked/statistics.hpp"
#include "tests/bench/engine.hpp"
#include "tests/bench/hole_test_questions.hpp"

namespace oplus {

namespace {

/// More are thinned out evenly: the slowest method takes milliseconds for each.
constexpr std::size_t most_questions = 100;

class Asking : public PreparedPairs {
 public:
  Asking(HoleTestMethod method, const Row& row, const Summands& pair)
      : method_(method), pair_(pair) {
    const std::vector<Segment> all =
        row.words.at("about") == "edges" ? questions_about_edges(pair) : questions_of_rca(pair);
    all_of_them_ = static_cast<double>(all.size());
    questions_ = thinned_out(all, most_questions);
  }

  void compute() override {
    const std::unique_ptr<HoleTest> test =
        timed(preparing_, [&] { return method_(pair_.p, pair_.q); });
    for (const Segment& question : questions_) {
      Seconds one{};
      const bool is_hole = timed(one, [&] { return test->is_hole_right_of(question); });
      (is_hole ? of_holes_ : of_others_) += one;
      answers_ += is_hole ? 'h' : 's';
    }
  }

  void forget() override {
    preparing_ = of_holes_ = of_others_ = Seconds{};
    answers_.clear();
  }

  void add_stages(std::map<std::string, double>& seconds) const override {
    seconds["prepare"] += preparing_.count();
    seconds["question"] += (of_holes_ + of_others_).count();
    seconds["hole"] += of_holes_.count();
    seconds["other"] += of_others_.count();
  }

  /// Of all questions the times are of one of them.
  void describe(Measurement& measurement) const override {
    std::map<std::string, double>& numbers = measurement.numbers;
    const auto asked = static_cast<double>(questions_.size());
    const auto holes = static_cast<double>(std::count(answers_.begin(), answers_.end(), 'h'));
    numbers["questions"] = all_of_them_;
    numbers["asked"] = asked;
    numbers["holes"] = holes;
    numbers["others"] = asked - holes;
    const auto per_question = [&](const std::string& name, double count) {
      if (count > 0)
        numbers[name] /= count;
      else
        numbers.erase(name);
    };
    per_question("hole", holes);
    per_question("other", asked - holes);
    per_question("question", asked);
    if (asked > 0) numbers["all"] = numbers.at("prepare") + numbers.at("question") * all_of_them_;
    measurement.digest = "answers " + answers_;
  }

 private:
  HoleTestMethod method_;
  Summands pair_;
  double all_of_them_;
  std::vector<Segment> questions_;
  Seconds preparing_{};
  Seconds of_holes_{};
  Seconds of_others_{};
  std::string answers_;
};

}  // namespace

std::vector<BenchEngine> hole_test_engines() {
  std::vector<BenchEngine> engines;
  for (const auto& [name, method] : hole_test_methods())
    engines.push_back({name, "oplus: a hole test", Subject::hole_tests, false, true,
                       [method = method](const Row& row, const std::vector<Summands>& pairs) {
                         return std::make_unique<Asking>(method, row, pairs.at(0));
                       }});
  return engines;
}

}  // namespace oplus
