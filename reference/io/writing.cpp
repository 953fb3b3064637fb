// SPDX-License-Identifier: MIT
#include "reference/io/writing.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <boost/algorithm/string/case_conv.hpp>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/chains/region_of.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/io/power_of_ten.hpp"

namespace oplus {

namespace {

/// Longer numbers are strings in GeoJSON: a reader that converts them would overflow.
constexpr std::size_t longest_json_number = 4000;

/// Without zeros at its end.
void add_decimal(std::string& text, bool is_negative, std::string_view digits,
                 std::size_t decimals) {
  if (is_negative && digits != "0") text += '-';
  const std::size_t whole = digits.size() > decimals ? digits.size() - decimals : 0;
  if (whole == 0)
    text += '0';
  else
    text += digits.substr(0, whole);
  const std::size_t last = digits.find_last_not_of('0');
  if (decimals == 0 || last == std::string_view::npos || last < whole) return;
  text += '.';
  if (!OPLUS_MUTANT("decimals-lose-their-zeros", "zeros after a decimal point are not written"))
    text.append(decimals - (digits.size() - whole), '0');
  text += digits.substr(whole, last + 1 - whole);
}

using Word = mp_limb_t;

void add_decimal(std::string& text, bool is_negative, Word digits, std::size_t decimals) {
  std::array<char, std::numeric_limits<Word>::digits10 + 1> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), digits);
  const std::string_view written(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  add_decimal(text, is_negative, written, decimals);
}

/// The size of a number that a word holds; none of a larger one.
std::optional<Word> word(const mpz_class& number) {
  const mpz_srcptr limbs = number.get_mpz_t();
  return mpz_size(limbs) <= 1 ? std::optional<Word>(mpz_getlimbn(limbs, 0)) : std::nullopt;
}

/// How often the factor divides the number; divides it out.
unsigned long take_out(mpz_class& number, unsigned long factor) {
  return mpz_remove(number.get_mpz_t(), number.get_mpz_t(), mpz_class(factor).get_mpz_t());
}

/// The same of a number that is not zero.
Word take_out(Word& number, Word factor) {
  Word count = 0;
  for (; number % factor == 0; ++count) number /= factor;
  return count;
}

/// Adds the exact number; returns whether words were large enough for it.
bool add_exact_word(std::string& text, const Rational& value) {
  const std::optional<Word> numerator = word(value.get_num());
  const std::optional<Word> denominator = word(value.get_den());
  if (!numerator || !denominator) return false;
  Word rest = *denominator;
  const Word twos = rest == 1 ? 0 : take_out(rest, 2), fives = rest == 1 ? 0 : take_out(rest, 5);
  if (rest != 1) {
    add_decimal(text, sgn(value) < 0, *numerator, 0);
    text += '/';
    add_decimal(text, false, *denominator, 0);
    return true;
  }
  Word scaled = *numerator;
  for (Word i = twos; i < fives; ++i)
    if (__builtin_mul_overflow(scaled, Word{2}, &scaled)) return false;
  for (Word i = fives; i < twos; ++i)
    if (__builtin_mul_overflow(scaled, Word{5}, &scaled)) return false;
  add_decimal(text, sgn(value) < 0, scaled, std::max(twos, fives));
  return true;
}

void add_exact(std::string& text, const Rational& value) {
  if (add_exact_word(text, value)) return;
  mpz_class rest = value.get_den();
  const unsigned long decimals = std::max(take_out(rest, 2), take_out(rest, 5));
  if (rest != 1) {
    text += value.get_str();
    return;
  }
  const mpz_class scaled = abs(value.get_num()) * power_of_ten(decimals) / value.get_den();
  add_decimal(text, sgn(value) < 0, scaled.get_str(), decimals);
}

/// Adds the rounded number; returns whether words were large enough for it.
bool add_rounded_word(std::string& text, const Rational& value, unsigned long digits) {
  const std::optional<Word> numerator = word(value.get_num());
  const std::optional<Word> denominator = word(value.get_den());
  Word twice = 0, divisor = 0;
  if (!numerator || !denominator || __builtin_mul_overflow(*numerator, Word{2}, &twice) ||
      __builtin_mul_overflow(*denominator, Word{2}, &divisor))
    return false;
  for (unsigned long i = 0; i < digits; ++i)
    if (__builtin_mul_overflow(twice, Word{10}, &twice)) return false;
  if (__builtin_add_overflow(twice, *denominator, &twice)) return false;
  add_decimal(text, sgn(value) < 0, twice / divisor, digits);
  return true;
}

void add_rounded(std::string& text, const Rational& value, unsigned long digits) {
  if (value.get_den() == 1) return add_exact(text, value);
  if (add_rounded_word(text, value, digits)) return;
  const mpz_class twice = 2 * abs(value.get_num()) * power_of_ten(digits);
  const mpz_class magnitude = (twice + value.get_den()) / (2 * value.get_den());
  add_decimal(text, sgn(value) < 0, magnitude.get_str(), digits);
}

void add(std::string& text, const Rational& value, std::optional<int> digits) {
  OPLUS_REQUIRES(!digits || (0 <= *digits && *digits <= most_digits), "to_string");
  if (digits)
    add_rounded(text, value, static_cast<unsigned long>(*digits));
  else
    add_exact(text, value);
}

void add(std::string& text, const Point& p, std::optional<int> digits) {
  add(text, p.x, digits);
  text += ' ';
  add(text, p.y, digits);
}

std::string dat(const Region& region, std::optional<int> digits) {
  if (region.components.empty()) return "0\n";
  std::string text;
  const auto add_chain = [&](const Chain& chain) {
    text += std::to_string(chain.size()) + '\n';
    for (const Point& p : chain) {
      add(text, p, digits);
      text += '\n';
    }
  };
  for (const Component& component : region.components) {
    add_chain(component.outer);
    if (region.components.size() == 1 && component.holes.empty() && !component.outer.empty()) break;
    text += std::to_string(component.holes.size()) + '\n';
    for (const Chain& hole : component.holes) add_chain(hole);
  }
  return text;
}

/// WKT and GeoJSON nest the same lists in different brackets.
class GeometryText {
 public:
  GeometryText(Format format, std::optional<int> digits)
      : is_json_(format == Format::geojson), digits_(digits) {}

  void add(const Region& region) {
    const auto add_component = [&](const Component& c) {
      std::vector<const Chain*> rings = {&c.outer};
      for (const Chain& hole : c.holes) rings.push_back(&hole);
      add_list(rings, [&](const Chain* ring) { add_vertices(*ring, true); });
    };
    if (region.components.size() == 1)
      add_tagged("Polygon", [&] { add_component(region.components.front()); });
    else if (region.components.empty() && !is_json_)
      text_ += "POLYGON EMPTY";
    else
      add_tagged("MultiPolygon", [&] { add_list(region.components, add_component); });
  }

  void add(const Region& region, const PlanarSet& features) {
    std::vector<std::function<void()>> geometries;
    if (!region.components.empty()) geometries.emplace_back([&] { add(region); });
    for (const Segment& s : features.dangling_edges)
      geometries.emplace_back([&] {
        add_tagged("LineString", [&] { add_vertices({s.source, s.target}, false); });
      });
    for (const Point& p : features.isolated_vertices)
      geometries.emplace_back([&] {
        add_tagged("Point", [&] { is_json_ ? add_vertex(p) : add_vertices({p}, false); });
      });
    add_tagged(
        "GeometryCollection",
        [&] { add_list(geometries, [](const auto& add_geometry) { add_geometry(); }); },
        "geometries");
  }

  /// Returns all that was added, as a line.
  std::string line() && { return std::move(text_ += '\n'); }

 private:
  template <typename Add>
  void add_tagged(const std::string& type, Add add_content,
                  const std::string& member = "coordinates") {
    if (is_json_) text_ += R"({"type": ")" + type + R"(", ")" + member + "\":";
    // Not by Boost, whose locales are large in WebAssembly.
    else
      for (const unsigned char c : type) text_ += static_cast<char>(std::toupper(c));
    text_ += ' ';
    add_content();
    if (is_json_) text_ += '}';
  }

  template <typename Items, typename Add>
  void add_list(const Items& items, Add add_item) {
    text_ += is_json_ ? '[' : '(';
    bool is_first = true;
    for (const auto& item : items) {
      if (!is_first) text_ += ", ";
      is_first = false;
      add_item(item);
    }
    text_ += is_json_ ? ']' : ')';
  }

  void add_vertices(const Chain& chain, bool is_closed) {
    text_ += is_json_ ? '[' : '(';
    for (std::size_t i = 0; i < chain.size(); ++i) {
      if (i > 0) text_ += ", ";
      add_vertex(chain[i]);
    }
    if (is_closed) {
      text_ += ", ";
      add_vertex(chain.front());
    }
    text_ += is_json_ ? ']' : ')';
  }

  void add_vertex(const Point& p) {
    if (!is_json_) return oplus::add(text_, p, digits_);
    text_ += '[';
    add_json_number(p.x);
    text_ += ", ";
    add_json_number(p.y);
    text_ += ']';
  }

  void add_json_number(const Rational& value) {
    const std::size_t start = text_.size();
    oplus::add(text_, value, digits_);
    const std::string_view added = std::string_view(text_).substr(start);
    if (added.size() <= longest_json_number && added.find('/') == std::string_view::npos) return;
    text_.insert(start, 1, '"');
    text_ += '"';
  }

  bool is_json_;
  std::optional<int> digits_;
  std::string text_;
};

/// Well-known binary, least significant byte first, as hexadecimal digits.
class WkbText {
 public:
  void add(const Region& region) {
    const auto add_component = [&](const Component& c) {
      add_tag(3);
      add_count(1 + c.holes.size());
      add_ring(c.outer);
      for (const Chain& hole : c.holes) add_ring(hole);
    };
    if (region.components.size() == 1) return add_component(region.components.front());
    if (region.components.empty()) {
      add_tag(3);
      return add_count(0);
    }
    add_tag(6);
    add_count(region.components.size());
    for (const Component& c : region.components) add_component(c);
  }

  void add(const Region& region, const PlanarSet& features) {
    add_tag(7);
    add_count((region.components.empty() ? 0 : 1) + features.dangling_edges.size() +
              features.isolated_vertices.size());
    if (!region.components.empty()) add(region);
    for (const Segment& s : features.dangling_edges) {
      add_tag(2);
      add_count(2);
      add(s.source);
      add(s.target);
    }
    for (const Point& p : features.isolated_vertices) {
      add_tag(1);
      add(p);
    }
  }

  /// Returns all that was added, as a line.
  std::string line() && { return std::move(text_ += '\n'); }

 private:
  void add_byte(unsigned byte) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    text_ += digits[byte >> 4U & 15U];
    text_ += digits[byte & 15U];
  }
  template <typename Word>
  void add_bytes(Word word) {
    for (std::size_t i = 0; i < sizeof word; ++i)
      add_byte(static_cast<unsigned>(word >> (8 * i) & 255U));
  }
  void add_tag(std::uint32_t type) {
    add_byte(1);
    add_bytes(type);
  }
  void add_count(std::size_t count) { add_bytes(static_cast<std::uint32_t>(count)); }
  void add(const Point& p) {
    for (const Rational* value : {&p.x, &p.y})
      add_bytes(std::bit_cast<std::uint64_t>(value->get_d()));
  }
  void add_ring(const Chain& ring) {
    add_count(ring.size() + 1);
    for (const Point& p : ring) add(p);
    add(ring.front());
  }

  std::string text_;
};

bool is_double(const Rational& value) {
  const double near = value.get_d();
  return std::isfinite(near) && Rational(near) == value;
}

std::string without_line_end(std::string text) {
  text.pop_back();
  return text;
}

}  // namespace

std::optional<Format> format_of(const std::string& path) {
  const std::string lower = boost::algorithm::to_lower_copy(path);
  if (lower.ends_with(".dat")) return Format::dat;
  if (lower.ends_with(".wkt")) return Format::wkt;
  if (lower.ends_with(".wkb")) return Format::wkb;
  if (lower.ends_with(".json") || lower.ends_with(".geojson")) return Format::geojson;
  return std::nullopt;
}

std::string to_string(const Rational& value, std::optional<int> digits) {
  std::string text;
  add(text, value, digits);
  return text;
}

std::string to_string(const Point& p) { return '(' + to_string(p.x) + ", " + to_string(p.y) + ')'; }

bool can_hold(Format format, const PlanarSet& sum) {
  return format == Format::dat ? sum.dangling_edges.empty() && sum.isolated_vertices.empty()
                               : !sum.is_unbounded;
}

std::optional<Rational> not_a_double(const Region& region, const PlanarSet& features) {
  std::optional<Rational> found;
  const auto look = [&](const Point& p) {
    if (!found && !is_double(p.x)) found = p.x;
    if (!found && !is_double(p.y)) found = p.y;
  };
  for (const Chain& chain : chains(region)) std::ranges::for_each(chain, look);
  for (const Segment& s : features.dangling_edges) {
    look(s.source);
    look(s.target);
  }
  std::ranges::for_each(features.isolated_vertices, look);
  return found;
}

std::string written(const Region& region, Format format, std::optional<int> digits) {
  if (format == Format::dat) return dat(region, digits);
  if (format == Format::wkb) {
    OPLUS_REQUIRES(!not_a_double(region, {}), "written");
    WkbText text;
    text.add(region);
    return std::move(text).line();
  }
  GeometryText text(format, digits);
  text.add(region);
  return std::move(text).line();
}

std::string written(const PlanarSet& sum, Format format, std::optional<int> digits) {
  return written(sum, region_of(sum), format, digits);
}

std::string written(const PlanarSet& sum, const Region& region, Format format,
                    std::optional<int> digits) {
  OPLUS_REQUIRES(can_hold(format, sum), "written");
  if (sum.dangling_edges.empty() && sum.isolated_vertices.empty())
    return written(region, format, digits);
  if (format == Format::wkb) {
    OPLUS_REQUIRES(!not_a_double(region, sum), "written");
    WkbText text;
    text.add(region, sum);
    return std::move(text).line();
  }
  GeometryText text(format, digits);
  text.add(region, sum);
  return std::move(text).line();
}

std::string wkt(const Region& region) { return without_line_end(written(region, Format::wkt)); }
std::string wkt(const PlanarSet& sum) { return without_line_end(written(sum, Format::wkt)); }

}  // namespace oplus
