// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/sum_engine.hpp"

#include "reference/io/writing.hpp"
#include "tests/bench/digest.hpp"

namespace oplus {

namespace {

MinkowskiSum canonical(const ReturnedChains& chains) {
  BoundaryFeatures features;
  for (const Chain& chain : chains) {
    const std::vector<Segment> of_chain = edges(chain);
    features.edges.insert(features.edges.end(), of_chain.begin(), of_chain.end());
  }
  return canonical_sum(features);
}

ReturnedChains chains_of(const MinkowskiSum& sum) {
  ReturnedChains chains = sum.outer;
  chains.insert(chains.end(), sum.holes.begin(), sum.holes.end());
  return chains;
}

/// An exact area of a large sum has thousands of digits.
std::string area_text(const Rational& area) {
  constexpr std::size_t long_text = 100;
  constexpr int decimals = 30;
  std::string exact = to_string(area);
  return exact.size() <= long_text ? exact : to_string(area, decimals);
}

}  // namespace

void describe_sums(const std::vector<ReturnedChains>& sums, Arithmetic arithmetic,
                   Measurement& measurement) {
  const bool exact = arithmetic == Arithmetic::exact;
  Digest digest;
  Rational twice = 0;
  for (const ReturnedChains& returned : sums) {
    const ReturnedChains chains = exact ? chains_of(canonical(returned)) : returned;
    for (const Chain& chain : chains) {
      const Rational of_chain = twice_area(chain);
      ++(of_chain > 0 ? measurement.outer : measurement.holes);
      measurement.vertices += chain.size();
      twice += of_chain;
      for (const Point& p : chain) digest.add(to_string(p));
      digest.add("end of chain");
    }
    digest.add("end of sum");
  }
  measurement.area = area_text(twice / 2);
  if (exact) measurement.digest = digest.hexadecimal();
}

}  // namespace oplus
