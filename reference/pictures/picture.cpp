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
#include "reference/pictures/styles.hpp"
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

/// The labels of the layers drawn.
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

/// A panel with its scale and caption.
struct Scaled {
  const Panel& panel;
  Scale scale;
  std::string caption;

  Frame frame(double left, double top) const { return {panel, scale, left, top}; }
  double width() const { return frame(0, 0).width(); }
  double height() const { return frame(0, 0).height(); }
};

using Column = std::vector<Scaled>;

std::string caption(const Panel& panel) {
  const std::optional<BoundingBox> box = bounding_box(panel);
  if (!box) return "empty";
  return "x " + approximate(box->low.x) + " \u2026 " + approximate(box->high.x) + ",  y " +
         approximate(box->low.y) + " \u2026 " + approximate(box->high.y);
}

/// In the scale of the picture, unless it would be too small to see.
Scaled scaled(const Panel& panel, const Scale& scale) {
  constexpr double smallest_side = 16;
  const Rational size = extent(panel);
  if (size == 0 || scale(size) >= smallest_side) return {panel, scale, caption(panel)};
  const Rational times = Rational(smallest_side / scale.pixels) * scale.length / size;
  return {panel,
          {smallest_side, size},
          caption(panel) + ",  enlarged " + approximate(times) + "\u00d7"};
}

std::vector<Column> in_one_scale(const std::vector<std::vector<Panel>>& columns,
                                 double longest_side) {
  Rational largest = 0;
  for (const std::vector<Panel>& column : columns)
    for (const Panel& panel : column) largest = std::max(largest, extent(panel));
  const Scale scale{longest_side, largest == 0 ? Rational(1) : largest};
  std::vector<Column> result;
  for (const std::vector<Panel>& column : columns) {
    result.emplace_back();
    for (const Panel& panel : column) result.back().push_back(scaled(panel, scale));
  }
  return result;
}

/// The panel with the top of its drawing, its title and the line above its caption at given heights.
std::string drawn(const Scaled& scaled, double centre, double top, double title, double bottom,
                  Legend& legend) {
  const Panel& panel = scaled.panel;
  const Frame frame = scaled.frame(centre - scaled.width() / 2, top);
  std::string content = "<g class=\"panel\">\n";
  content += text(centre, title, title_size, "middle", "#1a1a1a", panel.title);
  const auto draw = [&](const Layer& layer) {
    if (is_empty(layer)) return;
    const Style& style = layer.style;
    legend.entries.try_emplace({style.place, style.number, style.label}, style);
    const DrawnLayer of_layer = drawn(layer, frame);
    legend.notes_left_out += of_layer.notes_left_out;
    content += of_layer.content;
  };
  for (const Layer& layer : panel.layers) draw(layer);
  constexpr double near = 10;
  if (bounding_box(panel) && frame.has_near({0, 0}, near)) draw({style::origin, {}, {}, {{0, 0}}});
  content += text(centre, bottom + below, caption_size, "middle", "#6a6a6a", scaled.caption);
  return content + "</g>\n";
}

/// The height of a column's drawings and of what is between them.
double height_of(const Column& column) {
  double height = 0;
  for (const Scaled& panel : column) height += panel.height();
  if (column.size() > 1) height += static_cast<double>(column.size() - 1) * between;
  return height;
}

double width_of(const Column& column) {
  double width = 0;
  for (const Scaled& scaled : column)
    width = std::max({width, scaled.width(), text_width(scaled.panel.title, title_size),
                      text_width(scaled.caption, caption_size)});
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

std::string svg(const std::vector<Panel>& panels, double longest_side) {
  std::vector<std::vector<Panel>> columns;
  for (const Panel& panel : panels) columns.push_back({panel});
  return svg_in_columns(columns, longest_side);
}

std::string svg_in_columns(const std::vector<std::vector<Panel>>& panels, double longest_side) {
  const std::vector<Column> columns = in_one_scale(panels, longest_side);
  double height = 60;
  for (const Column& column : columns) height = std::max(height, height_of(column));
  const double top = above + margin;

  std::string content;
  Legend legend;
  double x = margin;
  for (const Column& column : columns) {
    const double width = width_of(column);
    const double centre = x + width / 2;
    if (column.size() == 1) {
      const double free = height - height_of(column);
      content += drawn(column[0], centre, top + free / 2, top - margin, top + height, legend);
    } else {
      double y = top;
      for (const Scaled& panel : column) {
        const double bottom = y + panel.height();
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
