// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reference/definitions/direction.hpp"
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
    difference,         ///< a point to look at
    cycle,              ///< of the convolution; numbered
    winding_number,     ///< the faces that have it, filled; numbered
    flipped,            ///< segments of the original convolution that are not in the reduced one
    no_candidate,       ///< faces that need no hole test
    candidate_in_sum,   ///< faces that a hole test found to be no hole
    on_no_loop,         ///< edges of an arrangement that are on no orientable loop
    boundary_loop,      ///< an orientable loop, by what became of it
    not_nested_loop,    ///< likewise
    not_boundary_loop,  ///< likewise
    placed_q,           ///< -Q+x
    common_interior,
    overlap,            ///< of two boundaries
    crossing,           ///< of two boundaries, each of which goes straight on
    weak_intersection,  ///< any other contact with common interior around it
    touching,           ///< a contact without
  };

  /// A short text for a place where a disk is free.
  struct Note {
    std::string text;
    Point at;
    Rational squared_radius;  ///< of the disk
  };

  Kind kind;
  Region region = {};                  ///< filled, boundary drawn (not that of faces)
  std::vector<Segment> segments = {};  ///< drawn with arrow heads where the kind is directed
  std::vector<Point> points = {};      ///< drawn as dots with a halo
  int number = 0;                      ///< which one, of a numbered kind
  std::vector<Note> notes = {};  ///< left out, and counted in the legend, where they don't fit
  std::string name = {};         ///< in the legend, instead of label(kind, number)
};

/// Returns what the legend calls a layer.
std::string label(Layer::Kind kind, int number = 0);

struct Panel {
  std::string title;
  std::vector<Layer> layers;  ///< the first lowest; empty ones are neither drawn nor in the legend
  double longest_side = 320;  ///< of the drawing, in pixels
};

/// A summand, its title its size.
Panel panel_of(Summand which, const Region& summand);

/// Panels for P, Q, their convolution and their reduced convolution, titled with their sizes.
std::vector<Panel> panels_of(const Region& p, const Region& q);

/// The layers of a sum: its holes, its region, its low-dimensional features; empty ones left out.
std::vector<Layer> layers_of(const MinkowskiSum& sum);

/// Returns "1 segment", "2 segments".
std::string counted(std::size_t count, const std::string& one, const std::string& many);

/// Returns about five digits of a number, for the eye.
std::string approximate(const Rational& value);

/// Returns an SVG document, y axis up. Same panels, same bytes.
std::string svg(const std::vector<Panel>& panels);

/// The same with panels one below another in columns.
std::string svg_in_columns(const std::vector<std::vector<Panel>>& columns);

}  // namespace oplus
