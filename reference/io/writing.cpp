// SPDX-License-Identifier: MIT
#include "reference/io/writing.hpp"

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <cctype>
#include <string>
#include <vector>

#include "reference/definitions/contract.hpp"
#include "reference/io/power_of_ten.hpp"

namespace oplus {

namespace {

/// Longer numbers are strings in GeoJSON: a reader that converts them would overflow.
constexpr std::size_t longest_json_number = 4000;

/// How often the factor divides the number; divides it out.
unsigned long take_out(mpz_class& number, unsigned long factor) {
  return mpz_remove(number.get_mpz_t(), number.get_mpz_t(), mpz_class(factor).get_mpz_t());
}

/// The decimal that is `scaled` divided by 10^decimals, without zeros at its end.
std::string decimal(const mpz_class& scaled, unsigned long decimals) {
  std::string digits = mpz_class(abs(scaled)).get_str();
  if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
  std::string text = digits.substr(0, digits.size() - decimals);
  std::string fraction = digits.substr(digits.size() - decimals);
  fraction.erase(fraction.find_last_not_of('0') + 1);
  if (!fraction.empty()) text += '.' + fraction;
  return sgn(scaled) < 0 ? '-' + text : text;
}

std::string exact(const Rational& value) {
  mpz_class rest = value.get_den();
  const unsigned long decimals = std::max(take_out(rest, 2), take_out(rest, 5));
  if (rest != 1) return value.get_str();
  return decimal(value.get_num() * power_of_ten(decimals) / value.get_den(), decimals);
}

std::string rounded(const Rational& value, unsigned long digits) {
  const mpz_class twice = 2 * abs(value.get_num()) * power_of_ten(digits);
  const mpz_class magnitude = (twice + value.get_den()) / (2 * value.get_den());
  return decimal(sign(value) < 0 ? mpz_class(-magnitude) : magnitude, digits);
}

Chain closed(Chain chain) {
  chain.push_back(chain.front());
  return chain;
}

std::string dat(const Region& region, std::optional<int> digits) {
  if (region.components.empty()) return "0\n";
  std::string text;
  const auto add = [&](const Chain& chain) {
    text += std::to_string(chain.size()) + '\n';
    for (const Point& p : chain)
      text += to_string(p.x, digits) + ' ' + to_string(p.y, digits) + '\n';
  };
  for (const Component& component : region.components) {
    add(component.outer);
    if (region.components.size() == 1 && component.holes.empty()) break;
    text += std::to_string(component.holes.size()) + '\n';
    for (const Chain& hole : component.holes) add(hole);
  }
  return text;
}

/// WKT and GeoJSON nest the same lists in different brackets.
class GeometryText {
 public:
  GeometryText(Format format, std::optional<int> digits)
      : is_json_(format == Format::geojson), digits_(digits) {}

  std::string of(const Region& region) const {
    const auto in_brackets = [&](const Component& c) {
      return list(chains({{c}}), [&](const Chain& chain) { return vertices(closed(chain)); });
    };
    if (region.components.size() == 1)
      return tagged("Polygon", in_brackets(region.components.front()));
    if (region.components.empty() && !is_json_) return "POLYGON EMPTY";
    return tagged("MultiPolygon", list(region.components, in_brackets));
  }

  std::string of(const Region& region, const MinkowskiSum& features) const {
    std::vector<std::string> geometries;
    if (!region.components.empty()) geometries.push_back(of(region));
    for (const Segment& s : features.dangling_edges)
      geometries.push_back(tagged("LineString", vertices({s.source, s.target})));
    for (const Point& p : features.isolated_vertices)
      geometries.push_back(tagged("Point", is_json_ ? vertex(p) : vertices({p})));
    return tagged("GeometryCollection",
                  list(geometries, [](const std::string& geometry) { return geometry; }),
                  "geometries");
  }

 private:
  std::string tagged(std::string type, const std::string& content,
                     const std::string& member = "coordinates") const {
    if (is_json_) return R"({"type": ")" + type + R"(", ")" + member + "\": " + content + '}';
    for (char& c : type) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return type + ' ' + content;
  }

  template <typename Items, typename Text>
  std::string list(const Items& items, Text text) const {
    std::string result(1, is_json_ ? '[' : '(');
    for (const auto& item : items) {
      if (result.size() > 1) result += ", ";
      result += text(item);
    }
    return result + (is_json_ ? ']' : ')');
  }

  std::string vertices(const Chain& chain) const {
    return list(chain, [&](const Point& p) { return vertex(p); });
  }

  std::string vertex(const Point& p) const {
    if (is_json_) return '[' + json_number(p.x) + ", " + json_number(p.y) + ']';
    return to_string(p.x, digits_) + ' ' + to_string(p.y, digits_);
  }

  std::string json_number(const Rational& value) const {
    const std::string text = to_string(value, digits_);
    const bool is_number =
        text.find('/') == std::string::npos && text.size() <= longest_json_number;
    return is_number ? text : '"' + text + '"';
  }

  bool is_json_;
  std::optional<int> digits_;
};

std::string without_line_end(std::string text) {
  text.pop_back();
  return text;
}

}  // namespace

std::optional<Format> format_of(const std::string& path) {
  const std::string lower = boost::algorithm::to_lower_copy(path);
  if (lower.ends_with(".dat")) return Format::dat;
  if (lower.ends_with(".wkt")) return Format::wkt;
  if (lower.ends_with(".json") || lower.ends_with(".geojson")) return Format::geojson;
  return std::nullopt;
}

std::string to_string(const Rational& value, std::optional<int> digits) {
  OPLUS_REQUIRES(!digits || (0 <= *digits && *digits <= most_digits), "to_string");
  return digits ? rounded(value, static_cast<unsigned long>(*digits)) : exact(value);
}

std::string to_string(const Point& p) { return '(' + to_string(p.x) + ", " + to_string(p.y) + ')'; }

bool can_hold(Format format, const MinkowskiSum& sum) {
  return format != Format::dat || (sum.dangling_edges.empty() && sum.isolated_vertices.empty());
}

std::string written(const Region& region, Format format, std::optional<int> digits) {
  if (format == Format::dat) return dat(region, digits);
  return GeometryText(format, digits).of(region) + '\n';
}

std::string written(const MinkowskiSum& sum, Format format, std::optional<int> digits) {
  OPLUS_REQUIRES(can_hold(format, sum), "written");
  const Region region = region_of(sum);
  if (sum.dangling_edges.empty() && sum.isolated_vertices.empty())
    return written(region, format, digits);
  return GeometryText(format, digits).of(region, sum) + '\n';
}

std::string wkt(const Region& region) { return without_line_end(written(region, Format::wkt)); }
std::string wkt(const MinkowskiSum& sum) { return without_line_end(written(sum, Format::wkt)); }

}  // namespace oplus
