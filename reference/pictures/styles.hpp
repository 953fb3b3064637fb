// SPDX-License-Identifier: MIT
#pragma once

#include "reference/pictures/picture.hpp"

/// Styles of the sets of the definitions. The colours are those of Okabe and Ito, which colour-blind
/// readers can distinguish.
namespace oplus::style {

inline const Style summand_p{.name = "summand-p",
                             .label = "P",
                             .place = 0,
                             .line = "#0072b2",
                             .fill = "#c7e0f0",
                             .width = 1.6};
inline const Style summand_q{.name = "summand-q",
                             .label = "Q",
                             .place = 1,
                             .line = "#b87700",
                             .fill = "#fbe6b8",
                             .width = 1.6};
inline const Style convolution{.name = "convolution",
                               .label = "convolution",
                               .place = 2,
                               .sample = Style::Sample::line,
                               .line = "#5a5a5a",
                               .width = 0.9,
                               .directed = true};
inline const Style reduced_convolution{.name = "reduced-convolution",
                                       .label = "reduced convolution",
                                       .place = 3,
                                       .sample = Style::Sample::line,
                                       .line = "#007a59",
                                       .width = 0.9,
                                       .directed = true};
inline const Style sum{
    .name = "sum", .label = "sum", .place = 4, .line = "#1a1a1a", .fill = "#dfe3e6", .width = 1.6};
/// Faces of the complement inside the sum.
inline const Style holes{.name = "holes", .label = "hole", .place = 5, .fill = "url(#holes)"};
inline const Style dangling_edges{.name = "dangling-edges",
                                  .label = "dangling edge",
                                  .place = 6,
                                  .sample = Style::Sample::line,
                                  .line = "#c0267e",
                                  .width = 4};
inline const Style isolated_vertices{.name = "isolated-vertices",
                                     .label = "isolated vertex",
                                     .place = 7,
                                     .sample = Style::Sample::disk,
                                     .fill = "#c0267e"};
/// A point to look at.
inline const Style difference{.name = "difference",
                              .label = "point of difference",
                              .place = 8,
                              .sample = Style::Sample::cross,
                              .line = "#000000",
                              .width = 2.2};
/// The mark of the point (0, 0).
inline const Style origin{.name = "origin",
                          .label = "origin",
                          .place = 30,
                          .sample = Style::Sample::plus,
                          .line = "#1a1a1a",
                          .width = 1.2};

/// Lines of several kinds, numbered from zero. After the last colour, the colours are repeated with
/// dashes.
Style cycle(int number);

}  // namespace oplus::style
