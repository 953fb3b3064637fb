// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reference/pictures/picture.hpp"

namespace oplus::picture {

/// How a layer is drawn.
struct Style {
  std::string name;   ///< the class of the SVG group
  std::string label;  ///< in the legend, unless the layer has a name
  std::string line;   ///< a colour, or none
  std::string fill;   ///< likewise
  double width;       ///< of lines, in pixels
  bool directed;      ///< with arrow heads
  std::string dash;   ///< a stroke-dasharray, empty for a solid line
  std::string ink;    ///< of notes
};

Style style(Layer::Kind kind, int number);

}  // namespace oplus::picture
