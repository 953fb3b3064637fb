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

constexpr std::string_view punctuation = "(),";

class WktReader {
 public:
  WktReader(const InputText& input, Wanted wanted)
      : input_(input), wanted_(wanted), tokens_(input, punctuation) {}

  PlacedGeometry read() {
    geometry(wanted_ == Wanted::sum);
    if (!tokens_.peek().is_end()) refuse_next("after the geometry", "the end of the input");
    return std::move(result_);
  }

 private:
  /// Reads one tagged geometry into the result.
  void geometry(bool may_be_collection) {
    const Token token = tokens_.take();
    const std::string keyword = upper(token.text);
    const bool is_multi = keyword.starts_with("MULTI");
    const std::string of_parts = keyword.substr(is_multi ? 5 : 0);
    const bool sum = wanted_ == Wanted::sum;
    void (WktReader::*part)() = nullptr;
    if (of_parts == "POLYGON") part = &WktReader::polygon;
    if (sum && of_parts == "LINESTRING") part = &WktReader::line_string;
    if (sum && of_parts == "POINT")
      part = is_multi ? &WktReader::point_with_or_without : &WktReader::parenthesized_point;
    if (part != nullptr) {
      if (!has_content(keyword)) return;
      if (!is_multi) return (this->*part)();
      list(keyword, [&] {
        if (!take_empty()) (this->*part)();
      });
    } else if (may_be_collection && keyword == "GEOMETRYCOLLECTION") {
      if (has_content(keyword)) list(keyword, [&] { geometry(false); });
    } else {
      input_.refuse(token.at, describe(token) + " where a geometry should be",
                    !sum                ? "POLYGON or MULTIPOLYGON"
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

  bool has_content(const std::string& keyword) {
    const std::string next = upper(tokens_.peek().text);
    if (next == "Z" || next == "M" || next == "ZM")
      refuse_next("after " + keyword, "coordinates in the plane, x and y only");
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
    remove_closing_vertex(input_, chain);
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
    add_vertex(result_.points,
               [&](char axis) { return std::string(1, axis) + " of point " + number; });
  }

  PlacedChain vertices_of(const std::string& name) {
    PlacedChain chain{.start = tokens_.peek().at};
    const std::string_view ring = tokens_.rest().substr(0, tokens_.rest().find(')'));
    const auto commas = static_cast<std::size_t>(std::count(ring.begin(), ring.end(), ','));
    chain.reserve(commas + 1, ring.size());
    list(name, [&] {
      add_vertex(chain,
                 [&](char axis) { return coordinate_name(axis, chain.vertices.size(), name); });
    });
    return chain;
  }

  template <typename Name>
  void add_vertex(PlacedChain& chain, Name name) {
    chain.places.push_back(tokens_.peek().at);
    Point& vertex = chain.vertices.emplace_back();
    put_coordinate(vertex.x, [&] { return name('x'); });
    put_coordinate(vertex.y, [&] { return name('y'); });
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
};

}  // namespace

PlacedGeometry parse_wkt(const InputText& input, Wanted wanted) {
  return WktReader(input, wanted).read();
}

}  // namespace oplus
