// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/pictures/layer_style.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace oplus::picture {

namespace {

using Kind = Layer::Kind;

constexpr std::string_view ink = "#1a1a1a";

struct FixedStyle {
  std::string_view name;
  std::string_view label;
  std::string_view line;
  std::string_view fill;
  double width;
  bool directed;
  std::string_view dash = "";
};

/// The colours are those of Okabe and Ito, told apart by colour-blind readers.
constexpr std::array<FixedStyle, 24> styles = {{
    {"summand-p", "P", "#0072b2", "#c7e0f0", 1.6, false},
    {"summand-q", "Q", "#b87700", "#fbe6b8", 1.6, false},
    {"convolution", "convolution", "#5a5a5a", "none", 0.9, true},
    {"reduced-convolution", "reduced convolution", "#007a59", "none", 0.9, true},
    {"sum", "sum", "#1a1a1a", "#dfe3e6", 1.6, false},
    {"holes", "hole", "none", "url(#holes)", 0, false},
    {"dangling-edges", "dangling edge", "#c0267e", "none", 4, false},
    {"isolated-vertices", "isolated vertex", "none", "#c0267e", 0, false},
    {"difference", "point of difference", "#000000", "none", 2.2, false},
    {"cycle", "cycle", "none", "none", 1.4, true},
    {"winding-number", "winding number", "none", "none", 0, false},
    {"flipped", "flipped segment", "#d55e00", "none", 0.9, true},
    {"no-candidate", "no candidate", "none", "#e9ecee", 0, false},
    {"candidate-in-sum", "candidate in the sum", "none", "#d9c3e6", 0, false},
    {"on-no-loop", "on no loop", "#9a9a9a", "none", 0.8, true},
    {"boundary-loop", "loop of the boundary", "#0072b2", "none", 2.2, true},
    {"not-nested-loop", "loop that is not nested", "#d58a00", "none", 2.2, true, "6 3"},
    {"not-boundary-loop", "loop not of the boundary", "#c0267e", "none", 2.2, true, "2 3"},
    {"placed-q", "\u2212Q + x", "#b87700", "#fbe6b8", 1.6, false},
    {"common-interior", "common interior", "none", "#8fcfa0", 0, false},
    {"overlap", "overlap", "#c0267e", "none", 4, false},
    {"crossing", "crossing", "none", "#d55e00", 0, false},
    {"weak-intersection", "weak intersection", "none", "#c0267e", 0, false},
    {"touching", "contact without common interior", "none", "#1a1a1a", 0, false},
}};

/// Where the colours are used up, they come again with dashes.
Style of_cycle(Style style, int number) {
  constexpr std::array<std::string_view, 7> colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                       "#e69f00", "#56b4e9", "#5a5a5a"};
  constexpr std::array<std::string_view, 4> dashes = {"", "7 3", "2 3", "7 3 2 3"};
  const auto index = static_cast<std::size_t>(number);
  style.label += " " + std::to_string(number);
  style.line = colours[index % colours.size()];
  style.dash = dashes[index / colours.size() % dashes.size()];
  return style;
}

/// The larger, the darker; zero and below in other hues.
Style of_winding_number(Style style, int number) {
  constexpr std::array<std::string_view, 8> positive = {"#dcebf7", "#b3d4ec", "#86b9de", "#5a9bcb",
                                                        "#3a7cb3", "#235f97", "#14467a", "#0a2f5c"};
  constexpr std::array<std::string_view, 4> negative = {"#f6d3e4", "#e9a6c9", "#d572a8", "#b23f80"};
  const auto shade = [](const auto& shades, int from_one) {
    return shades[std::min(shades.size(), static_cast<std::size_t>(from_one)) - 1];
  };
  style.label += " " + std::to_string(number);
  style.fill = number == 0  ? "#fbe0c8"
               : number > 0 ? shade(positive, number)
                            : shade(negative, -number);
  if (number > 4 || number < -3) style.ink = "#ffffff";
  return style;
}

}  // namespace

Style style(Kind kind, int number) {
  const FixedStyle& fixed = styles.at(static_cast<std::size_t>(kind));
  Style result{std::string(fixed.name),
               std::string(fixed.label),
               std::string(fixed.line),
               std::string(fixed.fill),
               fixed.width,
               fixed.directed,
               std::string(fixed.dash),
               std::string(ink)};
  if (kind == Kind::cycle) return of_cycle(result, number);
  if (kind == Kind::winding_number) return of_winding_number(result, number);
  return result;
}

}  // namespace oplus::picture
