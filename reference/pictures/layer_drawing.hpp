// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "reference/pictures/panel_frame.hpp"
#include "reference/pictures/picture.hpp"
#include "reference/pictures/svg_elements.hpp"

namespace oplus::picture {

struct DrawnLayer {
  std::string content;
  std::size_t notes_left_out;  ///< for want of room
};

DrawnLayer drawn(const Layer& layer, const Frame& frame);

/// What a layer looks like, in the legend: centred at p.
std::string swatch(const Style& style, const Pixel& p);

}  // namespace oplus::picture
