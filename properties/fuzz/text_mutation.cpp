// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/text_mutation.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "reference/families/rich_regions.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

using Tokens = std::vector<std::string>;

bool is_blank_token(const std::string& token) {
  return std::isspace(static_cast<unsigned char>(token[0])) != 0;
}

bool is_number(const std::string& token) {
  return token.find_first_of("0123456789") != std::string::npos &&
         token.find_first_not_of("0123456789+-./eE") == std::string::npos;
}

std::vector<std::size_t> places_of(const Tokens& tokens, bool (*wanted)(const std::string&)) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < tokens.size(); ++i)
    if (wanted(tokens[i])) places.push_back(i);
  return places;
}

template <typename T>
const T& one_of(Random& random, const std::vector<T>& all) {
  return all[uniform_index(random, all.size())];
}

Tokens::iterator at(Tokens& tokens, std::size_t i) {
  return tokens.begin() + static_cast<std::ptrdiff_t>(i);
}

/// Numbers on the edge of what is one, of what is small, and of what doubles hold.
const std::vector<std::string>& numbers() {
  static const std::vector<std::string> all{"0",
                                            "-0",
                                            "+1",
                                            "1",
                                            "-1",
                                            "0.5",
                                            ".5",
                                            "5.",
                                            "1e0",
                                            "1E-2",
                                            "1e4096",
                                            "1e4097",
                                            "-1e-4096",
                                            "1/3",
                                            "-22/7",
                                            "1/0",
                                            "0/1",
                                            "1/-3",
                                            "1.5/2",
                                            "536870911",
                                            "-536870912",
                                            "9007199254740993",
                                            "18446744073709551616",
                                            "170141183460469231731687303715884105728",
                                            "0.1",
                                            "3",
                                            "4",
                                            "007",
                                            "1e",
                                            "--1",
                                            "nan",
                                            "1,5"};
  return all;
}

const std::vector<std::string>& words(Format format) {
  static const std::array<std::vector<std::string>, 3> all{
      std::vector<std::string>{"0", "1", "3", "4", "\n", "3\n0 0\n4 0\n0 4\n", "\t", "-", "#"},
      std::vector<std::string>{"POLYGON", "MULTIPOLYGON", "EMPTY", "LINESTRING", "MULTILINESTRING",
                               "POINT", "MULTIPOINT", "GEOMETRYCOLLECTION", "(", ")", ",", " Z",
                               "(0 0, 4 0, 0 4, 0 0)", "(1 1, 1 2, 2 1, 1 1)", "polygon"},
      std::vector<std::string>{"{",
                               "}",
                               "[",
                               "]",
                               ",",
                               ":",
                               "\"type\"",
                               "\"Polygon\"",
                               "\"MultiPolygon\"",
                               "\"coordinates\"",
                               "\"geometries\"",
                               "\"GeometryCollection\"",
                               "\"LineString\"",
                               "\"MultiLineString\"",
                               "\"Point\"",
                               "\"MultiPoint\"",
                               "\"Feature\"",
                               "\"geometry\"",
                               "\"properties\"",
                               "\"1/3\"",
                               "null",
                               "true",
                               "\\u0041",
                               "[[0, 0], [4, 0], [0, 4], [0, 0]]",
                               "\"bbox\"",
                               "1e5"}};
  return all[static_cast<std::size_t>(format)];
}

bool replace_number(Random& random, Tokens& tokens, Format /*same for all*/) {
  const auto places = places_of(tokens, is_number);
  if (places.empty()) return false;
  tokens[one_of(random, places)] = one_of(random, numbers());
  return true;
}

/// The same number in other words, so that nothing else changes.
bool rewrite_number(Random& random, Tokens& tokens, Format format) {
  const auto places = places_of(tokens, is_number);
  if (places.empty()) return false;
  std::string& number = tokens[one_of(random, places)];
  if (number.find_first_of("eE./") != std::string::npos) return false;
  std::vector<std::string> forms{number + ".0", number + "e0", number + "0e-1", number + "/1"};
  if (format == Format::geojson) forms.back() = '"' + forms.back() + '"';
  number = one_of(random, forms);
  return true;
}

bool change_digit(Random& random, Tokens& tokens, Format /*same for all*/) {
  const auto places = places_of(tokens, is_number);
  if (places.empty()) return false;
  std::string& number = tokens[one_of(random, places)];
  number[uniform_index(random, number.size())] = static_cast<char>('0' + uniform(random, 0, 9));
  return true;
}

/// Both ends of an edge, or a vertex that two chains share, in one place.
bool copy_number(Random& random, Tokens& tokens, Format /*same for all*/) {
  const auto places = places_of(tokens, is_number);
  if (places.size() < 2) return false;
  const std::string number = tokens[one_of(random, places)];
  tokens[one_of(random, places)] = number;
  return true;
}

bool insert_word(Random& random, Tokens& tokens, Format format) {
  const std::size_t place = uniform_index(random, tokens.size() + 1);
  tokens.insert(at(tokens, place), one_of(random, words(format)));
  return true;
}

bool replace_token(Random& random, Tokens& tokens, Format format) {
  if (tokens.empty()) return false;
  const std::size_t place = uniform_index(random, tokens.size());
  tokens[place] = one_of(random, words(format));
  return true;
}

bool remove_token(Random& random, Tokens& tokens, Format /*same for all*/) {
  if (tokens.empty()) return false;
  tokens.erase(at(tokens, uniform_index(random, tokens.size())));
  return true;
}

struct Run {
  std::size_t from;
  std::size_t to;
};

Run run(Random& random, const Tokens& tokens) {
  const std::size_t from = uniform_index(random, tokens.size());
  const std::size_t length = 1 + uniform_index(random, std::min<std::size_t>(32, tokens.size()));
  return {from, std::min(tokens.size(), from + length)};
}

bool remove_run(Random& random, Tokens& tokens, Format /*same for all*/) {
  if (tokens.empty()) return false;
  const auto [from, to] = run(random, tokens);
  tokens.erase(at(tokens, from), at(tokens, to));
  return true;
}

bool double_run(Random& random, Tokens& tokens, Format /*same for all*/) {
  if (tokens.empty()) return false;
  const auto [from, to] = run(random, tokens);
  const Tokens copy(at(tokens, from), at(tokens, to));
  const std::size_t place = uniform_index(random, tokens.size() + 1);
  tokens.insert(at(tokens, place), copy.begin(), copy.end());
  return true;
}

bool change_blanks(Random& random, Tokens& tokens, Format /*same for all*/) {
  static const std::vector<std::string> blanks{" ", "\n", "\r\n", "\t", "  ", "\v\f"};
  const auto places = places_of(tokens, is_blank_token);
  if (places.empty()) return false;
  tokens[one_of(random, places)] = one_of(random, blanks);
  return true;
}

bool change_case(Random& random, Tokens& tokens, Format /*same for all*/) {
  if (tokens.empty()) return false;
  std::string& token = tokens[uniform_index(random, tokens.size())];
  const auto changed = [](unsigned char c) {
    return static_cast<char>(std::isupper(c) != 0 ? std::tolower(c) : std::toupper(c));
  };
  const std::string before = token;
  std::transform(token.begin(), token.end(), token.begin(), changed);
  return token != before;
}

/// A byte that no text contains, or half a character.
bool insert_byte(Random& random, Tokens& tokens, Format /*same for all*/) {
  if (tokens.empty()) return false;
  std::string& token = tokens[uniform_index(random, tokens.size())];
  token.insert(uniform_index(random, token.size() + 1), 1,
               static_cast<char>(uniform(random, 0, 255)));
  return true;
}

bool start_anew(Random& random, Tokens& all, Format format) {
  all = tokens(one_in(random, 2) ? new_sum_text(random, format) : new_region_text(random, format));
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
  static const std::vector<Rational> factors{1,
                                             1,
                                             Rational(1, 2),
                                             Rational(1, 3),
                                             Rational(-1, 10),
                                             Rational("123456789012345678901"),
                                             Rational(22, 7),
                                             Rational("101/1000")};
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

std::string joined(const Tokens& tokens) {
  std::string text;
  for (const std::string& token : tokens) text += token;
  return text;
}

}  // namespace

std::vector<std::string> tokens(std::string_view text) {
  enum class Kind { blank, word, mark };
  const auto kind = [](char c) {
    if (std::isspace(static_cast<unsigned char>(c)) != 0) return Kind::blank;
    return std::string_view("()[]{},:\"").find(c) == std::string_view::npos ? Kind::word
                                                                            : Kind::mark;
  };
  Tokens result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const Kind of_this = kind(text[i]);
    if (i == 0 || of_this == Kind::mark || kind(text[i - 1]) != of_this) result.emplace_back();
    result.back() += text[i];
  }
  return result;
}

const std::vector<TextChange>& text_changes() {
  static const std::vector<TextChange> all{
      {"change_blanks", change_blanks}, {"change_case", change_case},
      {"change_digit", change_digit},   {"copy_number", copy_number},
      {"double_run", double_run},       {"insert_byte", insert_byte},
      {"insert_word", insert_word},     {"remove_run", remove_run},
      {"remove_token", remove_token},   {"replace_number", replace_number},
      {"replace_token", replace_token}, {"rewrite_number", rewrite_number},
      {"start_anew", start_anew},
  };
  return all;
}

std::string mutated_text(Random& random, std::string_view text, Format format) {
  Tokens all = tokens(text);
  for (int changes = uniform(random, 1, 3); changes > 0;)
    if (one_of(random, text_changes()).apply(random, all, format)) --changes;
  return joined(all);
}

std::string crossed_text(Random& random, std::string_view a, std::string_view b) {
  Tokens first = tokens(a), second = tokens(b);
  first.resize(uniform_index(random, first.size() + 1));
  second.erase(second.begin(), at(second, uniform_index(random, second.size() + 1)));
  return joined(first) + joined(second);
}

std::string new_region_text(Random& random, Format format) {
  const Region region = small_region(random);
  return written(stretched(random, region), format);
}

std::string new_sum_text(Random& random, Format format) {
  const Region region = small_region(random);
  MinkowskiSum sum = canonical_sum(stretched(random, region));
  if (format != Format::dat) {
    const Rational x = uniform(random, -9, 9), y = uniform(random, -9, 9);
    sum.dangling_edges = {{{x, y}, {x + 2, y + 1}}, {{x, y}, {x + 3, y}}};
    // Not in the order that readers put them in.
    sum.isolated_vertices = {{x - 1, y / 3}, {x - 2, y}};
  }
  return written(sum, format);
}

}  // namespace oplus
