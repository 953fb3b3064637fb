// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/pictures/styles.hpp"

/// How several of the views and pictures of `oplus` draw the same thing.
namespace oplus::style {

inline const Style boundary_loop =
    directed_lines("boundary-loop", "loop of the boundary", 15, "#0072b2", 2.2);
inline const Style common_interior{
    .name = "common-interior", .label = "common interior", .place = 19, .fill = "#8fcfa0"};
/// A contact of boundaries without common interior.
inline const Style touching{.name = "touching",
                            .label = "contact without common interior",
                            .place = 23,
                            .sample = Style::Sample::ring,
                            .fill = "#1a1a1a"};

/// Faces of a winding number, filled, or the number in them: the larger, the darker; zero and below
/// in other hues.
Style winding_number(int number);

}  // namespace oplus::style
