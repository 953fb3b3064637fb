// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>

#include "reference/definitions/mutant.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/placed_geometry.hpp"
#include "reference/io/quoting.hpp"

namespace oplus {

namespace {

constexpr std::size_t shortest = 9;  // a geometry without parts: order, type, count

bool is_hexadecimal(char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; }

std::string_view first_word(std::string_view text) {
  const std::size_t start = std::min(text.find_first_not_of(blanks), text.size());
  text.remove_prefix(start);
  return text.substr(0, text.find_first_of(blanks));
}

bool starts_in_hexadecimal(std::string_view text) {
  const std::string_view word = first_word(text);
  return word.size() >= 2 * shortest && (word.starts_with("00") || word.starts_with("01")) &&
         std::all_of(word.begin(), word.begin() + 2 * shortest, is_hexadecimal);
}

unsigned digit(char c) {
  return static_cast<unsigned>(c <= '9' ? c - '0'
                                        : std::tolower(static_cast<unsigned char>(c)) - 'a' + 10);
}

class WkbReader {
 public:
  WkbReader(const InputText& input, Wanted wanted) : input_(input), wanted_(wanted) {}

  PlacedGeometry read() {
    if (starts_in_hexadecimal(input_.text)) {
      words();
    } else {
      bytes_ = input_.text;
      whole_geometry();
    }
    return std::move(result_);
  }

 private:
  enum Type : std::uint32_t {
    point_type = 1,
    line_type,
    polygon_type,
    points_type,
    lines_type,
    polygons_type,
    collection_type
  };
  using Types = std::vector<std::uint32_t>;
  inline static const Types polygons = {polygon_type, polygons_type};
  inline static const Types parts = {point_type,  line_type,  polygon_type,
                                     points_type, lines_type, polygons_type};
  inline static const Types any = {point_type, line_type,     polygon_type,   points_type,
                                   lines_type, polygons_type, collection_type};

  /// Reads geometries in hexadecimal digits, one a line.
  void words() {
    is_hexadecimal_ = true;
    Tokenizer tokens(input_, "");
    while (!tokens.peek().is_end()) {
      if (!tokens.is_first_of_line())
        input_.refuse(tokens.peek().at, "more than one word in a line of WKB",
                      "hexadecimal digits only");
      const Token word = tokens.take();
      start_ = word.at;
      decode(word.text);
      bytes_ = decoded_;
      whole_geometry();
    }
  }

  void decode(std::string_view word) {
    const auto other = std::find_if_not(word.begin(), word.end(), oplus::is_hexadecimal);
    if (other != word.end())
      refuse_at(static_cast<std::size_t>(other - word.begin()), quote({&*other, 1}) + " in WKB",
                "hexadecimal digits");
    if (word.size() % 2 != 0)
      refuse_at(word.size(), "half a byte at the end", "two digits for each byte");
    decoded_.clear();
    for (std::size_t i = 0; i < word.size(); i += 2)
      decoded_ += static_cast<char>(digit(word[i]) << 4U | digit(word[i + 1]));
  }

  void whole_geometry() {
    at_ = 0;
    geometry(wanted_ == Wanted::sum ? any : polygons);
    if (at_ != bytes_.size())
      refuse_byte(at_, counted(bytes_.size() - at_, "byte", "bytes") + " after the geometry",
                  "the end of the input");
  }

  /// Takes the signs of Z and M from a type. EWKB has bits for them, ISO thousands.
  void take_dimension(std::uint32_t& type) {
    constexpr std::uint32_t has_z = 0x80000000, has_m = 0x40000000;
    const std::uint32_t thousands = (type & 0xFFFF) / 1000;
    left_out_ = ((type & has_z) != 0 ? 1U : 0U) + ((type & has_m) != 0 ? 1U : 0U);
    type &= ~(has_z | has_m);
    if (thousands < 1 || thousands > 3) return;
    left_out_ = thousands == 3 ? 2 : 1;
    type -= thousands * 1000;
  }

  /// Reads a geometry of one of these types.
  void geometry(const Types& types) {
    const std::size_t start = at_;
    const auto order = static_cast<unsigned char>(take(1)[0]);
    if (order > 1) refuse_byte(start, "the byte order " + std::to_string(order), "0 or 1");
    if (start == 0 || !OPLUS_MUTANT("parts-have-the-first-byte-order",
                                    "all parts of WKB are read in the byte order of the whole"))
      is_little_ = order == 1;
    const std::size_t of_type = at_;
    auto type = number<std::uint32_t>();
    constexpr std::uint32_t has_srid = 0x20000000;
    take_dimension(type);
    if ((type & has_srid) != 0) {
      type &= ~has_srid;
      take(4);
    }
    if (std::find(types.begin(), types.end(), type) == types.end())
      refuse_byte(of_type, "the geometry type " + std::to_string(type),
                  types.size() == polygons.size() ? "a polygon, 3, or polygons, 6"
                  : types.size() == 1             ? "the type " + std::to_string(types[0])
                                      : "a type from 1 to 7, not a collection in a collection");
    switch (type) {
      case point_type:
        return add_vertex(result_.points, "point");
      case line_type:
        return line_string();
      case polygon_type:
        return polygon();
      default:
        break;
    }
    for (auto count = number<std::uint32_t>(); count > 0; --count)
      geometry(type == collection_type ? parts : Types{type - 3});
  }

  void line_string() {
    result_.line_strings.push_back(
        vertices_of("line string " + std::to_string(result_.line_strings.size() + 1)));
  }

  void polygon() {
    const auto rings = number<std::uint32_t>();
    ChainName name{result_.next_component(), 0};
    for (; name.hole < rings; ++name.hole) {
      PlacedChain chain = vertices_of(describe(name));
      chain.name = name;
      if (chain.vertices.empty()) refuse_too_few_vertices(input_, chain.start, name, 0);
      remove_closing_vertex(chain);
      result_.chains.push_back(std::move(chain));
    }
  }

  PlacedChain vertices_of(const std::string& name) {
    PlacedChain chain{.start = position(at_)};
    const auto count = number<std::uint32_t>();
    if (count > (bytes_.size() - at_) / (8 * (2 + left_out_)))
      refuse_byte(at_ - 4, name + " of " + counted(count, "vertex", "vertices"),
                  "no more than follow");
    chain.vertices.reserve(count);
    chain.places.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) add_vertex(chain, name);
    return chain;
  }

  void add_vertex(PlacedChain& chain, const std::string& name) {
    chain.places.push_back(position(at_));
    Point& vertex = chain.vertices.emplace_back();
    vertex.x = coordinate(name);
    vertex.y = coordinate(name);
    take(8 * left_out_);
    if (left_out_ > 0) ++result_.beyond_the_plane;
  }

  Rational coordinate(const std::string& name) {
    const std::size_t start = at_;
    const double value = std::bit_cast<double>(number<std::uint64_t>());
    if (!std::isfinite(value))
      refuse_byte(start, "a coordinate of " + name + " is not finite", "a finite number");
    input_.passed(start, at_);
    return Rational(value);
  }

  template <typename Word>
  Word number() {
    const std::string_view bytes = take(sizeof(Word));
    Word result = 0;
    for (std::size_t i = 0; i < sizeof(Word); ++i)
      result = static_cast<Word>(
          result << 8U | static_cast<unsigned char>(bytes[is_little_ ? sizeof(Word) - 1 - i : i]));
    return result;
  }

  std::string_view take(std::size_t count) {
    if (bytes_.size() - at_ < count)
      refuse_byte(bytes_.size(), "the end of the input inside a geometry", "more bytes");
    at_ += count;
    return bytes_.substr(at_ - count, count);
  }

  Position position(std::size_t byte) const {
    return {start_.line, start_.column + (is_hexadecimal_ ? 2 * byte : byte)};
  }
  [[noreturn]] void refuse_byte(std::size_t byte, const std::string& wrong,
                                const std::string& expected) const {
    input_.refuse(position(byte), wrong, expected);
  }
  [[noreturn]] void refuse_at(std::size_t character, const std::string& wrong,
                              const std::string& expected) const {
    input_.refuse({start_.line, start_.column + character}, wrong, expected);
  }

  const InputText& input_;
  Wanted wanted_;
  std::string decoded_;
  std::string_view bytes_;  ///< of the geometry that is read
  Position start_;          ///< where they start
  std::size_t at_ = 0;
  std::size_t left_out_ = 0;  ///< coordinates of each vertex besides x and y
  bool is_hexadecimal_ = false;
  bool is_little_ = true;
  PlacedGeometry result_;
};

}  // namespace

bool starts_as_wkb(std::string_view text) {
  if (starts_in_hexadecimal(text)) return true;
  if (text.size() < shortest || (text[0] != 0 && text[0] != 1)) return false;
  // The type is a small number, with flags in its most significant byte.
  const std::string_view type = text.substr(1, 4);
  const char least = text[0] == 1 ? type[0] : type[3];
  return type[text[0] == 1 ? 2 : 1] == 0 && least != 0;
}

PlacedGeometry parse_wkb(const InputText& input, Wanted wanted) {
  return WkbReader(input, wanted).read();
}

}  // namespace oplus
