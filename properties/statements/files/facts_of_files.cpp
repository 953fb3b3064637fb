// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cctype>
#include <cstdint>

#include "checked/repair/repair.hpp"
#include "properties/runner/registry.hpp"
#include "properties/statements/placements/overlay.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/validity.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// A subpath for each chain, closed by Z; level and upright edges are H and V. Relative: each point as its
/// difference from the one before, which is the start of the last subpath after Z.
std::string svg_path(const Region& region, bool is_relative) {
  std::string path;
  Point here;
  for (const Chain& chain : chains(region)) {
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const char letter = i == 0                 ? 'M'
                          : chain[i].y == here.y ? 'H'
                          : chain[i].x == here.x ? 'V'
                                                 : 'L';
      const Point to = is_relative ? chain[i] - here : chain[i];
      path += is_relative ? static_cast<char>(std::tolower(letter)) : letter;
      if (letter != 'V') path += to_string(to.x);
      if (letter == 'M' || letter == 'L') path += ' ';
      if (letter != 'H') path += to_string(to.y);
      here = chain[i];
    }
    path += 'z';
    here = chain.front();
  }
  return path;
}

/// The bytes of a number, the most significant one first or last.
template <typename Word>
std::string bytes(Word value, bool is_little) {
  std::string result;
  for (std::size_t i = 0; i < sizeof(Word); ++i) {
    const std::size_t byte = is_little ? i : sizeof(Word) - 1 - i;
    result += static_cast<char>(value >> (8 * byte) & 0xff);
  }
  return result;
}

/// Well-known binary, in bytes: a MultiPolygon in the one order, its polygons in the other.
std::string well_known_binary(const Region& region, bool is_little) {
  constexpr std::uint32_t polygon_type = 3, multipolygon_type = 6;
  const auto count = [](std::size_t n, bool little) {
    return bytes(static_cast<std::uint32_t>(n), little);
  };
  std::string result(1, is_little ? '\1' : '\0');
  result += count(multipolygon_type, is_little) + count(region.components.size(), is_little);
  const bool of_parts = !is_little;
  for (const Component& component : region.components) {
    result += of_parts ? '\1' : '\0';
    result += count(polygon_type, of_parts) + count(1 + component.holes.size(), of_parts);
    for (Chain ring : chains({{component}})) {
      ring.push_back(ring.front());
      result += count(ring.size(), of_parts);
      for (const Point& p : ring)
        for (const Rational* c : {&p.x, &p.y})
          result += bytes(std::bit_cast<std::uint64_t>(c->get_d()), of_parts);
    }
  }
  return result;
}

Outcome check_forms_of_input(const Summands& summands) {
  Outcome outcome;
  for (const Region* region : {&summands.p, &summands.q}) {
    std::vector<std::pair<std::string, std::string>> forms = {
        {"an SVG path", svg_path(*region, false)},
        {"a relative SVG path", svg_path(*region, true)}};
    if (!not_a_double(*region, {})) {
      forms.emplace_back("WKB in hexadecimal digits", written(*region, Format::wkb));
      for (const bool is_little : {false, true})
        forms.emplace_back("WKB in bytes", well_known_binary(*region, is_little));
    }
    for (const auto& [name, text] : forms) {
      ++outcome.counts[name];
      const ReadRegion read = read_region(text, name);
      if (read.region != *region || !read.notes.empty())
        return outcome.fail("written as " + name + " and read, it is " + wkt(read.region));
    }
  }
  return outcome;
}

const Registered fact_forms_of_input({
    .id = "fact-forms-of-input",
    .sources = {{"grid", 8, 3},
                {"holes", 6, 3},
                {"components", 5, 2},
                {"islands", 1, 1},
                {"diamond-u", 1, 1}},
    .promises = {{"holes", 25}, {"several components", 10}},
    .kills = {"parts-have-the-first-byte-order", "paths-go-on-where-they-ended",
              "paths-have-no-holes"},
    .cases = 200,
    .check = check_forms_of_input,
});

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

Outcome check_repair(const Summands& summands) {
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

const Registered fact_repair({
    .id = "fact-repair",
    .sources =
        {{"grid", 8, 4}, {"holes", 5, 3}, {"components", 4, 2}, {"tight", 4, 1}, {"star", 8, 1}},
    .promises = {{"holes", 15}, {"several components", 10}, {"reflex vertices", 10}},
    .kills = {"even-odd-is-nonzero", "repair-counts-from-zero", "repair-forgets-the-last-edge"},
    .cases = 100,
    .check = check_repair,
});

}  // namespace

}  // namespace oplus
