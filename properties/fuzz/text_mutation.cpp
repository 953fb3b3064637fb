// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/text_mutation.hpp"

#include <algorithm>

#include "reference/chains/region_of.hpp"
#include "reference/families/rich_regions.hpp"

namespace oplus {

namespace {

template <typename T>
const T& one_of(Random& random, const std::vector<T>& all) {
  return all[uniform_index(random, all.size())];
}

/// A run of the characters of numbers, some of them digits.
struct Number {
  std::size_t at;
  std::size_t length;
};

std::vector<Number> numbers_in(const std::string& text) {
  const char* const characters = "0123456789+-./eE";
  std::vector<Number> all;
  for (std::size_t at = text.find_first_of(characters); at != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_not_of(characters, at), text.size());
    if (text.find_first_of("0123456789", at) < end) all.push_back({at, end - at});
    at = text.find_first_of(characters, end);
  }
  return all;
}

/// Small, in forms of its own, large, and none at all.
const std::vector<std::vector<std::string>>& numbers() {
  static const std::vector<std::vector<std::string>> all{
      std::vector<std::string>{"0", "1", "-1", "3", "4", "0.1", "0.5", "1/3", "-22/7", "1e0",
                               "1E-2"},
      std::vector<std::string>{"-0", "+1", ".5", "5.", "2.05", "007", "0/1", "1.5/2", "1e4096",
                               "-1e-4096"},
      std::vector<std::string>{"536870911", "-536870912", "9007199254740993",
                               "18446744073709551616", "170141183460469231731687303715884105728"},
      std::vector<std::string>{"1/0", "1/-3", "1e4097", "1e", "--1", "nan", "1,5"}};
  return all;
}

bool replace_number(Random& random, std::string& text, Format /*same for all*/) {
  const std::vector<Number> places = numbers_in(text);
  if (places.empty()) return false;
  const auto [at, length] = one_of(random, places);
  text.replace(at, length, one_of(random, one_of(random, numbers())));
  return true;
}

/// The same number in other words, so that nothing else changes.
bool rewrite_number(Random& random, std::string& text, Format format) {
  const std::vector<Number> places = numbers_in(text);
  if (places.empty()) return false;
  const auto [at, length] = one_of(random, places);
  const std::string number = text.substr(at, length);
  if (number.find_first_of("eE./") != std::string::npos) return false;
  std::vector<std::string> forms{number + ".0", number + "e0", number + "0e-1", number + "/1"};
  if (format == Format::geojson) forms.back() = '"' + forms.back() + '"';
  text.replace(at, length, one_of(random, forms));
  return true;
}

/// Both ends of an edge, or a vertex that two chains share, in one place.
bool copy_number(Random& random, std::string& text, Format /*same for all*/) {
  const std::vector<Number> places = numbers_in(text);
  if (places.size() < 2) return false;
  const Number from = one_of(random, places), to = one_of(random, places);
  text.replace(to.at, to.length, std::string(text, from.at, from.length));
  return true;
}

Region small_region(Random& random) {
  switch (uniform(random, 0, 2)) {
    case 0:
      return plain_region(random, 6);
    case 1:
      return holed_region(random, 6);
    default:
      return scattered_region(random, 5);
  }
}

/// Maps that keep a region valid, and make its coordinates decimals, fractions or large.
Region stretched(Random& random, Region region) {
  static const std::vector<Rational> factors{
      1, 1, {1, 2}, {1, 3}, {-1, 10}, {22, 7}, {101, 1000}, Rational("123456789012345678901")};
  const Rational factor = one_of(random, factors);
  const Rational shift = one_of(random, factors);
  // Turned by half a turn or not at all: orientations stay.
  const auto map = [&](Chain& chain) {
    for (Point& v : chain) v = {factor * v.x + shift, factor * v.y};
  };
  for (Component& component : region.components) {
    map(component.outer);
    for (Chain& hole : component.holes) map(hole);
  }
  return region;
}

}  // namespace

const std::vector<TextChange>& text_changes() {
  static const std::vector<TextChange> all{{"copy_number", copy_number},
                                           {"replace_number", replace_number},
                                           {"rewrite_number", rewrite_number}};
  return all;
}

std::string mutated_text(Random& random, std::string_view text, Format format) {
  std::string changed(text);
  if (one_in(random, 4) || numbers_in(changed).empty())
    return one_in(random, 2) ? new_sum_text(random, format) : new_region_text(random, format);
  // A number may have become a word, so that none is left.
  for (int changes = uniform(random, 1, 3); changes > 0 && !numbers_in(changed).empty();)
    if (one_of(random, text_changes()).apply(random, changed, format)) --changes;
  return changed;
}

std::string new_region_text(Random& random, Format format) {
  const Region region = small_region(random);
  return written(stretched(random, region), format);
}

std::string new_sum_text(Random& random, Format format) {
  const Region region = small_region(random);
  PlanarSet sum = canonical_sum(stretched(random, region));
  if (format != Format::dat) {
    const Rational x = uniform(random, -9, 9), y = uniform(random, -9, 9);
    sum.dangling_edges = {{{x, y}, {x + 2, y + 1}}, {{x, y}, {x + 3, y}}};
    // Not in the order that readers put them in.
    sum.isolated_vertices = {{x - 1, y / 3}, {x - 2, y}};
  }
  return written(sum, format);
}

}  // namespace oplus
