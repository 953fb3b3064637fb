// SPDX-License-Identifier: MIT
#include "reference/pictures/picture.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "reference/io/counted.hpp"
#include "reference/pictures/layer_drawing.hpp"
#include "reference/pictures/panel_frame.hpp"
#include "reference/pictures/svg_elements.hpp"

namespace oplus {

namespace {

using namespace picture;

constexpr double margin = 14;  // around a drawing and between panels
constexpr double title_size = 14;
constexpr double legend_size = 13;
constexpr double caption_size = 10;
constexpr double above = margin + title_size;    // a drawing, for its title
constexpr double below = margin + caption_size;  // a drawing, for its caption
constexpr double between = below + margin + above;

bool is_empty(const Layer& layer) {
  return layer.region.components.empty() && layer.segments.empty() && layer.points.empty() &&
         layer.notes.empty();
}

struct Drawing {
  std::string content;
  double height;
};

/// What the layers drawn have to say.
struct Legend {
  std::map<std::tuple<int, int, std::string>, Style> entries;  ///< by place, number, label
  std::size_t notes_left_out = 0;
};

constexpr std::size_t most_entries = 40;

/// The entries in rows no wider than the page.
Drawing drawn(const Legend& legend, double top, double page_width) {
  constexpr double row = 26;
  double x = margin;
  double y = top;
  std::string content = "<g class=\"legend\">\n";
  const auto place = [&](double width) {
    if (x > margin && x + width > page_width) {
      x = margin;
      y += row;
    }
    const Pixel at{x, y + row / 2};
    x += width;
    return at;
  };
  const auto write = [&](double left, double middle, const std::string& what) {
    content += text(left, middle + 4.5, legend_size, "start", "#1a1a1a", what);
  };
  std::size_t drawn = 0;
  for (const auto& [order, style] : legend.entries) {
    if (drawn++ == most_entries) break;
    const Pixel at = place(34 + text_width(style.label, legend_size) + 10);
    content += swatch(style, {at.x + 12, at.y});
    write(at.x + 30, at.y, style.label);
  }
  const auto remark = [&](const std::string& what) {
    const Pixel at = place(text_width(what, legend_size) + 10);
    write(at.x, at.y, what);
  };
  if (legend.entries.size() > most_entries)
    remark("and " + std::to_string(legend.entries.size() - most_entries) + " more");
  if (legend.notes_left_out > 0)
    remark("no room for " + counted(legend.notes_left_out, "number", "numbers"));
  return {content + "</g>\n", x == margin && y == top ? 0 : y + row - top};
}

std::string caption(const Panel& panel) {
  const std::optional<BoundingBox> box = bounding_box(panel);
  if (!box) return "empty";
  return "x " + approximate(box->low.x) + " \u2026 " + approximate(box->high.x) + ",  y " +
         approximate(box->low.y) + " \u2026 " + approximate(box->high.y);
}

/// The panel with the top of its drawing, its title and the line above its caption at given heights.
std::string drawn(const Panel& panel, double centre, double top, double title, double bottom,
                  Legend& legend) {
  const Frame frame(panel, centre - Frame(panel, 0, 0).width() / 2, top);
  std::string content = "<g class=\"panel\">\n";
  content += text(centre, title, title_size, "middle", "#1a1a1a", panel.title);
  for (const Layer& layer : panel.layers) {
    if (is_empty(layer)) continue;
    const Style& style = layer.style;
    legend.entries.try_emplace({style.place, style.number, style.label}, style);
    const DrawnLayer of_layer = drawn(layer, frame);
    legend.notes_left_out += of_layer.notes_left_out;
    content += of_layer.content;
  }
  content += text(centre, bottom + below, caption_size, "middle", "#6a6a6a", caption(panel));
  return content + "</g>\n";
}

/// The height of a column's drawings and of what is between them.
double height_of(const std::vector<Panel>& column) {
  double height = 0;
  for (const Panel& panel : column) height += Frame(panel, 0, 0).height();
  if (column.size() > 1) height += static_cast<double>(column.size() - 1) * between;
  return height;
}

double width_of(const std::vector<Panel>& column) {
  double width = 0;
  for (const Panel& panel : column)
    width = std::max({width, Frame(panel, 0, 0).width(), text_width(panel.title, title_size),
                      text_width(caption(panel), caption_size)});
  return width;
}

}  // namespace

Style labelled(Style style, std::string label) {
  style.label = std::move(label);
  return style;
}

// GMP's floats have room for every exponent.
std::string approximate(const Rational& value) {
  const mpf_class rounded(value);
  std::array<char, 64> digits{};
  gmp_snprintf(digits.data(), digits.size(), "%.5Fg", rounded.get_mpf_t());
  return digits.data();
}

std::string svg(const std::vector<Panel>& panels) {
  std::vector<std::vector<Panel>> columns;
  for (const Panel& panel : panels) columns.push_back({panel});
  return svg_in_columns(columns);
}

std::string svg_in_columns(const std::vector<std::vector<Panel>>& columns) {
  double height = 60;
  for (const std::vector<Panel>& column : columns) height = std::max(height, height_of(column));
  const double top = above + margin;

  std::string content;
  Legend legend;
  double x = margin;
  for (const std::vector<Panel>& column : columns) {
    const double width = width_of(column);
    const double centre = x + width / 2;
    if (column.size() == 1) {
      const double free = height - height_of(column);
      content += drawn(column[0], centre, top + free / 2, top - margin, top + height, legend);
    } else {
      double y = top;
      for (const Panel& panel : column) {
        const double bottom = y + Frame(panel, 0, 0).height();
        content += drawn(panel, centre, y, y - margin, bottom, legend);
        y = bottom + between;
      }
    }
    x += width + 2 * margin;
  }
  const double page_width = std::max(x - margin, 240.0);
  const double legend_top = top + height + below + caption_size;
  const Drawing key = drawn(legend, legend_top, page_width);
  const double page_height = legend_top + key.height + margin;
  return document(page_width, page_height,
                  "<defs><pattern id=\"holes\" width=\"5\" height=\"5\" "
                  "patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\">"
                  "<rect width=\"5\" height=\"5\" fill=\"#f8c9a8\"/>"
                  "<path d=\"M0,0V5\" stroke=\"#d55e00\" stroke-width=\"2.4\"/></pattern></defs>\n",
                  content + key.content);
}

}  // namespace oplus
