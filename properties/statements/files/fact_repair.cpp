// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "checked/repair/repair.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/placements/overlay.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/validity.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

struct Damaged {
  Region region;
  /// How each repair is to begin, in their order.
  std::vector<std::string> mends = {};
};

/// The end of a spike at b, which is in the direction of neither a nor c.
Point tip_at(const Point& a, const Point& b, const Point& c) {
  const Vector directions[] = {{1, 0}, {0, 1}, {1, 1}};
  for (const Vector& d : directions)
    if (sgn(cross(d, b - a)) != 0 && sgn(cross(d, c - b)) != 0) return b + d;
  return b;  // two edges have two directions
}

/// Each chain reversed, one of its vertices twice, a spike at its last one, and the first one again at its end.
Damaged damaged(Region region) {
  Damaged result;
  std::vector<std::string> turned;
  std::size_t number = 0;
  const auto damage = [&](Chain& chain, const std::string& name) {
    std::ranges::reverse(chain);
    const std::size_t at = number++ % chain.size();
    const Point copy = chain[at];
    chain.insert(chain.begin() + static_cast<std::ptrdiff_t>(at), copy);
    const std::size_t last = chain.size();
    const Point end = chain.back();
    chain.push_back(
        tip_at(chain[last - 2] == end ? chain[last - 3] : chain[last - 2], end, chain.front()));
    chain.push_back(end);
    chain.push_back(chain.front());
    const auto vertex = [&](std::size_t v) {
      return "vertex " + std::to_string(v) + " of " + name;
    };
    const auto is_equal = [&](std::size_t second, std::size_t first) {
      return vertex(second) + " is equal to vertex " + std::to_string(first) + ", " +
             to_string(chain[first - 1]) + ";";
    };
    for (std::string mend :
         {is_equal(at + 2, at + 1),
          vertex(last + 1) + ", " + to_string(chain[last]) + ", is the tip of a spike;",
          is_equal(last + 2, at + 2 == last ? at + 1 : last), is_equal(last + 3, 1)})
      result.mends.push_back(std::move(mend));
    turned.push_back(name + " was ");
  };
  for (std::size_t c = 0; c < region.components.size(); ++c) {
    const std::string component = "component " + std::to_string(c + 1);
    damage(region.components[c].outer, "outer chain of " + component);
    for (std::size_t h = 0; h < region.components[c].holes.size(); ++h)
      damage(region.components[c].holes[h], "hole " + std::to_string(h + 1) + " of " + component);
  }
  result.mends.insert(result.mends.end(), turned.begin(), turned.end());
  result.region = std::move(region);
  return result;
}

/// What is wrong with the repair of a region that was damaged; empty if nothing is.
std::string broken(const Region& region) {
  const Damaged input = damaged(region);
  const auto [mended, mends] = repaired(unchecked(input.region, "region"));
  if (find_defect(mended)) return "it is not valid";
  if (canonical_sum(mended) != canonical_sum(region)) return "it is another set";
  for (std::size_t i = 0; i < std::max(mends.size(), input.mends.size()); ++i) {
    const std::string wanted = i < input.mends.size() ? input.mends[i] : "nothing";
    const std::string said = i < mends.size() ? mends[i].what : "nothing";
    if (!said.starts_with(wanted)) return "it says '" + said + "' instead of '" + wanted + "'";
  }
  return repaired(unchecked(mended, "region")).mends.empty() ? "" : "the second time it does more";
}

/// All chains of P and Q together by a fill rule, on a point of every cell of both and the result.
Outcome filled(const Summands& summands, FillRule rule) {
  Outcome outcome;
  const Region both = together(summands.p, summands.q);
  const bool was_valid = !find_defect(both);
  const auto [region, mends] = repaired(unchecked(both, "region"), rule);
  ++outcome.counts[was_valid ? "valid regions" : "chains that were filled"];
  if (was_valid ? !mends.empty() : mends.size() != 1 || mends[0].kind != MendKind::filled)
    return outcome.fail("it does not say just that chains were filled");
  if (const std::optional<Defect> defect = find_defect(region))
    return outcome.fail("what was filled is invalid: " + describe(defect->kind), defect->where);
  for (const OverlaidPoint& x : overlaid({summands.p, summands.q, region})) {
    if (x.in[0] == Location::boundary || x.in[1] == Location::boundary) continue;
    const bool in_p = x.in[0] == Location::inside, in_q = x.in[1] == Location::inside;
    const bool wanted = rule == FillRule::even_odd ? in_p != in_q : in_p || in_q;
    ++outcome.counts["points"];
    if ((x.in[2] == Location::inside) != wanted)
      return outcome.fail(to_string(x.point) + " is wrong, filled by " +
                              (rule == FillRule::even_odd ? "even-odd" : "nonzero"),
                          x.point);
  }
  return outcome;
}

Outcome check(const Summands& summands) {
  Outcome all;
  for (const Region* region : {&summands.p, &summands.q}) {
    ++all.counts["damaged regions"];
    if (const std::string what = broken(*region); !what.empty())
      return all.fail("of " + wkt(*region) + ", damaged and repaired: " + what);
  }
  for (const FillRule rule : {FillRule::even_odd, FillRule::nonzero}) {
    const Outcome one = filled(summands, rule);
    for (const auto& [what, count] : one.counts) all.counts[what] += count;
    if (one.kind == Outcome::Kind::fails) return all.fail(one.why, one.at);
  }
  return all;
}

const Registered registered({
    .id = "fact-repair",
    .sources =
        {{"grid", 8, 4}, {"holes", 5, 3}, {"components", 4, 2}, {"tight", 4, 1}, {"star", 8, 1}},
    .promises = {{"holes", 15}, {"several components", 10}, {"reflex vertices", 10}},
    .kills = {"even-odd-is-nonzero", "repair-counts-from-zero", "repair-forgets-the-last-edge"},
    .cases = 100,
    .check = check,
});

}  // namespace

}  // namespace oplus
