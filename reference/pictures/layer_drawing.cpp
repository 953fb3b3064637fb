// SPDX-License-Identifier: MIT
#include "reference/pictures/layer_drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace oplus::picture {

namespace {

using Sample = Style::Sample;

std::string line_attributes(const Style& s, double width, const std::string& fill) {
  std::string result = attributes({{"fill", fill},
                                   {"stroke", s.line},
                                   {"stroke-width", number(width)},
                                   {"stroke-linejoin", "round"},
                                   {"stroke-linecap", "round"},
                                   {"vector-effect", "non-scaling-stroke"}});
  if (!s.dash.empty()) result += attributes({{"stroke-dasharray", s.dash}});
  return result;
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
      vertices += circle(vertex, 2.1, attributes({{"fill", s.line}}));
  }
  std::string result = path(all, attributes({{"fill", s.fill}, {"fill-rule", "nonzero"}}));
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
  if (!heads.empty()) result += path(heads, attributes({{"fill", s.line}}));
  return result;
}

std::string drawn_cross(const Pixel& p, const Style& s) {
  const double r = 5;
  const bool is_upright = s.sample == Sample::plus;
  const std::string cross = is_upright
                                ? step('M', {p.x - r, p.y}) + step('L', {p.x + r, p.y}) +
                                      step('M', {p.x, p.y - r}) + step('L', {p.x, p.y + r})
                                : step('M', {p.x - r, p.y - r}) + step('L', {p.x + r, p.y + r}) +
                                      step('M', {p.x - r, p.y + r}) + step('L', {p.x + r, p.y - r});
  return path(cross, attributes({{"fill", "none"},
                                 {"stroke", "#ffffff"},
                                 {"stroke-width", number(s.width + 2.8)}})) +
         path(cross, line_attributes(s, s.width, "none"));
}

std::string drawn_disk(const Pixel& p, const Style& s) {
  return circle(p, 9,
                attributes({{"fill", "#ffffff"},
                            {"fill-opacity", "0.75"},
                            {"stroke", s.fill},
                            {"stroke-width", "1.4"}})) +
         circle(p, 3.6, attributes({{"fill", s.fill}}));
}

/// A dot, or a ring, of which there may be many close together.
std::string drawn_contact(const Pixel& p, const Style& s, bool is_ring) {
  return circle(p, 4.2,
                attributes({{"fill", is_ring ? "#ffffff" : s.fill},
                            {"stroke", is_ring ? s.fill : "#ffffff"},
                            {"stroke-width", is_ring ? "1.6" : "1"}}));
}

std::string drawn_point(const Pixel& p, const Style& s) {
  switch (s.sample) {
    case Sample::cross:
    case Sample::plus:
      return drawn_cross(p, s);
    case Sample::dot:
    case Sample::ring:
      return drawn_contact(p, s, s.sample == Sample::ring);
    default:
      return drawn_disk(p, s);
  }
}

/// Empty where the text would not be readable in its disk.
std::string drawn_note(const Layer::Note& note, const Frame& frame, const Style& s) {
  constexpr double smallest = 6.5;
  constexpr double largest = 12;
  constexpr double distance_to_lines = 2.5;
  constexpr double height = 0.73;  // of a digit, at size 1
  const double diagonal = std::hypot(text_width(note.text, 1), height);
  const double size =
      std::min(largest, 2 * (frame.radius(note.squared_radius) - distance_to_lines) / diagonal);
  if (!(size >= smallest)) return "";
  const Pixel at = frame(note.at);
  return text(at.x, at.y + height / 2 * size, size, "middle", s.ink, note.text);
}

}  // namespace

DrawnLayer drawn(const Layer& layer, const Frame& frame) {
  const Style& s = layer.style;
  DrawnLayer result{"<g" + attributes({{"class", s.name}}) + ">\n", 0};
  if (!layer.region.components.empty()) {
    std::vector<std::vector<Pixel>> boundary;
    for (const Chain& chain : chains(layer.region)) {
      boundary.emplace_back();
      for (const Point& p : chain) boundary.back().push_back(frame(p));
    }
    result.content += drawn_region(boundary, s);
  }
  if (!layer.segments.empty()) {
    std::vector<std::array<Pixel, 2>> segments;
    for (const Segment& e : layer.segments) segments.push_back({frame(e.source), frame(e.target)});
    result.content += drawn_segments(segments, s);
  }
  for (const Point& p : layer.points) result.content += drawn_point(frame(p), s);
  for (const Layer::Note& note : layer.notes) {
    const std::string content = drawn_note(note, frame, s);
    result.content += content;
    if (content.empty()) ++result.notes_left_out;
  }
  result.content += "</g>\n";
  return result;
}

std::string swatch(const Style& s, const Pixel& p) {
  if (s.sample == Sample::line) return drawn_segments({{{{p.x - 11, p.y}, {p.x + 11, p.y}}}}, s);
  if (s.sample != Sample::area) return drawn_point(p, s);
  return "<rect" +
         attributes({{"x", number(p.x - 10)},
                     {"y", number(p.y - 6)},
                     {"width", "20"},
                     {"height", "12"},
                     {"fill", s.fill},
                     {"stroke", s.line}}) +
         "/>\n";
}

}  // namespace oplus::picture
