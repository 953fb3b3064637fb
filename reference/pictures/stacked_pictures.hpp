// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace oplus {

struct TitledPicture {
  std::string title;
  std::string svg;  ///< a document with a width and a height in pixels
};

/// Returns one SVG document with the pictures one below another, each under its title.
/// Throws std::invalid_argument for a picture that does not start with its svg tag or lacks its size.
std::string stacked(const std::vector<TitledPicture>& pictures);

}  // namespace oplus
