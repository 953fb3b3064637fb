// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "checked/arrangement/winding_numbers.hpp"
#include "checked/cli/face_drawing.hpp"
#include "checked/cli/layer_styles.hpp"
#include "checked/cli/view.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "reference/definitions/original_convolution.hpp"
#include "reference/io/counted.hpp"

namespace oplus {

namespace {

/// The faces below the segments, their winding numbers above.
std::vector<Layer> between_winding_numbers(const ConvolutionArrangement& arrangement,
                                           std::vector<Layer> segments) {
  const std::vector<int> numbers = winding_numbers(arrangement);
  const FaceDrawing drawing(arrangement);
  std::map<int, Layer> faces;
  std::map<int, Layer> notes;
  for (ConvolutionArrangement::Face f = 0; f < arrangement.face_count(); ++f) {
    if (f == ConvolutionArrangement::unbounded) continue;
    const int number = numbers[f];
    for (auto* layers : {&faces, &notes})
      layers->try_emplace(number, Layer{style::winding_number(number)});
    faces.at(number).region.components.push_back(drawing.outline(f));
    // No room at all: counted among those that don't fit.
    const FreeDisk disk = drawing.free_disk(f).value_or(FreeDisk{});
    notes.at(number).notes.push_back({std::to_string(number), disk.centre, disk.squared_radius});
  }
  std::vector<Layer> result;
  for (auto& [number, layer] : faces) result.push_back(std::move(layer));
  for (Layer& layer : segments) result.push_back(std::move(layer));
  for (auto& [number, layer] : notes) result.push_back(std::move(layer));
  return result;
}

std::string sizes(const ConvolutionArrangement& arrangement) {
  return counted(arrangement.segment_count(), "segment", "segments") + ", " +
         counted(arrangement.face_count(), "face", "faces");
}

}  // namespace

Style style::winding_number(int number) {
  constexpr std::array<const char*, 8> positive = {"#dcebf7", "#b3d4ec", "#86b9de", "#5a9bcb",
                                                   "#3a7cb3", "#235f97", "#14467a", "#0a2f5c"};
  constexpr std::array<const char*, 4> negative = {"#f6d3e4", "#e9a6c9", "#d572a8", "#b23f80"};
  const auto shade = [](const auto& shades, int from_one) {
    return shades[std::min(shades.size(), static_cast<std::size_t>(from_one)) - 1];
  };
  Style style{.name = "winding-number",
              .label = "winding number " + std::to_string(number),
              .place = 10,
              .number = number,
              .fill = number == 0  ? "#fbe0c8"
                      : number > 0 ? shade(positive, number)
                                   : shade(negative, -number)};
  if (number > 4 || number < -3) style.ink = "#ffffff";
  return style;
}

std::string winding_view(const Region& p, const Region& q) {
  std::vector<ConvolutionSegment> all = traced_convolution(p, q);
  std::vector<Layer> drawn = {{style::convolution, {}, segments(all)}};
  const ConvolutionArrangement arrangement(std::move(all));
  return beside_summands(p, q, "Winding numbers of the convolution: " + sizes(arrangement),
                         between_winding_numbers(arrangement, std::move(drawn)));
}

std::string original_view(const Region& p, const Region& q) {
  std::vector<ConvolutionSegment> all = original_convolution(p, q);
  Layer kept{style::reduced_convolution};
  Layer flipped{style::directed_lines("flipped", "flipped segment", 11, "#d55e00", 0.9)};
  for (const ConvolutionSegment& s : all)
    (s.vertex_is_reflex ? flipped : kept).segments.push_back(s.segment);
  const std::size_t of_reflex = flipped.segments.size();
  const ConvolutionArrangement arrangement(std::move(all));
  return beside_summands(
      p, q,
      "Original convolution: " + sizes(arrangement) + ", " + std::to_string(of_reflex) + " flipped",
      between_winding_numbers(arrangement, {std::move(kept), std::move(flipped)}));
}

}  // namespace oplus
