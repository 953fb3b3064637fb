// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/slide.hpp"
#include "tests/bench/own_sum.hpp"

namespace oplus {

namespace {

struct Slide : OwnSum<ComputedSum> {
  unsigned threads;

  explicit Slide(unsigned number) : threads(number) {}

  ComputedSum sum(const Summands& s) const {
    return slide_sum(s.p, s.q, Boundary::closed, {.threads = threads});
  }

  static std::size_t segments(const ComputedSum& result) {
    return result.statistics.count("segments slid along");
  }
};

}  // namespace

std::unique_ptr<PreparedPairs> prepare_slide(const std::vector<Summands>& pairs) {
  return sums_by(Slide(1), pairs);
}

std::unique_ptr<PreparedPairs> prepare_slide_on_two_threads(const std::vector<Summands>& pairs) {
  return sums_by(Slide(2), pairs);
}

}  // namespace oplus
