// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/distance/distance.hpp"
#include "checked/layouts/check.hpp"
#include "checked/operations/complement.hpp"
#include "properties/runner/fitting_pairs.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/operations/places_of_q.hpp"
#include "reference/chains/frame.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/region.hpp"
#include "reference/definitions/squared_distance.hpp"
#include "reference/definitions/unbounded.hpp"

namespace oplus {

namespace {

/// Of regions whose interiors don't meet.
Rational squared_distance(const Region& a, const Region& b) {
  std::optional<Rational> least;
  for (const Segment& e : edges(a))
    for (const Segment& f : edges(b)) {
      if (!intersection(e, f).empty()) return 0;
      for (const Rational& here : {squared_distance(e.source, f), squared_distance(e.target, f),
                                   squared_distance(f.source, e), squared_distance(f.target, e)})
        if (!least || here < *least) least = here;
    }
  return least.value();
}

/// How many faults and forgiven overlaps there are between a region and a part, by the definitions.
std::pair<std::size_t, std::size_t> expected(const Region& other, const Region& part,
                                             const Rational& gap, const Rational& tolerance) {
  const Region framed_other = framed(other, 1000);
  if (!interiors_meet(framed_other, part))
    return {squared_distance(other, part) < gap * gap ? 1 : 0, 0};
  if (depth(framed_other, part)->squared_depth > tolerance * tolerance) return {1, 0};
  return {gap > 0 ? 1 : 0, 1};
}

Outcome check(const Summands& summands) {
  Outcome outcome;
  const LayoutRules all_rules[] = {
      {0, 0, 0}, {Rational(1, 2), 0, 0}, {0, Rational(1, 2), 0}, {0, 0, Rational(1, 2)}};
  for (const std::size_t kind : {0U, 1U}) {
    const auto [how, pair] = fitting_pair(summands, kind);
    if (is_unbounded(pair.p)) continue;
    const auto p = std::make_shared<const Region>(pair.p);
    for (const Region& q : places_of_q(pair, 2))
      for (const LayoutRules& rules : all_rules) {
        const auto right = [&](const Sheet& sheet, const Region& other, const Rational& gap) {
          const auto [faults, forgiven] = expected(other, q, gap, rules.tolerance);
          outcome.counts["faults"] += faults;
          outcome.counts["forgiven overlaps"] += forgiven;
          const SheetVerdict verdict = check(sheet, rules, 1);
          return verdict.faults.size() == faults && verdict.forgiven == forgiven;
        };
        Sheet two_parts, container;
        const PlacedPart part{"", 1, std::make_shared<const Region>(q), {}, {}};
        two_parts.parts = {{"", 1, p, {}, {}}, part};
        if (!right(two_parts, pair.p, rules.spacing)) return outcome.fail(how + ", two parts");
        container.container = pair.p;
        container.parts = {part};
        if (!right(container, complement(pair.p), rules.margin))
          return outcome.fail(how + ", a part in a container");
      }
  }
  return outcome;
}

const Registered registered({
    .id = "fact-layout",
    .sources = {{"grid", 5, 3}, {"holes", 3, 3}, {"tight", 2, 2}},
    .promises = {{"holes", 20}},
    .kills = {"layouts-fill-holes", "layouts-have-no-container", "layouts-have-one-margin",
              "layouts-count-boxes-as-near", "layouts-forgive-by-the-square"},
    .cases = 30,
    .check = check,
});

}  // namespace

}  // namespace oplus
