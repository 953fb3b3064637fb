// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "reference/definitions/planar_set.hpp"
#include "reference/definitions/region.hpp"
#include "reference/pictures/picture.hpp"

namespace oplus {

/// A picture of what an algorithm sees of two regions.
struct View {
  std::string name;
  std::string what;      ///< a line for the help
  bool has_a_placement;  ///< whether it is drawn for one x
  std::string (*draw)(const Region& p, const Region& q, const Point& x);  ///< an SVG document
};

/// All views, in the order of the help.
const std::vector<View>& views();

/// Returns nullptr for an unknown name.
const View* find_view(const std::string& name);

// One each. Same regions, same bytes.
// Require: p and q are valid (validity.hpp).

/// The fiber grid of each pair of chains (thesis, Definition 4.1.7), one below another.
std::string fiber_grid_view(const Region& p, const Region& q);

/// The convolution's segments in the colours of their cycles (thesis, Definition 4.1.1).
std::string cycles_view(const Region& p, const Region& q);

/// The faces of the reduced convolution's arrangement: those that the filter leaves as candidates,
/// and which of them are holes (thesis, Section 3.2).
std::string faces_view(const Region& p, const Region& q);

/// The reduced convolution's segments, and the sum that their free pieces bound (docs/slide.md).
std::string slide_view(const Region& p, const Region& q);

/// The orientable loops of the reduced convolution's arrangement, by verdict (thesis, Section 3.1).
std::string loops_view(const Region& p, const Region& q);

/// The faces of the convolution's arrangement, shaded by winding number, which is written into all
/// but very small ones (thesis, Section 4.2).
std::string winding_view(const Region& p, const Region& q);

/// The same for the original convolution, flipped segments told apart (thesis, Section 4.2.3).
std::string original_view(const Region& p, const Region& q);

/// P and -Q+x, their common interior, and the contacts of their boundaries by kind; the answer of
/// the collision test in the title (thesis, Section 5.1).
std::string placement_view(const Region& p, const Region& q, const Point& x);

/// Its drawing alone.
Panel placement_panel(const Region& p, const Region& q, const Point& x);

/// The document: both summands in a column, the drawing at its right.
std::string beside_summands(const Region& p, const Region& q, std::string title,
                            std::vector<Layer> layers);

/// The drawing of a summand that may have edges and points of its own; its title says how many of each.
/// Requires: it is bounded.
Panel panel_of_set(Summand which, const PlanarSet& set);

}  // namespace oplus
