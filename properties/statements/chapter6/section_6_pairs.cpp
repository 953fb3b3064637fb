// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "checked/arrangement/rca.hpp"
#include "properties/runner/checked_engines.hpp"
#include "properties/runner/each_engine.hpp"
#include "properties/runner/registry.hpp"
#include "reference/families/pairs.hpp"
#include "reference/io/boundary_name.hpp"
#include "reference/io/counted.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

/// The fork of n teeth on each arm has 8n + 4 vertices.
std::size_t teeth(const Region& fork) { return (vertex_count(fork) - 4) / 8; }

Outcome law_of_fork(const Sum& computed, const Summands& summands) {
  // A pair that was shrunk or given by the user may not be of the family.
  if (vertex_count(summands.q) != 6 || vertex_count(summands.p) % 8 != 4)
    return {Outcome::Kind::discarded, {}, {}};
  Outcome outcome;
  const std::size_t n = teeth(summands.p);
  const PlanarSet sum = computed(summands.p, summands.q);
  outcome.counts["holes"] += sum.holes.size();
  if (sum.outer.size() == 1 && sum.holes.size() == n * n) return outcome;
  return outcome.fail(counted(n, "tooth", "teeth") + " per arm, " +
                      counted(sum.outer.size(), "outer chain", "outer chains") + " and " +
                      counted(sum.holes.size(), "hole", "holes"));
}

Outcome check_fork(const Summands& summands) {
  const Engine by_rca{.name = "rca", .compute = rca};
  Outcome both;
  for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
    const Outcome outcome = law_of_fork(Sum(by_rca, boundary), summands);
    if (outcome.kind != Outcome::Kind::holds) return outcome;
    for (const auto& [what, count] : outcome.counts) both.counts[what] += count;
  }
  return both;
}

const Registered section_6_1_4({
    .id = "section-6.1.4",
    .sources = {{"fork", 6, 1}},
    .promises = {{"reflex vertices", 100}, {"parallel edges", 100}},
    .kills = {"no-candidate-is-a-hole"},
    .cases = 60,
    .check = check_fork,
    .of_engine = for_one_engine(law_of_fork),
});

/// How many parts a sum has, and of how many vertices.
using Shape = std::vector<std::size_t>;

Shape shape_of(const PlanarSet& sum) {
  Shape shape = {sum.dangling_edges.size(), sum.isolated_vertices.size(), sum.outer.size()};
  for (const Chain& chain : sum.outer) shape.push_back(chain.size());
  shape.push_back(sum.holes.size());
  for (const Chain& hole : sum.holes) shape.push_back(hole.size());
  return shape;
}

std::string in_words(const Shape& shape) {
  std::string words;
  for (const std::size_t number : shape)
    words += (words.empty() ? "" : " ") + std::to_string(number);
  return words;
}

/// 1/100 and 2/100 in the order of the given numbers, 0 where they are 0.
struct Perturbation {
  Rational eps1;
  Rational eps2;

  Perturbation visible() const {
    const Rational one(1, 100), two(2, 100);
    if (eps1 == 0) return {0, eps2 == 0 ? Rational(0) : one};
    if (eps2 == 0) return {one, 0};
    if (eps1 == eps2) return {one, one};
    return eps1 < eps2 ? Perturbation{one, two} : Perturbation{two, one};
  }
};

Rational power_of_two(int exponent) {
  Rational result = 1;
  mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  return result;
}

Outcome shows(const Summands& summands, const std::vector<Engine>& engines,
              const std::vector<Boundary>& boundaries) {
  const Outcome discarded{Outcome::Kind::discarded, "not a diamond and a room", {}};
  if (vertex_count(summands.p) != 12 || vertex_count(summands.q) != 4) return discarded;
  const Perturbation given{3 - summands.p.components[0].outer[10].x,
                           -summands.q.components[0].outer[0].x};
  if (given.eps1 < 0 || given.eps1 >= 3 || given.eps2 < 0 ||
      summands != diamond_and_u(given.eps1, given.eps2))
    return discarded;

  const Perturbation visible = given.visible();
  const Summands seen = diamond_and_u(visible.eps1, visible.eps2);
  const OracleSums expected = oracle_sums(seen.p, seen.q);
  Outcome outcome;
  // From a number that a double can add to 1 to one that underflows to zero.
  for (const Rational& scale : {power_of_two(-10), power_of_two(-60), power_of_two(-1100)}) {
    const Summands tiny = diamond_and_u(scale * given.eps1, scale * given.eps2);
    for (const Boundary boundary : boundaries) {
      const Shape right = shape_of(boundary == Boundary::closed ? expected.closed : expected.open);
      for (const Engine& engine : engines) {
        const Shape shape = shape_of(engine.compute(tiny.p, tiny.q, boundary, {}).sum);
        ++outcome.counts["sums"];
        if (shape == right) continue;
        return outcome.fail(engine.name + ", " + name(boundary) + ": shape " + in_words(shape) +
                            " instead of " + in_words(right));
      }
    }
  }
  return outcome;
}

Outcome check_robustness(const Summands& summands) {
  return shows(summands, checked_engines(), {Boundary::closed, Boundary::open});
}

Outcome of_engine(const Engine& engine, Boundary boundary, const Summands& summands) {
  return shows(summands, {engine}, {boundary});
}

const Registered section_6_4({
    .id = "section-6.4",
    .sources = {{"diamond-u", 1, 1}},
    .promises = {},
    .kills = {"dangling-edges-run-one-way"},
    .cases = 40,
    .check = check_robustness,
    .of_engine = of_engine,
});

}  // namespace

}  // namespace oplus
