// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/hole_test_questions.hpp"

#include <algorithm>
#include <memory>

#include "checked/arrangement/convolution_arrangement.hpp"
#include "checked/arrangement/hole_test.hpp"
#include "checked/arrangement/rca.hpp"
#include "checked/cycles/convolution_cycles.hpp"

namespace oplus {

namespace {

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

}  // namespace

std::vector<Segment> questions_of_rca(const Summands& pair) {
  std::vector<Segment> asked;
  rca(pair.p, pair.q, Boundary::closed, {.hole_test = [&](const Region& p, const Region& q) {
        return std::make_unique<Recording>(p, q, asked);
      }});
  return asked;
}

std::vector<Segment> questions_about_edges(const Summands& pair) {
  const ConvolutionArrangement arrangement(traced_reduced_convolution(pair.p, pair.q));
  std::vector<Segment> questions;
  for (ConvolutionArrangement::Halfedge h = 0; h < 2 * arrangement.edge_count(); ++h)
    if (!arrangement.along(h).empty() && arrangement.along(ConvolutionArrangement::twin(h)).empty())
      questions.push_back(arrangement.geometry(h));
  return questions;
}

std::vector<Segment> thinned_out(const std::vector<Segment>& questions, std::size_t most) {
  std::vector<Segment> some;
  const std::size_t count = std::min(questions.size(), most);
  for (std::size_t i = 0; i < count; ++i) some.push_back(questions[i * questions.size() / count]);
  return some;
}

}  // namespace oplus
