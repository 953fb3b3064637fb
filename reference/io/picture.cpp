// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/io/picture.hpp"

#include <algorithm>
#include <array>
#include <boost/locale/utf.hpp>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <set>
#include <string_view>

namespace oplus {

namespace {

using Kind = Layer::Kind;

/// How a kind is drawn. The colours are those of Okabe and Ito, told apart by colour-blind readers.
struct Style {
  std::string_view name;   ///< the class of the SVG group
  std::string_view label;  ///< in the legend
  std::string_view line;
  std::string_view fill;
  double width;  ///< of lines, in pixels
  bool directed;
};

const Style& style(Kind kind) {
  static constexpr std::array<Style, 9> styles = {{
      {"summand-p", "P", "#0072b2", "#c7e0f0", 1.6, false},
      {"summand-q", "Q", "#b87700", "#fbe6b8", 1.6, false},
      {"convolution", "convolution", "#5a5a5a", "none", 0.9, true},
      {"reduced-convolution", "reduced convolution", "#007a59", "none", 0.9, true},
      {"sum", "sum", "#1a1a1a", "#dfe3e6", 1.6, false},
      {"holes", "hole", "none", "url(#holes)", 0, false},
      {"dangling-edges", "dangling edge", "#c0267e", "none", 4, false},
      {"isolated-vertices", "isolated vertex", "none", "#c0267e", 0, false},
      {"difference", "point of difference", "#000000", "none", 2.2, false},
  }};
  return styles.at(static_cast<std::size_t>(kind));
}

/// Two decimals of a pixel, whatever the locale.
std::string number(double pixels) {
  std::array<char, 64> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), pixels,
                                 std::chars_format::fixed, 2)
                       .ptr;
  return {digits.data(), end};
}

/// A start tag's attributes, as ` name="value"`.
std::string attributes(
    std::initializer_list<std::pair<std::string_view, std::string>> names_and_values) {
  std::string result;
  for (const auto& [name, value] : names_and_values)
    result.append(" ").append(name).append("=\"").append(value).append("\"");
  return result;
}

/// Text that XML can hold: markup escaped; what is no character there becomes a question mark.
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

/// An upper estimate of a text's width: fonts differ.
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

bool is_empty(const Layer& layer) {
  return layer.region.components.empty() && layer.segments.empty() && layer.points.empty();
}

struct Box {
  Point low;
  Point high;
};

std::optional<Box> bounding_box(const Panel& panel) {
  std::optional<Box> box;
  const auto extend = [&](const Point& p) {
    if (!box) box = {p, p};
    if (p.x < box->low.x) box->low.x = p.x;
    if (p.y < box->low.y) box->low.y = p.y;
    if (p.x > box->high.x) box->high.x = p.x;
    if (p.y > box->high.y) box->high.y = p.y;
  };
  for (const Layer& layer : panel.layers) {
    for (const Segment& e : edges(layer.region)) extend(e.source);
    for (const Segment& s : layer.segments) {
      extend(s.source);
      extend(s.target);
    }
    for (const Point& p : layer.points) extend(p);
  }
  return box;
}

constexpr double longest_side = 320;  // of a drawing, in pixels
constexpr double margin = 14;         // around a drawing and between panels
constexpr double title_size = 14;
constexpr double legend_size = 13;
constexpr double caption_size = 10;

struct Pixel {
  double x;
  double y;
};

/// Where a panel stands on the page and how its coordinates become pixels. The difference to the
/// corner is divided by the extent exactly, so huge and tiny coordinates do not overflow.
class Frame {
 public:
  Frame(const Panel& panel, double left, double top)
      : box_(bounding_box(panel)), left_(left), top_(top) {
    if (!box_) box_ = Box{};
    const Rational w = box_->high.x - box_->low.x;
    const Rational h = box_->high.y - box_->low.y;
    extent_ = w > h ? w : h;
    if (extent_ == 0) extent_ = 1;
    width_ = pixels(w);
    height_ = pixels(h);
  }

  double width() const { return width_; }
  double height() const { return height_; }

  Pixel operator()(const Point& p) const {
    return {left_ + pixels(p.x - box_->low.x), top_ + pixels(box_->high.y - p.y)};
  }

 private:
  double pixels(const Rational& length) const {
    return longest_side * Rational(length / extent_).get_d();
  }

  std::optional<Box> box_;
  Rational extent_;
  double left_;
  double top_;
  double width_ = 0;
  double height_ = 0;
};

/// A step of a path: 'M' moves to p, 'L' draws a line to it.
std::string step(char command, const Pixel& p) {
  return std::string(1, command).append(number(p.x)).append(",").append(number(p.y));
}

std::string path(const std::string& data, const std::string& more) {
  return "<path d=\"" + data + "\"" + more + "/>\n";
}

double distance(const Pixel& a, const Pixel& b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// A small triangle in the middle of a segment, none where it would hide the segment.
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

std::string line_attributes(const Style& s, double width, const std::string& fill) {
  return attributes({{"fill", fill},
                     {"stroke", std::string(s.line)},
                     {"stroke-width", number(width)},
                     {"stroke-linejoin", "round"},
                     {"stroke-linecap", "round"},
                     {"vector-effect", "non-scaling-stroke"}});
}

std::string circle(const Pixel& centre, double radius, const std::string& more) {
  return "<circle" +
         attributes({{"cx", number(centre.x)}, {"cy", number(centre.y)}, {"r", number(radius)}}) +
         more + "/>\n";
}

double mean_edge_length(const std::vector<Pixel>& chain) {
  double length = 0;
  for (std::size_t i = 0; i < chain.size(); ++i)
    length += distance(chain[i], chain[next(i, chain.size())]);
  return length / static_cast<double>(chain.size());
}

std::string outline(const std::vector<Pixel>& chain) {
  std::string data;
  for (const Pixel& p : chain) data += step(data.empty() ? 'M' : 'L', p);
  return data.append("Z");
}

std::string drawn_region(const std::vector<std::vector<Pixel>>& boundary, const Style& s) {
  std::string all;
  std::string bold;
  std::string thin;
  std::string vertices;
  for (const std::vector<Pixel>& chain : boundary) {
    const std::string data = outline(chain);
    const double mean = mean_edge_length(chain);
    all += data;
    // Where edges are short a bold outline or dots would hide the drawing.
    (mean < 8 ? thin : bold) += data;
    if (mean < 16) continue;
    for (const Pixel& vertex : chain)
      vertices += circle(vertex, 2.1, attributes({{"fill", std::string(s.line)}}));
  }
  std::string result =
      path(all, attributes({{"fill", std::string(s.fill)}, {"fill-rule", "nonzero"}}));
  if (s.line == "none") return result;
  if (!thin.empty()) result += path(thin, line_attributes(s, s.width / 3, "none"));
  if (!bold.empty()) result += path(bold, line_attributes(s, s.width, "none"));
  return result + vertices;
}

std::string drawn_segments(const std::vector<std::array<Pixel, 2>>& segments, const Style& s) {
  const bool dense = segments.size() > 300;
  std::string lines;
  std::string heads;
  for (const auto& [source, target] : segments) {
    lines += step('M', source) + step('L', target);
    if (s.directed) heads += arrow_head(source, target, dense ? 2.6 : 4.5);
  }
  std::string result = path(lines, line_attributes(s, dense ? s.width / 1.5 : s.width, "none"));
  if (!heads.empty()) result += path(heads, attributes({{"fill", std::string(s.line)}}));
  return result;
}

std::string drawn_point(const Pixel& p, Kind kind) {
  const Style& s = style(kind);
  if (kind == Kind::difference) {
    const double r = 5;
    const std::string cross = step('M', {p.x - r, p.y - r}) + step('L', {p.x + r, p.y + r}) +
                              step('M', {p.x - r, p.y + r}) + step('L', {p.x + r, p.y - r});
    return path(cross,
                attributes({{"fill", "none"}, {"stroke", "#ffffff"}, {"stroke-width", "5"}})) +
           path(cross, line_attributes(s, s.width, "none"));
  }
  const std::string colour(s.fill == "none" ? s.line : s.fill);
  return circle(p, 9,
                attributes({{"fill", "#ffffff"},
                            {"fill-opacity", "0.75"},
                            {"stroke", colour},
                            {"stroke-width", "1.4"}})) +
         circle(p, 3.6, attributes({{"fill", colour}}));
}

std::string drawn(const Layer& layer, const Frame& frame) {
  const Style& s = style(layer.kind);
  std::string result = "<g" + attributes({{"class", std::string(s.name)}}) + ">\n";
  if (!layer.region.components.empty()) {
    std::vector<std::vector<Pixel>> boundary;
    for (const Chain& chain : chains(layer.region)) {
      boundary.emplace_back();
      for (const Point& p : chain) boundary.back().push_back(frame(p));
    }
    result += drawn_region(boundary, s);
  }
  if (!layer.segments.empty()) {
    std::vector<std::array<Pixel, 2>> segments;
    for (const Segment& e : layer.segments) segments.push_back({frame(e.source), frame(e.target)});
    result += drawn_segments(segments, s);
  }
  for (const Point& p : layer.points) result += drawn_point(frame(p), layer.kind);
  return result + "</g>\n";
}

/// What a kind looks like, in the legend: centred at p.
std::string swatch(Kind kind, const Pixel& p) {
  const Style& s = style(kind);
  switch (kind) {
    case Kind::convolution:
    case Kind::reduced_convolution:
    case Kind::dangling_edges:
      return drawn_segments({{{{p.x - 11, p.y}, {p.x + 11, p.y}}}}, s);
    case Kind::isolated_vertices:
    case Kind::difference:
      return drawn_point(p, kind);
    default:
      return "<rect" +
             attributes({{"x", number(p.x - 10)},
                         {"y", number(p.y - 6)},
                         {"width", "20"},
                         {"height", "12"},
                         {"fill", std::string(s.fill)},
                         {"stroke", std::string(s.line)}}) +
             "/>\n";
  }
}

struct Drawing {
  std::string content;
  double height;
};

/// The kinds in rows no wider than the page.
Drawing legend(const std::set<Kind>& kinds, double top, double page_width) {
  constexpr double row = 26;
  double x = margin;
  double y = top;
  std::string content = "<g class=\"legend\">\n";
  for (const Kind kind : kinds) {
    const double width = 34 + text_width(label(kind), legend_size) + 10;
    if (x > margin && x + width > page_width) {
      x = margin;
      y += row;
    }
    content += swatch(kind, {x + 12, y + row / 2});
    content += text(x + 30, y + row / 2 + 4.5, legend_size, "start", "#1a1a1a", label(kind));
    x += width;
  }
  return {content + "</g>\n", kinds.empty() ? 0 : y + row - top};
}

/// About five digits; GMP's floats have room for every exponent.
std::string approximate(const Rational& value) {
  const mpf_class rounded(value);
  std::array<char, 64> digits{};
  gmp_snprintf(digits.data(), digits.size(), "%.5Fg", rounded.get_mpf_t());
  return digits.data();
}

std::string caption(const Panel& panel) {
  const std::optional<Box> box = bounding_box(panel);
  if (!box) return "empty";
  return "x " + approximate(box->low.x) + " \u2026 " + approximate(box->high.x) + ",  y " +
         approximate(box->low.y) + " \u2026 " + approximate(box->high.y);
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace

std::string label(Layer::Kind kind) { return std::string(style(kind).label); }

std::vector<Panel> panels_of(const Region& p, const Region& q) {
  const std::vector<Segment> full = segments(convolution(p, q));
  const std::vector<Segment> reduced = segments(reduced_convolution(p, q));
  return {{"P: " + counted(vertex_count(p), "vertex", "vertices"), {{Kind::summand_p, p}}},
          {"Q: " + counted(vertex_count(q), "vertex", "vertices"), {{Kind::summand_q, q}}},
          {"Convolution: " + counted(full.size(), "segment", "segments"),
           {{Kind::convolution, {}, full}}},
          {"Reduced convolution: " + counted(reduced.size(), "segment", "segments"),
           {{Kind::reduced_convolution, {}, reduced}}}};
}

std::vector<Layer> layers_of(const MinkowskiSum& sum) {
  // A hole may have a part of the sum inside it, so the sum is drawn over the holes.
  Layer holes{Kind::holes};
  for (const Chain& hole : sum.holes)
    holes.region.components.push_back({Chain(hole.rbegin(), hole.rend()), {}});
  std::vector<Layer> layers = {holes,
                               {Kind::sum, region_of(sum)},
                               {Kind::dangling_edges, {}, sum.dangling_edges},
                               {Kind::isolated_vertices, {}, {}, sum.isolated_vertices}};
  std::erase_if(layers, is_empty);
  return layers;
}

std::string svg(const std::vector<Panel>& panels) {
  double height = 60;
  for (const Panel& panel : panels) height = std::max(height, Frame(panel, 0, 0).height());
  const double top = margin + title_size + margin;

  std::string content;
  std::set<Kind> kinds;
  double x = margin;
  for (const Panel& panel : panels) {
    const Frame measured(panel, 0, 0);
    const double width = std::max({measured.width(), text_width(panel.title, title_size),
                                   text_width(caption(panel), caption_size)});
    const double centre = x + width / 2;
    const Frame frame(panel, centre - measured.width() / 2, top + (height - measured.height()) / 2);
    content += "<g class=\"panel\">\n";
    content += text(centre, margin + title_size, title_size, "middle", "#1a1a1a", panel.title);
    for (const Layer& layer : panel.layers) {
      if (is_empty(layer)) continue;
      kinds.insert(layer.kind);
      content += drawn(layer, frame);
    }
    content += text(centre, top + height + margin + caption_size, caption_size, "middle", "#6a6a6a",
                    caption(panel));
    content += "</g>\n";
    x += width + 2 * margin;
  }
  const double page_width = std::max(x - margin, 240.0);
  const double legend_top = top + height + margin + 2 * caption_size;
  const Drawing key = legend(kinds, legend_top, page_width);
  const double page_height = legend_top + key.height + margin;

  const std::string size = number(page_width) + " " + number(page_height);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\"" +
         attributes({{"viewBox", "0 0 " + size},
                     {"width", number(page_width)},
                     {"height", number(page_height)},
                     {"font-family", "DejaVu Sans, Helvetica, Arial, sans-serif"}}) +
         ">\n<defs><pattern id=\"holes\" width=\"5\" height=\"5\" patternUnits=\"userSpaceOnUse\" "
         "patternTransform=\"rotate(45)\"><rect width=\"5\" height=\"5\" fill=\"#f8c9a8\"/>"
         "<path d=\"M0,0V5\" stroke=\"#d55e00\" stroke-width=\"2.4\"/></pattern></defs>\n"
         "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" +
         content + key.content + "</svg>\n";
}

}  // namespace oplus
