// SPDX-License-Identifier: MIT
#include "reference/pictures/svg_elements.hpp"

#include <algorithm>
#include <array>
#include <boost/locale/utf.hpp>
#include <charconv>
#include <cmath>

namespace oplus::picture {

double distance(const Pixel& a, const Pixel& b) { return std::hypot(b.x - a.x, b.y - a.y); }

std::string number(double pixels) {
  std::array<char, 64> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), pixels,
                                 std::chars_format::fixed, 2)
                       .ptr;
  return {digits.data(), end};
}

std::string attributes(
    std::initializer_list<std::pair<std::string_view, std::string>> names_and_values) {
  std::string result;
  for (const auto& [name, value] : names_and_values)
    result.append(" ").append(name).append("=\"").append(value).append("\"");
  return result;
}

std::string escaped(const std::string& text) {
  using Utf8 = boost::locale::utf::utf_traits<char>;
  std::string result;
  for (auto at = text.begin(); at != text.end();) {
    const auto start = at;
    const auto code = Utf8::decode(at, text.end());
    if (code == boost::locale::utf::illegal || code == boost::locale::utf::incomplete) {
      at = start + 1;
      result += '?';
    } else if (code == '<') {
      result += "&lt;";
    } else if (code == '>') {
      result += "&gt;";
    } else if (code == '&') {
      result += "&amp;";
    } else if (code < 0x20 || code == 0x7f || code == 0xfffe || code == 0xffff) {
      result += '?';
    } else {
      result.append(start, at);
    }
  }
  return result;
}

double text_width(const std::string& text, double size) {
  return 0.6 * size * static_cast<double>(text.size());
}

std::string text(double x, double y, double size, const std::string& anchor,
                 const std::string& colour, const std::string& content) {
  return "<text" +
         attributes({{"x", number(x)},
                     {"y", number(y)},
                     {"font-size", number(size)},
                     {"text-anchor", anchor},
                     {"fill", colour}}) +
         ">" + escaped(content) + "</text>\n";
}

std::string step(char command, const Pixel& p) {
  return std::string(1, command).append(number(p.x)).append(",").append(number(p.y));
}

std::string path(const std::string& data, const std::string& more) {
  return "<path d=\"" + data + "\"" + more + "/>\n";
}

std::string circle(const Pixel& centre, double radius, const std::string& more) {
  return "<circle" +
         attributes({{"cx", number(centre.x)}, {"cy", number(centre.y)}, {"r", number(radius)}}) +
         more + "/>\n";
}

std::string document(double width, double height, const std::string& definitions,
                     const std::string& content) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\"" +
         attributes({{"viewBox", "0 0 " + number(width) + " " + number(height)},
                     {"width", number(width)},
                     {"height", number(height)},
                     {"font-family", "DejaVu Sans, Helvetica, Arial, sans-serif"}}) +
         ">\n" + definitions + "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" +
         content + "</svg>\n";
}

std::string arrow_head(const Pixel& source, const Pixel& target, double largest) {
  const double length = distance(source, target);
  if (length < 5) return "";
  const double size = std::min(largest, 0.3 * length);
  const Pixel along{(target.x - source.x) / length * size, (target.y - source.y) / length * size};
  const Pixel middle{(source.x + target.x) / 2, (source.y + target.y) / 2};
  const Pixel tip{middle.x + along.x, middle.y + along.y};
  const Pixel left{middle.x - along.x - 0.7 * along.y, middle.y - along.y + 0.7 * along.x};
  const Pixel right{middle.x - along.x + 0.7 * along.y, middle.y - along.y - 0.7 * along.x};
  return step('M', tip) + step('L', left) + step('L', right) + "Z";
}

}  // namespace oplus::picture
