// SPDX-License-Identifier: MIT
#include "checked/cycles/fiber_grid_picture.hpp"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/io/counted.hpp"
#include "reference/pictures/styles.hpp"

namespace oplus {

namespace {

constexpr int margin = 16;
constexpr int title_size = 15;
constexpr int label_size = 12;
constexpr int axis = 52;  // room for an axis and its name
constexpr int legend_row = 22;
constexpr int legend_width = 250;
constexpr std::size_t most_legend_rows = 16;
/// Above, the states that no cycle passes are left out.
constexpr std::size_t most_drawn_states = 10000;
constexpr std::string_view ink = "#1a1a1a";
constexpr std::string_view pale = "#b4b4b4";

std::string stroke_of(std::size_t cycle) {
  const Style style = style::cycle(static_cast<int>(cycle));
  return " stroke=\"" + style.line + "\" fill=\"" + style.line + "\"" +
         (style.dash.empty() ? "" : " stroke-dasharray=\"" + style.dash + "\"");
}

std::string attribute(std::string_view name, int value) {
  return " " + std::string(name) + "=\"" + std::to_string(value) + "\"";
}

std::string text(int x, int y, int size, std::string_view anchor, std::string_view colour,
                 const std::string& content, const std::string& more = "") {
  return "<text" + attribute("x", x) + attribute("y", y) + attribute("font-size", size) +
         " text-anchor=\"" + std::string(anchor) + "\" fill=\"" + std::string(colour) + "\"" +
         more + ">" + content + "</text>\n";
}

struct Pixel {
  int x;
  int y;
};

std::string pair(const Pixel& p) { return std::to_string(p.x) + "," + std::to_string(p.y); }

/// A line between two nodes to the right or upwards, its head beside the target's dot.
std::string arrow(const Pixel& source, const Pixel& target, int dot, int head) {
  const Pixel along{target.x > source.x ? 1 : 0, target.y < source.y ? -1 : 0};
  const Pixel across{-along.y, along.x};
  const auto at = [&](const Pixel& from, int forward, int sideways) {
    return Pixel{from.x + forward * along.x + sideways * across.x,
                 from.y + forward * along.y + sideways * across.y};
  };
  const Pixel tip = at(target, -dot, 0);
  return "<path d=\"M" + pair(at(source, dot, 0)) + "L" + pair(at(tip, -head, 0)) + "\"/>" +
         "<path d=\"M" + pair(tip) + "L" + pair(at(tip, -2 * head, head)) + "L" +
         pair(at(tip, -2 * head, -head)) + "Z\" stroke=\"none\"/>\n";
}

/// Where nodes are on the page.
class Layout {
 public:
  explicit Layout(const FiberGrid& grid) : grid_(grid) {
    const int most = static_cast<int>(std::max<std::size_t>({grid.n, grid.m, 1}));
    cell_ = std::clamp(900 / most, 10, 48);
  }

  Pixel node(std::size_t i, std::size_t j) const {
    return {left() + cell_ * static_cast<int>(i), bottom() - cell_ * static_cast<int>(j)};
  }

  int left() const { return margin + axis; }
  int right() const { return left() + cell_ * static_cast<int>(grid_.n); }
  int top() const { return 2 * margin + title_size + 6; }
  int bottom() const { return top() + cell_ * static_cast<int>(grid_.m); }
  int dot() const { return cell_ / 12; }
  int head() const { return std::max(2, cell_ / 12); }
  /// Every how many nodes an axis is labelled.
  std::size_t label_step() const { return cell_ >= 20 ? 1 : 5; }

 private:
  const FiberGrid& grid_;
  int cell_;
};

std::string drawn_nodes(const FiberGrid& grid, const Layout& layout) {
  std::set<std::pair<std::size_t, std::size_t>> in_convolution;
  for (const FiberGrid::Edge& e : grid.edges) in_convolution.insert({e.i, e.j});
  const bool all = grid.n * grid.m <= most_drawn_states;
  std::string result = "<g class=\"states\">\n";
  for (std::size_t j = 0; j <= grid.m; ++j) {
    for (std::size_t i = 0; i <= grid.n; ++i) {
      const Pixel at = layout.node(i, j);
      const bool is_repeated = i == grid.n || j == grid.m;
      const bool is_passed = in_convolution.contains({i == grid.n ? 0 : i, j == grid.m ? 0 : j});
      if (!is_passed && !all) continue;
      const int radius = is_passed && !is_repeated ? layout.dot() : std::max(1, layout.dot() / 2);
      result += "<circle" + attribute("cx", at.x) + attribute("cy", at.y) + attribute("r", radius) +
                " fill=\"" + std::string(is_passed && !is_repeated ? ink : pale) + "\"/>\n";
    }
  }
  return result + "</g>\n";
}

/// The edges of one cycle, and its start.
std::string drawn_cycle(const std::vector<FiberGrid::Edge>& edges, const FiberGrid& grid,
                        const Layout& layout) {
  const auto arrow_from = [&](std::size_t i, std::size_t j, Summand along) {
    const Pixel target = along == Summand::P ? layout.node(i + 1, j) : layout.node(i, j + 1);
    return arrow(layout.node(i, j), target, layout.dot(), layout.head());
  };
  std::string once;
  std::string again;
  for (const FiberGrid::Edge& e : edges) {
    once += arrow_from(e.i, e.j, e.along);
    if (e.along == Summand::P && e.j == 0) again += arrow_from(e.i, grid.m, e.along);
    if (e.along == Summand::Q && e.i == 0) again += arrow_from(grid.n, e.j, e.along);
  }
  const Pixel start = layout.node(edges.front().i, edges.front().j);
  std::string result =
      "<g class=\"cycle\"" + stroke_of(edges.front().cycle) + " stroke-width=\"2\">\n" + once +
      "<circle class=\"start\"" + attribute("cx", start.x) + attribute("cy", start.y) +
      attribute("r", 2 * layout.dot() + 2) + " fill=\"none\" stroke-dasharray=\"none\"/>\n";
  if (!again.empty()) result += "<g class=\"repeated\" opacity=\"0.35\">\n" + again + "</g>\n";
  return result + "</g>\n";
}

std::string drawn_axes(const FiberGrid& grid, const Layout& layout) {
  std::string result = "<g class=\"axes\">\n";
  const auto colour = [](bool is_repeated) { return is_repeated ? pale : ink; };
  for (std::size_t i = 0; i <= grid.n; i += layout.label_step())
    result += text(layout.node(i, 0).x, layout.bottom() + 24, label_size, "middle",
                   colour(i == grid.n), std::to_string(i == grid.n ? 0 : i));
  for (std::size_t j = 0; j <= grid.m; j += layout.label_step())
    result += text(layout.left() - 14, layout.node(0, j).y + 4, label_size, "end",
                   colour(j == grid.m), std::to_string(j == grid.m ? 0 : j));
  const int middle_x = (layout.left() + layout.right()) / 2;
  const int middle_y = (layout.top() + layout.bottom()) / 2;
  result += text(middle_x, layout.bottom() + 44, label_size, "middle", ink, "vertex of P");
  result += text(margin + label_size, middle_y, label_size, "middle", ink, "vertex of Q",
                 " transform=\"rotate(-90 " + std::to_string(margin + label_size) + " " +
                     std::to_string(middle_y) + ")\"");
  return result + "</g>\n";
}

/// How often a cycle goes round P and round Q.
std::string described(const std::vector<FiberGrid::Edge>& edges, const FiberGrid& grid) {
  const auto of_p = static_cast<std::size_t>(std::count_if(
      edges.begin(), edges.end(), [](const FiberGrid::Edge& e) { return e.along == Summand::P; }));
  return counted(edges.size(), "segment", "segments") + ": P " + std::to_string(of_p / grid.n) +
         "\u00d7, Q " + std::to_string((edges.size() - of_p) / grid.m) + "\u00d7";
}

std::string drawn_legend(const std::vector<std::vector<FiberGrid::Edge>>& cycles,
                         const FiberGrid& grid, const Layout& layout) {
  const int left = layout.right() + 2 * margin;
  std::string result = "<g class=\"legend\">\n";
  const std::size_t rows = std::min(cycles.size(), most_legend_rows);
  for (std::size_t c = 0; c < rows; ++c) {
    const int y = layout.top() + 4 + legend_row * static_cast<int>(c);
    result += "<g" + stroke_of(c) + " stroke-width=\"2\">" +
              arrow({left, y}, {left + 30, y}, 0, 3) + "</g>\n" +
              text(left + 38, y + 4, label_size, "start", ink, described(cycles[c], grid));
  }
  if (cycles.size() > rows)
    result += text(left + 38, layout.top() + 8 + legend_row * static_cast<int>(rows), label_size,
                   "start", ink, "and " + std::to_string(cycles.size() - rows) + " more");
  return result + "</g>\n";
}

}  // namespace

std::string svg(const FiberGrid& grid) {
  const Layout layout(grid);
  std::vector<std::vector<FiberGrid::Edge>> cycles(grid.cycles);
  for (const FiberGrid::Edge& e : grid.edges) cycles[e.cycle].push_back(e);

  const int legend_rows = static_cast<int>(std::min(cycles.size(), most_legend_rows)) + 1;
  const int width = layout.right() + 2 * margin + legend_width + margin;
  const int height =
      std::max(layout.bottom() + axis, layout.top() + legend_row * legend_rows) + margin;
  std::string result = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " +
                       std::to_string(width) + " " + std::to_string(height) + "\"" +
                       attribute("width", width) + attribute("height", height) +
                       " font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\">\n"
                       "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
  result += text(margin, margin + title_size, title_size, "start", ink,
                 "Fiber grid: n = " + std::to_string(grid.n) + ", m = " + std::to_string(grid.m) +
                     ", K = " + std::to_string(grid.edges.size()) + ", " +
                     counted(grid.cycles, "cycle", "cycles"));
  result += drawn_axes(grid, layout) + drawn_nodes(grid, layout);
  for (const std::vector<FiberGrid::Edge>& cycle : cycles)
    result += drawn_cycle(cycle, grid, layout);
  return result + drawn_legend(cycles, grid, layout) + "</svg>\n";
}

}  // namespace oplus
