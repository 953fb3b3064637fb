// SPDX-License-Identifier: MIT
#include "reference/pictures/stacked_pictures.hpp"

#include <algorithm>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "reference/pictures/svg_elements.hpp"

namespace oplus {

namespace {

using namespace picture;

constexpr std::string_view start = "<svg";

/// The number that the svg tag has as an attribute.
double size(const std::string& svg, const std::string& name) {
  const std::string tag = svg.substr(0, svg.find('>'));
  const std::string assigned = " " + name + "=\"";
  const std::size_t at = tag.find(assigned);
  std::istringstream digits(at == std::string::npos ? "" : tag.substr(at + assigned.size()));
  digits.imbue(std::locale::classic());
  double value = 0;
  if (!tag.starts_with(start) || !(digits >> value))
    throw std::invalid_argument("a picture without its " + name);
  return value;
}

}  // namespace

std::string stacked(const std::vector<TitledPicture>& pictures) {
  constexpr double margin = 16;
  constexpr double title_size = 15;
  double width = 240;
  double y = 0;
  std::string content;
  for (const auto& [title, svg] : pictures) {
    width = std::max({width, size(svg, "width"), 2 * margin + text_width(title, title_size)});
    const double height = size(svg, "height");
    y += margin + title_size;
    content += text(margin, y, title_size, "start", "#1a1a1a", title);
    content += std::string(start) + attributes({{"y", number(y)}}) + svg.substr(start.size());
    y += height;
  }
  return document(width, y + margin, "", content);
}

}  // namespace oplus
