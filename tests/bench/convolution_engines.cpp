// SPDX-License-Identifier: GPL-3.0-or-later
// Cycle tracing, O(n + m + K), and all pairs, O(nm) (thesis, Section 3.2.1).
#include <algorithm>

#include "checked/cycles/convolution_cycles.hpp"
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
struct Convolution {
  using Input = Summands;
  using Sum = Found;

  Found (*find)(const Region&, const Region&);

  const Summands& converted(const Summands& pair) const { return pair; }
  Found sum(const Summands& pair) const { return find(pair.p, pair.q); }

  void describe(const Summands& pair, const Found& found, Description& description) const {
    std::vector<Segment> segments = segments_of(pair, found);
    description.count("segments", segments.size());
    if constexpr (requires { found.steps; }) {
      description.count("steps", found.steps);
      description.count("cycles", found.cycles.size());
    }
    std::sort(segments.begin(), segments.end());
    description.say(segments);
  }
};

template <typename Found>
BenchEngine engine_of(const std::string& name, const std::string& what,
                      Found (*find)(const Region&, const Region&)) {
  return {.name = name,
          .what = what,
          .prepare = each_pair([find](const Row&) { return Convolution<Found>{find}; }),
          .kind = "convolution"};
}

}  // namespace

std::vector<BenchEngine> convolution_engines() {
  return {
      engine_of("traced", "oplus: the convolution by cycle tracing", convolution_cycles),
      engine_of("without-points",
                "oplus: cycle tracing, the origins of segments without coordinates",
                traced_origins),
      engine_of("naive", "oplus: the convolution from all pairs of a vertex and an edge",
                convolution),
  };
}

}  // namespace oplus
