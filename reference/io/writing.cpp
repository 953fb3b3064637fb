// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/io/writing.hpp"

#include <algorithm>
#include <vector>

#include "reference/definitions/contract.hpp"

namespace oplus {

namespace {

/// Longer numbers are strings in GeoJSON: a reader that converts them would overflow.
constexpr std::size_t longest_json_number = 4000;

/// How often the factor divides the number; divides it out.
unsigned long take_out(mpz_class& number, unsigned long factor) {
  return mpz_remove(number.get_mpz_t(), number.get_mpz_t(), mpz_class(factor).get_mpz_t());
}

mpz_class power_of_ten(unsigned long exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, exponent);
  return power;
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

/// Writes the geometries of a format piece by piece.
class Writer {
 public:
  Writer(std::ostream& out, std::optional<int> digits) : out_(out), digits_(digits) {}

 protected:
  std::string number(const Rational& value) const { return to_string(value, digits_); }

  /// Writes the items with ", " between them.
  template <typename Items, typename Write>
  void list(const Items& items, Write write) const {
    bool is_first = true;
    for (const auto& item : items) {
      if (!is_first) out_ << ", ";
      is_first = false;
      write(item);
    }
  }

  std::ostream& out_;
  std::optional<int> digits_;
};

std::vector<Chain> chains_of(const Component& component) {
  std::vector<Chain> result{component.outer};
  result.insert(result.end(), component.holes.begin(), component.holes.end());
  return result;
}

Chain closed(Chain chain) {
  chain.push_back(chain.front());
  return chain;
}

Chain ends(const Segment& s) { return {s.source, s.target}; }

class DatWriter : private Writer {
 public:
  using Writer::Writer;

  void write(const Region& region) const {
    if (region.components.empty()) out_ << "0\n";
    const bool is_one = region.components.size() == 1;
    for (const Component& component : region.components) {
      write(component.outer);
      if (is_one && component.holes.empty()) return;
      out_ << component.holes.size() << '\n';
      for (const Chain& hole : component.holes) write(hole);
    }
  }

 private:
  void write(const Chain& chain) const {
    out_ << chain.size() << '\n';
    for (const Point& p : chain) out_ << number(p.x) << ' ' << number(p.y) << '\n';
  }
};

class WktWriter : private Writer {
 public:
  using Writer::Writer;

  void write(const Region& region) const {
    if (region.components.empty()) {
      out_ << "POLYGON EMPTY";
    } else if (region.components.size() == 1) {
      out_ << "POLYGON ";
      write(region.components.front());
    } else {
      out_ << "MULTIPOLYGON (";
      list(region.components, [&](const Component& c) { write(c); });
      out_ << ')';
    }
  }

  void write(const Region& region, const MinkowskiSum& features) const {
    out_ << "GEOMETRYCOLLECTION (";
    if (!region.components.empty()) {
      write(region);
      out_ << ", ";
    }
    list(features.dangling_edges, [&](const Segment& s) {
      out_ << "LINESTRING ";
      write(ends(s));
    });
    if (!features.dangling_edges.empty() && !features.isolated_vertices.empty()) out_ << ", ";
    list(features.isolated_vertices, [&](const Point& p) {
      out_ << "POINT ";
      write(Chain{p});
    });
    out_ << ')';
  }

 private:
  void write(const Component& component) const {
    out_ << '(';
    list(chains_of(component), [&](const Chain& chain) { write(closed(chain)); });
    out_ << ')';
  }

  void write(const Chain& vertices) const {
    out_ << '(';
    list(vertices, [&](const Point& p) { out_ << number(p.x) << ' ' << number(p.y); });
    out_ << ')';
  }
};

class GeoJsonWriter : private Writer {
 public:
  using Writer::Writer;

  void write(const Region& region) const {
    if (region.components.size() == 1) {
      out_ << R"({"type": "Polygon", "coordinates": )";
      write(region.components.front());
    } else {
      out_ << R"({"type": "MultiPolygon", "coordinates": [)";
      list(region.components, [&](const Component& c) { write(c); });
      out_ << ']';
    }
    out_ << '}';
  }

  void write(const Region& region, const MinkowskiSum& features) const {
    out_ << R"({"type": "GeometryCollection", "geometries": [)";
    if (!region.components.empty()) {
      write(region);
      out_ << ", ";
    }
    list(features.dangling_edges, [&](const Segment& s) {
      out_ << R"({"type": "LineString", "coordinates": )";
      write(ends(s));
      out_ << '}';
    });
    if (!features.dangling_edges.empty() && !features.isolated_vertices.empty()) out_ << ", ";
    list(features.isolated_vertices, [&](const Point& p) {
      out_ << R"({"type": "Point", "coordinates": )";
      write(p);
      out_ << '}';
    });
    out_ << "]}";
  }

 private:
  void write(const Component& component) const {
    out_ << '[';
    list(chains_of(component), [&](const Chain& chain) { write(closed(chain)); });
    out_ << ']';
  }

  void write(const Chain& vertices) const {
    out_ << '[';
    list(vertices, [&](const Point& p) { write(p); });
    out_ << ']';
  }

  void write(const Point& p) const {
    out_ << '[' << json_number(p.x) << ", " << json_number(p.y) << ']';
  }

  std::string json_number(const Rational& value) const {
    const std::string text = number(value);
    const bool is_number =
        text.find('/') == std::string::npos && text.size() <= longest_json_number;
    return is_number ? text : '"' + text + '"';
  }
};

}  // namespace

std::optional<Format> format_of(const std::string& path) {
  if (path.ends_with(".dat")) return Format::dat;
  if (path.ends_with(".wkt")) return Format::wkt;
  if (path.ends_with(".json") || path.ends_with(".geojson")) return Format::geojson;
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

void write(std::ostream& out, const Region& region, Format format, std::optional<int> digits) {
  switch (format) {
    case Format::dat:
      DatWriter(out, digits).write(region);
      return;
    case Format::wkt:
      WktWriter(out, digits).write(region);
      break;
    case Format::geojson:
      GeoJsonWriter(out, digits).write(region);
      break;
  }
  out << '\n';
}

void write(std::ostream& out, const MinkowskiSum& sum, Format format, std::optional<int> digits) {
  OPLUS_REQUIRES(can_hold(format, sum), "write");
  const Region region = region_of(sum);
  const bool is_region = sum.dangling_edges.empty() && sum.isolated_vertices.empty();
  if (is_region || format == Format::dat) return write(out, region, format, digits);
  if (format == Format::wkt)
    WktWriter(out, digits).write(region, sum);
  else
    GeoJsonWriter(out, digits).write(region, sum);
  out << '\n';
}

}  // namespace oplus
