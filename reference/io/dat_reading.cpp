// SPDX-License-Identifier: MIT
#include <charconv>
#include <cstddef>
#include <limits>
#include <string>

#include "reference/io/placed_geometry.hpp"
#include "reference/io/quoting.hpp"

namespace oplus {

namespace {

bool is_count(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// The value of a count, or the largest one: as much input cannot follow.
std::size_t count_value(std::string_view digits) {
  std::size_t value = std::numeric_limits<std::size_t>::max();
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

class DatReader {
 public:
  explicit DatReader(const InputText& input) : input_(input), tokens_(input, "") {}

  PlacedGeometry read() {
    PlacedGeometry geometry;
    do {
      read_component(geometry);
    } while (!tokens_.peek().is_end());
    const bool is_empty_region =
        geometry.chains.size() == 1 && geometry.chains[0].vertices.empty() && !has_hole_count_;
    if (is_empty_region) geometry.chains.clear();
    return geometry;
  }

 private:
  void read_component(PlacedGeometry& geometry) {
    const std::size_t number = geometry.next_component();
    geometry.chains.push_back(chain({number, 0}));
    const bool is_whole_input = number == 1 && tokens_.peek().is_end();
    if (is_whole_input) return;
    const std::string holes = "the number of holes of component " + std::to_string(number);
    const Token token = tokens_.peek();
    const std::size_t count = take_count(holes, number == 1 ? " or the end of the input" : "");
    has_hole_count_ = true;
    for (std::size_t hole = 1; hole <= count; ++hole) {
      if (tokens_.peek().is_end())
        input_.refuse(tokens_.peek().at,
                      "the end of the input after " + std::to_string(hole - 1) + " of " +
                          quote(token.text) + " holes of component " + std::to_string(number),
                      "the number of vertices of " + describe(ChainName{number, hole}));
      geometry.chains.push_back(chain({number, hole}));
    }
  }

  PlacedChain chain(const ChainName& name) {
    const Token token = tokens_.peek();
    PlacedChain result{.name = name, .start = token.at};
    const std::size_t count = take_count("the number of vertices of " + describe(name), "");
    if (count < 3 && (count > 0 || name.hole > 0))
      refuse_too_few_vertices(input_, token.at, name, count);
    if (count == 0) result.places.push_back(token.at);  // of defects of the component
    result.reserve(count, tokens_.rest().size());
    while (result.vertices.size() < count) {
      result.places.push_back(tokens_.peek().at);
      Point& vertex = result.vertices.emplace_back();
      put_coordinate(vertex.x, 'x', result, token, name);
      put_coordinate(vertex.y, 'y', result, token, name);
    }
    return result;
  }

  std::size_t take_count(const std::string& of_what, const std::string& or_else) {
    const Token token = tokens_.take();
    if (!is_count(token.text))
      input_.refuse(token.at, describe(token) + " where " + of_what + " should be",
                    "an integer without a sign" + or_else);
    return count_value(token.text);
  }

  /// The next token, a coordinate of the last vertex so far.
  void put_coordinate(Rational& value, char axis, const PlacedChain& so_far, const Token& count,
                      const ChainName& name) {
    const Token token = tokens_.take();
    const auto coordinate_called = [&] {
      return coordinate_name(axis, so_far.vertices.size(), describe(name));
    };
    if (token.is_end())
      input_.refuse(token.at,
                    "the end of the input after " + std::to_string(so_far.vertices.size() - 1) +
                        " of " + quote(count.text) + " vertices of " + describe(name),
                    coordinate_called());
    oplus::put_coordinate(input_, token.text, token.at, value, coordinate_called);
  }

  const InputText& input_;
  Tokenizer tokens_;
  bool has_hole_count_ = false;
};

}  // namespace

PlacedGeometry parse_dat(const InputText& input) { return DatReader(input).read(); }

}  // namespace oplus
