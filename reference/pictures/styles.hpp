// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>

#include "reference/pictures/picture.hpp"

/// Styles of the sets of the definitions. The colours are those of Okabe and Ito, which colour-blind
/// readers can distinguish.
namespace oplus::style {

inline Style area(const char* name, const char* label, int place, const char* line,
                  const char* fill) {
  return {.name = name, .label = label, .place = place, .line = line, .fill = fill, .width = 1.6};
}
inline Style lines(std::string name, std::string label, int place, std::string colour, double width,
                   Style::Sample sample = Style::Sample::line) {
  return {.name = std::move(name),
          .label = std::move(label),
          .place = place,
          .sample = sample,
          .line = std::move(colour),
          .width = width};
}
/// Lines with arrow heads.
inline Style directed_lines(std::string name, std::string label, int place, std::string colour,
                            double width, std::string dash = {}) {
  Style style = lines(std::move(name), std::move(label), place, std::move(colour), width);
  style.directed = true;
  style.dash = std::move(dash);
  return style;
}

inline const Style summand_p = area("summand-p", "P", 0, "#0072b2", "#c7e0f0");
inline const Style summand_q = area("summand-q", "Q", 1, "#b87700", "#fbe6b8");
inline const Style convolution = directed_lines("convolution", "convolution", 2, "#5a5a5a", 0.9);
inline const Style reduced_convolution =
    directed_lines("reduced-convolution", "reduced convolution", 3, "#007a59", 0.9);
inline const Style sum = area("sum", "sum", 4, "#1a1a1a", "#dfe3e6");
/// Faces of the complement inside the sum.
inline const Style holes{.name = "holes", .label = "hole", .place = 5, .fill = "url(#holes)"};
inline const Style dangling_edges = lines("dangling-edges", "dangling edge", 6, "#c0267e", 4);
inline const Style isolated_vertices{.name = "isolated-vertices",
                                     .label = "isolated vertex",
                                     .place = 7,
                                     .sample = Style::Sample::disk,
                                     .fill = "#c0267e"};
/// A point to look at.
inline const Style difference =
    lines("difference", "point of difference", 8, "#000000", 2.2, Style::Sample::cross);
/// The mark of the point (0, 0).
inline const Style origin = lines("origin", "origin", 30, "#1a1a1a", 1.2, Style::Sample::plus);

/// Lines of several kinds, numbered from zero. After the last colour, the colours are repeated with
/// dashes.
Style cycle(int number);

}  // namespace oplus::style
