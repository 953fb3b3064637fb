// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <utility>

#include "checked/arrangement/winding_numbers.hpp"
#include "checked/cli/face_drawing.hpp"
#include "checked/cli/view.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "reference/definitions/original_convolution.hpp"

namespace oplus {

namespace {

using Kind = Layer::Kind;

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
    for (auto* layers : {&faces, &notes}) {
      Layer& layer = layers->try_emplace(number, Layer{Kind::winding_number}).first->second;
      layer.number = number;
    }
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

std::string winding_view(const Region& p, const Region& q) {
  std::vector<ConvolutionSegment> all = traced_convolution(p, q);
  std::vector<Layer> drawn = {{Kind::convolution, {}, segments(all)}};
  const ConvolutionArrangement arrangement(std::move(all));
  return beside_summands(p, q, "Winding numbers of the convolution: " + sizes(arrangement),
                         between_winding_numbers(arrangement, std::move(drawn)));
}

std::string original_view(const Region& p, const Region& q) {
  std::vector<ConvolutionSegment> all = original_convolution(p, q);
  Layer kept{Kind::reduced_convolution};
  Layer flipped{Kind::flipped};
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
