// SPDX-License-Identifier: MIT
#include "reference/pictures/styles.hpp"

#include <array>

namespace oplus::style {

Style cycle(int number) {
  constexpr std::array<const char*, 7> colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#e69f00", "#56b4e9", "#5a5a5a"};
  constexpr std::array<const char*, 4> dashes = {"", "7 3", "2 3", "7 3 2 3"};
  const auto index = static_cast<std::size_t>(number);
  return {.name = "cycle",
          .label = "cycle " + std::to_string(number),
          .place = 9,
          .number = number,
          .sample = Style::Sample::line,
          .line = colours[index % colours.size()],
          .width = 1.4,
          .directed = true,
          .dash = dashes[index / colours.size() % dashes.size()]};
}

}  // namespace oplus::style
