// SPDX-License-Identifier: GPL-3.0-or-later
// Cycle tracing, O(n + m + K), beside all pairs, O(nm) (thesis, Section 3.2.1).
#include <algorithm>

#include "checked/cycles/convolution_cycles.hpp"
#include "reference/io/writing.hpp"
#include "tests/bench/described_sums.hpp"
#include "tests/bench/engine.hpp"

namespace oplus {

namespace {

std::vector<Segment> segments_of(const Summands&, const std::vector<ConvolutionSegment>& found) {
  return segments(found);
}

std::vector<Segment> segments_of(const Summands&, const ConvolutionCycles& found) {
  return segments(full_convolution(found));
}

std::vector<Segment> segments_of(const Summands& pair, const std::vector<TracedOrigin>& found) {
  const std::vector<Chain> of_p = chains(pair.p);
  const std::vector<Chain> of_q = chains(pair.q);
  std::vector<Segment> segments;
  for (const auto& [origin, is_reflex] : found) {
    const bool edge_of_p = origin.edge_of == Summand::P;
    const Chain& with_edge = (edge_of_p ? of_p : of_q).at(origin.edge.chain);
    const Point& vertex =
        (edge_of_p ? of_q : of_p).at(origin.vertex.chain).at(origin.vertex.vertex);
    const std::size_t end = next(origin.edge.vertex, with_edge.size());
    segments.push_back({with_edge.at(origin.edge.vertex) + vertex, with_edge.at(end) + vertex});
  }
  return segments;
}

template <typename Found>
class Convolutions : public PreparedPairs {
 public:
  Convolutions(const std::vector<Summands>& pairs, Found (*find)(const Region&, const Region&))
      : pairs_(pairs), find_(find) {}

  void compute() override {
    for (const Summands& pair : pairs_) found_.push_back(find_(pair.p, pair.q));
  }

  void forget() override { found_.clear(); }

  void describe(Measurement& measurement) const override {
    std::string said;
    std::map<std::string, double>& numbers = measurement.numbers;
    for (std::size_t i = 0; i < found_.size(); ++i) {
      std::vector<Segment> segments = segments_of(pairs_[i], found_[i]);
      numbers["segments"] += static_cast<double>(segments.size());
      if constexpr (requires { found_[i].steps; }) {
        numbers["steps"] += static_cast<double>(found_[i].steps);
        numbers["cycles"] += static_cast<double>(found_[i].cycles.size());
      }
      std::sort(segments.begin(), segments.end());
      for (const Segment& s : segments) said += to_string(s.source) + to_string(s.target);
    }
    measurement.digest = digest_of(said);
  }

 private:
  std::vector<Summands> pairs_;
  Found (*find_)(const Region&, const Region&);
  std::vector<Found> found_;
};

template <typename Found>
BenchEngine engine_of(const std::string& name, const std::string& what,
                      Found (*find)(const Region&, const Region&)) {
  return {name,
          what,
          Subject::convolution,
          false,
          true,
          [find](const Row&, const std::vector<Summands>& pairs) {
            return std::make_unique<Convolutions<Found>>(pairs, find);
          }};
}

}  // namespace

std::vector<BenchEngine> convolution_engines() {
  return {
      engine_of("traced", "oplus: the convolution by cycle tracing", convolution_cycles),
      engine_of("without-points", "oplus: cycle tracing, which segments there are and not where",
                traced_origins),
      engine_of("naive", "oplus: the convolution from all pairs of a vertex and an edge",
                convolution),
  };
}

}  // namespace oplus
