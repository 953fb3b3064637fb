// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/slide/slide.hpp"
#include "tests/bench/own_sum.hpp"

namespace oplus {

namespace {

struct Slide : OwnSum<SlideResult> {
  unsigned threads;

  explicit Slide(unsigned number) : threads(number) {}

  SlideResult sum(const Summands& s) const {
    SlideOptions options;
    options.threads = threads;
    return slide_sum(s.p, s.q, Boundary::closed, options);
  }

  static std::size_t segments(const SlideResult& result) { return result.statistics.segments; }
};

}  // namespace

std::unique_ptr<PreparedPairs> prepare_slide(const std::vector<Summands>& pairs) {
  return sums_by(Slide(1), pairs);
}

std::unique_ptr<PreparedPairs> prepare_slide_on_two_threads(const std::vector<Summands>& pairs) {
  return sums_by(Slide(2), pairs);
}

}  // namespace oplus
