// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reference/definitions/minkowski_sum.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// A drawing in panels side by side, each with a title, layers and its own scale, and a legend that
/// names every layer drawn. Coordinates are rounded to doubles, for the eye only.
struct Layer {
  enum class Kind {
    summand_p,
    summand_q,
    convolution,
    reduced_convolution,
    sum,
    holes,  ///< faces of the complement inside the sum, filled
    dangling_edges,
    isolated_vertices,
    difference,  ///< a point to look at
  };
  Kind kind;
  Region region = {};                  ///< filled, boundary drawn (not that of holes)
  std::vector<Segment> segments = {};  ///< drawn with arrow heads where the kind is directed
  std::vector<Point> points = {};      ///< drawn as dots with a halo
};

/// Returns what the legend calls a layer.
std::string label(Layer::Kind kind);

struct Panel {
  std::string title;
  std::vector<Layer> layers;  ///< the first lowest; empty ones are neither drawn nor in the legend
};

/// Panels for P, Q, their convolution and their reduced convolution, titled with their sizes.
std::vector<Panel> panels_of(const Region& p, const Region& q);

/// The layers of a sum: its holes, its region, its low-dimensional features; empty ones left out.
std::vector<Layer> layers_of(const MinkowskiSum& sum);

/// Returns an SVG document, y axis up. Same panels, same bytes.
std::string svg(const std::vector<Panel>& panels);

}  // namespace oplus
