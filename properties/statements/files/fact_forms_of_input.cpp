// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cctype>
#include <cstdint>

#include "properties/runner/registry.hpp"
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

Outcome check(const Summands& summands) {
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

const Registered registered({
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
    .check = check,
});

}  // namespace

}  // namespace oplus
