// SPDX-License-Identifier: MIT
#include "reference/io/writing.hpp"

#include <algorithm>
#include <boost/algorithm/string/case_conv.hpp>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "reference/chains/region_of.hpp"
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

  void add(const Region& region, const MinkowskiSum& features) {
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
    text_ += is_json_ ? R"({"type": ")" + type + R"(", ")" + member + "\": "
                      : boost::algorithm::to_upper_copy(type) + ' ';
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
    std::vector<const Point*> vertices;
    for (const Point& p : chain) vertices.push_back(&p);
    if (is_closed) vertices.push_back(&chain.front());
    add_list(vertices, [&](const Point* p) { add_vertex(*p); });
  }

  void add_vertex(const Point& p) {
    if (is_json_)
      text_ += '[' + json_number(p.x) + ", " + json_number(p.y) + ']';
    else
      text_ += to_string(p.x, digits_) + ' ' + to_string(p.y, digits_);
  }

  std::string json_number(const Rational& value) const {
    const std::string text = to_string(value, digits_);
    const bool is_number =
        text.find('/') == std::string::npos && text.size() <= longest_json_number;
    return is_number ? text : '"' + text + '"';
  }

  bool is_json_;
  std::optional<int> digits_;
  std::string text_;
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
  GeometryText text(format, digits);
  text.add(region);
  return std::move(text).line();
}

std::string written(const MinkowskiSum& sum, Format format, std::optional<int> digits) {
  OPLUS_REQUIRES(can_hold(format, sum), "written");
  const Region region = region_of(sum);
  if (sum.dangling_edges.empty() && sum.isolated_vertices.empty())
    return written(region, format, digits);
  GeometryText text(format, digits);
  text.add(region, sum);
  return std::move(text).line();
}

std::string wkt(const Region& region) { return without_line_end(written(region, Format::wkt)); }
std::string wkt(const MinkowskiSum& sum) { return without_line_end(written(sum, Format::wkt)); }

}  // namespace oplus
