// SPDX-License-Identifier: GPL-3.0-or-later
// Cycle tracing, O(n + m + K), beside all pairs, O(nm) (thesis, Section 3.2.1).
#include <algorithm>

#include "checked/cycles/convolution_cycles.hpp"
#include "reference/io/writing.hpp"
#include "tests/bench/digest.hpp"
#include "tests/bench/engine.hpp"

namespace oplus {

namespace {

void describe_convolution(std::vector<Segment> segments, Digest& digest, Measurement& measurement) {
  measurement.segments = measurement.segments.value_or(0) + segments.size();
  std::sort(segments.begin(), segments.end());
  for (const Segment& s : segments) digest.add(to_string(s.source) + to_string(s.target));
}

class Traced : public PreparedPairs {
 public:
  explicit Traced(const std::vector<Summands>& pairs) : pairs_(pairs) {}

  void compute() override {
    for (const Summands& pair : pairs_) found_.push_back(convolution_cycles(pair.p, pair.q));
  }

  void forget() override { found_.clear(); }

  void describe(Measurement& measurement) const override {
    Digest digest;
    measurement.steps = 0;
    for (const ConvolutionCycles& cycles : found_) {
      *measurement.steps += cycles.steps;
      describe_convolution(segments(full_convolution(cycles)), digest, measurement);
    }
    measurement.digest = digest.hexadecimal();
  }

 private:
  std::vector<Summands> pairs_;
  std::vector<ConvolutionCycles> found_;
};

class Naive : public PreparedPairs {
 public:
  explicit Naive(const std::vector<Summands>& pairs) : pairs_(pairs) {}

  void compute() override {
    for (const Summands& pair : pairs_) found_.push_back(convolution(pair.p, pair.q));
  }

  void forget() override { found_.clear(); }

  void describe(Measurement& measurement) const override {
    Digest digest;
    for (const std::vector<ConvolutionSegment>& found : found_)
      describe_convolution(segments(found), digest, measurement);
    measurement.digest = digest.hexadecimal();
  }

 private:
  std::vector<Summands> pairs_;
  std::vector<std::vector<ConvolutionSegment>> found_;
};

}  // namespace

std::unique_ptr<PreparedPairs> prepare_traced_convolution(const std::vector<Summands>& pairs) {
  return std::make_unique<Traced>(pairs);
}

std::unique_ptr<PreparedPairs> prepare_naive_convolution(const std::vector<Summands>& pairs) {
  return std::make_unique<Naive>(pairs);
}

}  // namespace oplus
