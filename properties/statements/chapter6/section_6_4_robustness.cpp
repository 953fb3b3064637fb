// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "properties/runner/checked_engines.hpp"
#include "properties/runner/registry.hpp"
#include "reference/families/diamond_and_u.hpp"
#include "reference/io/boundary_name.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

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

Outcome check(const Summands& summands) {
  return shows(summands, checked_engines(), {Boundary::closed, Boundary::open});
}

Outcome of_engine(const Engine& engine, Boundary boundary, const Summands& summands) {
  return shows(summands, {engine}, {boundary});
}

const Registered registered({
    .id = "section-6.4",
    .sources = {{"diamond-u", 1, 1}},
    .promises = {},
    .kills = {"dangling-edges-run-one-way"},
    .cases = 40,
    .check = check,
    .of_engine = of_engine,
});

}  // namespace

}  // namespace oplus
