// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

#include "reference/io/placed_geometry.hpp"
#include "reference/io/quoting.hpp"

namespace oplus {

namespace {

std::string upper(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return result;
}

constexpr std::string_view punctuation = "(),=;";

/// How many coordinates vertices have where Z, M or ZM stands behind the name of a geometry.
std::size_t dimension_called(std::string_view word) {
  if (word == "Z" || word == "M") return 3;
  return word == "ZM" ? 4 : 0;
}

/// Takes Z, M or ZM from the end of a geometry's name; returns it.
std::string take_dimension(std::string& keyword) {
  const std::size_t name = keyword.find_last_not_of("ZM") + 1;
  const std::string word = keyword.substr(name);
  if (name == 0 || dimension_called(word) == 0) return "";
  keyword.resize(name);
  return word;
}

class WktReader {
 public:
  WktReader(const InputText& input, Wanted wanted)
      : input_(input), wanted_(wanted), tokens_(input, punctuation) {}

  PlacedGeometry read() {
    do {
      reference_system();
      geometry(true);
      if (!tokens_.peek().is_end() && !tokens_.is_first_of_line())
        refuse_next("after the geometry", "the end of the line");
    } while (!tokens_.peek().is_end());
    return std::move(result_);
  }

 private:
  /// Reads "SRID=4326;", which may stand before a geometry. There is nothing to be converted.
  void reference_system() {
    if (upper(tokens_.peek().text) != "SRID") return;
    tokens_.take();
    take("=", "after SRID", "'='");
    const Token number = tokens_.take();
    if (number.is_end() || number.text.find_first_not_of("0123456789") != std::string_view::npos)
      input_.refuse(number.at, describe(number) + " where an SRID should be",
                    "an integer without a sign");
    if (!srid_.empty() && number.text != srid_)
      input_.refuse(number.at, "the SRID " + quote(number.text) + " after " + quote(srid_),
                    "one coordinate system");
    srid_ = number.text;
    take(";", "after the SRID", "';'");
  }

  /// Reads one tagged geometry into the result.
  void geometry(bool may_be_collection) {
    const Token token = tokens_.take();
    std::string keyword = upper(token.text);
    const std::string of_keyword = take_dimension(keyword);
    dimension_ = dimension_called(of_keyword);
    const bool is_multi = keyword.starts_with("MULTI");
    const std::string of_parts = keyword.substr(is_multi ? 5 : 0);
    const bool sum = wanted_ == Wanted::sum;
    void (WktReader::*part)() = nullptr;
    if (of_parts == "POLYGON") part = &WktReader::polygon;
    if (sum && of_parts == "LINESTRING") part = &WktReader::line_string;
    if (sum && of_parts == "POINT")
      part = is_multi ? &WktReader::point_with_or_without : &WktReader::parenthesized_point;
    if (part != nullptr) {
      if (!has_content()) return;
      if (!is_multi) return (this->*part)();
      list(keyword, [&] {
        if (!take_empty()) (this->*part)();
      });
    } else if (may_be_collection && keyword == "GEOMETRYCOLLECTION") {
      if (has_content()) list(keyword, [&] { geometry(false); });
    } else {
      input_.refuse(token.at, describe(token) + " where a geometry should be",
                    !sum ? may_be_collection ? "POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION"
                                             : "POLYGON or MULTIPOLYGON"
                    : may_be_collection ? "(MULTI)POLYGON, (MULTI)LINESTRING, (MULTI)POINT or "
                                          "GEOMETRYCOLLECTION"
                                        : "(MULTI)POLYGON, (MULTI)LINESTRING or (MULTI)POINT");
    }
  }

  bool take_empty() {
    const bool is_empty = upper(tokens_.peek().text) == "EMPTY";
    if (is_empty) tokens_.take();
    return is_empty;
  }

  bool has_content() {
    const std::size_t dimension = dimension_called(upper(tokens_.peek().text));
    if (dimension != 0 && dimension_ == 0) {
      dimension_ = dimension;
      tokens_.take();
    }
    return !take_empty();
  }

  /// Reads "(item, item, ...)".
  template <typename Item>
  void list(const std::string& name, Item item) {
    take("(", "in " + name, "'(' or EMPTY");
    item();
    while (tokens_.peek().text == ",") {
      tokens_.take();
      item();
    }
    take(")", "in " + name, "',' or ')'");
  }

  void polygon() {
    ChainName name{result_.next_component(), 0};
    list("component " + std::to_string(name.component), [&] {
      result_.chains.push_back(ring(name));
      ++name.hole;
    });
  }

  PlacedChain ring(const ChainName& name) {
    PlacedChain chain = vertices_of(describe(name));
    chain.name = name;
    remove_closing_vertex(chain);
    return chain;
  }

  void line_string() {
    result_.line_strings.push_back(
        vertices_of("line string " + std::to_string(result_.line_strings.size() + 1)));
  }

  void parenthesized_point() {
    take("(", "in POINT", "'(' or EMPTY");
    point();
    take(")", "in POINT", "')'");
  }

  void point_with_or_without() {
    if (tokens_.peek().text == "(")
      parenthesized_point();
    else
      point();
  }

  void point() {
    const std::string number = std::to_string(result_.points.vertices.size() + 1);
    add_vertex(result_.points, [&] { return "point " + number; });
  }

  PlacedChain vertices_of(const std::string& name) {
    PlacedChain chain{.start = tokens_.peek().at};
    const std::string_view ring = tokens_.rest().substr(0, tokens_.rest().find(')'));
    const auto commas = static_cast<std::size_t>(std::count(ring.begin(), ring.end(), ','));
    chain.reserve(commas + 1, ring.size());
    list(name, [&] {
      add_vertex(chain,
                 [&] { return "vertex " + std::to_string(chain.vertices.size()) + " of " + name; });
    });
    return chain;
  }

  template <typename Name>
  void add_vertex(PlacedChain& chain, Name name) {
    chain.places.push_back(tokens_.peek().at);
    Point& vertex = chain.vertices.emplace_back();
    put_coordinate(vertex.x, [&] { return "x of " + name(); });
    put_coordinate(vertex.y, [&] { return "y of " + name(); });
    std::size_t dimension = 2;
    while (dimension < 4 && is_number_left_out(tokens_.peek().text)) {
      tokens_.take();
      ++dimension;
    }
    if (dimension_ == 0) dimension_ = dimension;
    if (dimension != dimension_)
      refuse_dimension(input_, chain.places.back(), name(), dimension, dimension_);
    if (dimension > 2) ++result_.beyond_the_plane;
  }

  /// Whether a word can be a Z or M, which some programs write as NaN where there is none.
  static bool is_number_left_out(std::string_view text) {
    if (text.empty() || punctuation.find(text[0]) != std::string_view::npos) return false;
    NumberFault ignored;
    return parse_number(text, ignored).has_value() || upper(text) == "NAN";
  }

  template <typename Name>
  void put_coordinate(Rational& value, Name name) {
    const Token token = tokens_.take();
    const bool is_word =
        !token.is_end() && punctuation.find(token.text[0]) == std::string_view::npos;
    if (!is_word)
      input_.refuse(token.at, describe(token) + " where " + name() + " should be", "a number");
    oplus::put_coordinate(input_, token.text, token.at, value, name);
  }

  void take(std::string_view symbol, const std::string& where, const std::string& expected) {
    if (tokens_.peek().text != symbol) refuse_next(where, expected);
    tokens_.take();
  }

  [[noreturn]] void refuse_next(const std::string& where, const std::string& expected) {
    input_.refuse(tokens_.peek().at, describe(tokens_.peek()) + ' ' + where, expected);
  }

  const InputText& input_;
  Wanted wanted_;
  Tokenizer tokens_;
  PlacedGeometry result_;
  std::string_view srid_;      ///< of the geometries so far; empty: none was said
  std::size_t dimension_ = 0;  ///< of the geometry that is read; 0: as its first vertex has
};

}  // namespace

PlacedGeometry parse_wkt(const InputText& input, Wanted wanted) {
  return WktReader(input, wanted).read();
}

}  // namespace oplus
