// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "checked/cycles/convolution_cycles.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/chapter4/state.hpp"
#include "properties/statements/directions_around.hpp"
#include "reference/definitions/tangent_set.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// How many convolution segments enter a state, and how many leave it: up to two each.
struct Traffic {
  int entering = 0;
  int leaving = 0;
};

std::string in_words(const Traffic& traffic) {
  return "segments that enter the state: " + std::to_string(traffic.entering) +
         ", that leave it: " + std::to_string(traffic.leaving);
}

/// Both parts of the lemma.
bool goes_on(const Traffic& traffic) {
  const bool first = traffic.entering == 0 || traffic.leaving > 0;
  const bool second = (traffic.leaving == 2) == (traffic.entering == 2);
  return first && second;
}

/// At a state whose vertices have these corners: which segments are in the convolution depends on
/// nothing else.
Traffic traffic_at(const Corner& of_p, const Corner& of_q) {
  const auto in_convolution = [](const Vector& edge, Summand of, const Corner& vertex) {
    return in_tangent_set({edge, of}, vertex) ? 1 : 0;
  };
  return {in_convolution(of_p.in, Summand::P, of_q) + in_convolution(of_q.in, Summand::Q, of_p),
          in_convolution(of_p.out, Summand::P, of_q) + in_convolution(of_q.out, Summand::Q, of_p)};
}

Enumeration enumerate() {
  const DirectionsAround directions(5);
  Enumeration result;
  for_each_choice<4>(directions.size(), [&](const std::array<std::size_t, 4>& choice) {
    const Corner of_p{directions[choice[0]], directions[choice[1]]};
    const Corner of_q{directions[choice[2]], directions[choice[3]]};
    const Traffic traffic = traffic_at(of_p, of_q);
    ++result.cases;
    // More than the lemma says: a state that nothing enters is not left.
    if (!result.failure.empty() || (goes_on(traffic) && traffic.entering == traffic.leaving))
      return;
    result.failure = "where P's vertex has edges " + to_string(of_p.in) + " and " +
                     to_string(of_p.out) + " and Q's " + to_string(of_q.in) + " and " +
                     to_string(of_q.out) + ", " + in_words(traffic);
  });
  return result;
}

Outcome check(const Summands& summands) {
  const std::vector<Chain> of_p = chains(summands.p), of_q = chains(summands.q);
  std::map<State, Traffic> traffic;
  for (const ConvolutionSegment& s : convolution(summands.p, summands.q)) {
    ++traffic[state_before(s.origin)].leaving;
    ++traffic[state_after(s.origin, of_p, of_q)].entering;
  }
  Outcome outcome;
  for (const ConvolutionCycle& cycle : convolution_cycles(summands.p, summands.q).cycles) {
    for (const ConvolutionSegment& s : cycle) {
      const Traffic& here = traffic[state_after(s.origin, of_p, of_q)];
      ++outcome.counts["states while tracing"];
      if (here.leaving == 2) ++outcome.counts["of these with two ways on"];
      if (goes_on(here) && here.entering > 0) continue;
      return outcome.fail("at " + to_string(s.segment.target) + " " + in_words(here),
                          s.segment.target);
    }
  }
  return outcome;
}

const Registered registered(larger_mixture(),
                            {.id = "lemma-4.1.3",
                             .kills = {"tangent-set-without-ties", "tie-rule-depends-on-who-asks",
                                       "reflex-turns-clockwise"},
                             .cases = 1000,
                             .check = check,
                             .enumerate = enumerate});

}  // namespace

}  // namespace oplus
