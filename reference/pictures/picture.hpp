// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "reference/definitions/direction.hpp"
#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

/// How a layer is drawn, and its label in the legend.
struct Style {
  /// What stands for the layer in the legend. The last five are points, and how points are drawn; in
  /// layers of areas and lines they are disks.
  enum class Sample { area, line, disk, cross, dot, ring, plus };

  std::string name;   ///< the class of the SVG group
  std::string label;  ///< in the legend, where `place` decides the order, then `number`
  int place = 0;
  int number = 0;  ///< which one of several styles with one name
  Sample sample = Sample::area;
  std::string line = "none";    ///< a colour, or none
  std::string fill = "none";    ///< likewise
  double width = 0;             ///< of lines, in pixels
  bool directed = false;        ///< with arrow heads
  std::string dash = {};        ///< a stroke-dasharray, empty for a solid line
  std::string ink = "#1a1a1a";  ///< of notes
};

/// The same with another label.
Style labelled(Style style, std::string label);

/// A drawing in panels, each with a title and layers, and a legend that names every layer drawn. All
/// panels have one scale, so that shapes can be compared; a panel that would be too small to see is
/// enlarged, and its caption says how many times. The origin is marked where it is in or near a panel.
/// Coordinates are rounded to doubles, for the eye only.
struct Layer {
  /// A short text for a place where a disk is free.
  struct Note {
    std::string text;
    Point at;
    Rational squared_radius;  ///< of the disk
  };

  Style style;
  Region region = {};                  ///< filled, boundary drawn if the style has a line
  std::vector<Segment> segments = {};  ///< drawn with arrow heads where the style is directed
  std::vector<Point> points = {};
  std::vector<Note> notes = {};  ///< left out, and counted in the legend, where they don't fit
};

struct Panel {
  std::string title;
  std::vector<Layer> layers;  ///< the first lowest; empty ones are neither drawn nor in the legend
};

/// A summand, its title its size.
Panel panel_of(Summand which, const Region& summand);

/// A convolution or a reduced one, titled with its size.
Panel convolution_panel(std::vector<Segment> convolution);
Panel reduced_convolution_panel(std::vector<Segment> reduced);

/// Panels for P, Q, their convolution and their reduced convolution.
std::vector<Panel> panels_of(const Region& p, const Region& q);

/// The layers of a sum: its holes, its region, its low-dimensional features; empty ones left out.
std::vector<Layer> layers_of(const PlanarSet& sum);

/// Returns about five digits of a number, for the eye.
std::string approximate(const Rational& value);

/// Returns an SVG document of panels side by side, y axis up. The longest side of the largest drawing
/// is given in pixels. Same panels, same bytes.
std::string svg(const std::vector<Panel>& panels, double longest_side = 320);

/// The same with panels one below another in columns.
std::string svg_in_columns(const std::vector<std::vector<Panel>>& columns,
                           double longest_side = 320);

}  // namespace oplus
