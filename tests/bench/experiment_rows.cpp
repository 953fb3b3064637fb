// SPDX-License-Identifier: GPL-3.0-or-later
// Chapter 6 of the thesis: rca for its RCA, winding for its CWEIN. Both find low-dimensional features, as there
// (Section 6.2.1).
#include <random>

#include "checked/arrangement/hole_test.hpp"
#include "reference/families/pairs.hpp"
#include "reference/families/polygons.hpp"
#include "tests/bench/row.hpp"

namespace oplus {

namespace {

/// Sizes from `smallest` to `largest`.
struct SizeRange {
  std::size_t smallest;
  std::size_t largest;
  std::size_t step = 0;  ///< 0: each size is twice the previous one

  /// With the largest scaled; always the smallest.
  std::vector<std::size_t> sizes(double scale) const {
    std::vector<std::size_t> result;
    for (std::size_t size = smallest;
         result.empty() || static_cast<double>(size) <= static_cast<double>(largest) * scale;
         size += step == 0 ? size : step)
      result.push_back(size);
    return result;
  }
};

using Make = Summands (*)(Random& random, std::size_t size);

/// A pair of a polygon of this size and one of 100 vertices.
template <Region (*p_of)(Random&, std::size_t), Region (*q_of)(Random&, std::size_t)>
Summands with_100(Random& random, std::size_t size) {
  return {p_of(random, size), q_of(random, 100)};  // in this order
}

Summands fork(Random&, std::size_t teeth) { return fork_and_l(teeth); }

/// A pair that does not depend on what else runs.
std::vector<Summands> random_pair(const std::string& experiment, std::uint64_t seed,
                                  std::size_t size, Make make) {
  constexpr std::uint64_t index = 1;  // one pair per size, where the thesis has 5 or 20
  std::vector<std::uint32_t> material(experiment.begin(), experiment.end());
  for (const std::uint64_t number : {seed, std::uint64_t{size}, index}) {
    material.push_back(static_cast<std::uint32_t>(number));
    material.push_back(static_cast<std::uint32_t>(number >> 32));
  }
  std::seed_seq mixed(material.begin(), material.end());  // its output is fixed by the standard
  Random random(mixed);
  return {make(random, size)};
}

}  // namespace

Rows experiment_rows(std::uint64_t seed, double scale) {
  Rows rows;
  const auto add = [&](const std::string& experiment, const std::string& name,
                       const std::string& what, const auto& make) -> Row& {
    return rows.emplace_back(Row{.name = experiment + '_' + name,
                                 .what = what,
                                 .subject = experiment,
                                 .engines = {"rca", "winding"},
                                 .make = make,
                                 .boundary = Boundary::open});
  };
  const auto published = [](const std::string& name) {
    return [=] { return published_pair(name + "_part1", name + "_part2"); };
  };
  for (const std::string name : {"comb", "fork", "stars"})
    add("table-6.1", name, name, published(name));

  /// An experiment in which only P grows.
  const auto add_growing = [&](const std::string& experiment, const SizeRange& range, Make make) {
    for (const std::size_t size : range.sizes(scale))
      add(experiment, std::to_string(size), "size " + std::to_string(size),
          [=] { return random_pair(experiment, seed, size, make); });
  };
  // The thesis's range (Section 6.2.4), but one pair per size instead of 20.
  add_growing("convex-star", {50, 980, 30}, with_100<convex_polygon, star_polygon>);
  // In the thesis to 340 in steps of 3; winding would need minutes and more than 10 GB per pair.
  add_growing("star-star", {25, 160, 15}, with_100<star_polygon, star_polygon>);
  // In the thesis in steps of 5, five pairs per size.
  add_growing("simple-simple", {30, 200, 10}, with_100<simple_polygon, simple_polygon>);
  // The thesis counts 50 to 250 teeth, about four times as many vertices, and n² holes. Ours have n teeth per
  // arm, 8n + 4 vertices and n² holes, the same numbers of vertices and of holes.
  add_growing("fork-l", {10, 250, 30}, fork);

  // Each pair twice: about candidates, the questions of rca; and about edges, a question per edge.
  const auto add_hole_tests = [&](const std::string& name, const std::string& what,
                                  const std::function<std::vector<Summands>()>& make) {
    for (const std::string about : {"candidates", "edges"}) {
      Row& row = add("hole-tests", name + '_' + about, what, make);
      row.kind = "hole tests";
      row.about_edges = about == "edges";
      row.engines.clear();
      for (const auto& [method, of] : hole_test_methods()) row.engines.push_back(method);
    }
  };
  for (const std::string name : {"comb", "fork", "stars"})
    add_hole_tests("published_" + name, name, published(name));
  for (const std::size_t m : SizeRange{25, 200}.sizes(scale))
    add_hole_tests("simple_" + std::to_string(m), "simple " + std::to_string(m), [=] {
      return random_pair("hole-tests", seed, m, with_100<simple_polygon, simple_polygon>);
    });
  for (const std::size_t teeth : SizeRange{5, 80}.sizes(scale))
    add_hole_tests("fork_" + std::to_string(teeth), "fork-l " + std::to_string(teeth),
                   [=] { return std::vector<Summands>{fork_and_l(teeth)}; });

  // Both summands grow, except the L, and the convolution has from n + m to about nm segments.
  const auto add_cycles = [&](const std::string& family, const SizeRange& range, Make make) {
    for (const std::size_t size : range.sizes(scale)) {
      const std::string of_size = std::to_string(size);
      Row& row = add("cycles", family + '_' + of_size, "size " + of_size,
                     [=] { return random_pair("cycles " + family, seed, size, make); });
      row.kind = "convolution";
      row.engines = {"naive", "traced", "without-points"};
    }
  };
  add_cycles("convex", {25, 1600}, two<convex_polygon>);
  add_cycles("simple", {25, 400}, two<simple_polygon>);
  add_cycles("star", {25, 400}, two<star_polygon>);
  add_cycles("fork", {5, 160}, fork);

  add("faults", "fork_10", "fork", [] { return std::vector<Summands>{fork_and_l(10)}; }).engines = {
      "rca", "crash", "hang", "wrong"};
  rows.back().boundary = Boundary::closed;
  return rows;
}

}  // namespace oplus
