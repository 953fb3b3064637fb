// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "properties/runner/registry.hpp"
#include "properties/statements/chapter4/points_in_faces.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/signed_crossings.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

constexpr std::size_t most_paths = 12;  // per pair

std::size_t number_of_crossings(const std::vector<Point>& path, const std::vector<Segment>& all) {
  std::size_t number = 0;
  for (std::size_t k = 0; k + 1 < path.size(); ++k)
    if (path[k] != path[k + 1])
      for (const Segment& s : all)
        if (signed_crossing(path[k], path[k + 1], s) != 0) ++number;
  return number;
}

std::string in_words(const std::vector<Point>& path) {
  std::string words;
  for (const Point& p : path) words += (words.empty() ? "" : " to ") + to_string(p);
  return words;
}

void expect(const std::vector<Point>& path, const std::vector<Segment>& all, Outcome& outcome) {
  const int before = winding_number(path.front(), all), after = winding_number(path.back(), all);
  const int sum = signed_crossings(path, all);
  ++outcome.counts["paths"];
  outcome.counts["crossings"] += number_of_crossings(path, all);
  if (before != after) ++outcome.counts["paths that change the winding number"];
  if (sum == after - before) return;
  outcome.fail("from " + in_words(path) + " the winding number goes from " +
               std::to_string(before) + " to " + std::to_string(after) +
               ", and signed crossings add up to " + std::to_string(sum));
}

Outcome check(const Summands& summands) {
  const std::vector<Segment> all = segments(convolution(summands.p, summands.q));
  const std::vector<Point> points = points_in_faces(all, {});
  const std::size_t paths = std::min(points.size(), most_paths);
  Outcome outcome;
  for (std::size_t k = 0; k < paths && outcome.kind == Outcome::Kind::holds; ++k) {
    const Point& from = points[k * points.size() / paths];
    const Point& to = points[(k + 1) % paths * points.size() / paths];
    const Segment& along = all[k * all.size() / paths];
    expect({from, to}, all, outcome);
    if (outcome.kind == Outcome::Kind::holds)
      expect({from, along.source, along.target, to}, all, outcome);
    if (outcome.kind == Outcome::Kind::holds) expect({from, along.target, to, from}, all, outcome);
  }
  return outcome;
}

const Registered registered(small_mixture(),
                            {.id = "observation-4.2.5",
                             .kills = {"ray-counts-both-ends", "steps-are-not-shifted",
                                       "tangent-set-without-ties", "reflex-turns-clockwise"},
                             .cases = 150,
                             .check = check});

}  // namespace

}  // namespace oplus
