// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/hole_test.hpp"
#include "checked/cli/face_drawing.hpp"
#include "checked/cli/view.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "reference/io/counted.hpp"
#include "reference/pictures/styles.hpp"

namespace oplus {

std::string faces_view(const Region& p, const Region& q) {
  using Halfedge = ConvolutionArrangement::Halfedge;

  const std::vector<ConvolutionSegment> reduced = traced_reduced_convolution(p, q);
  const ConvolutionArrangement arrangement(reduced);
  const FaceDrawing drawing(arrangement);
  const std::unique_ptr<HoleTest> test = hierarchy_hole_test(p, q);
  Layer no_candidates{
      {.name = "no-candidate", .label = "no candidate", .place = 12, .fill = "#e9ecee"}};
  Layer fallen{{.name = "candidate-in-sum",
                .label = "candidate in the sum",
                .place = 13,
                .fill = "#d9c3e6"}};
  Layer holes{style::holes};
  for (ConvolutionArrangement::Face f = 0; f < arrangement.face_count(); ++f) {
    if (f == ConvolutionArrangement::unbounded) continue;
    const bool is_candidate =
        arrangement.all_around(f, [&](Halfedge h) { return arrangement.along(h).empty(); });
    const bool is_hole =
        is_candidate && test->is_hole_right_of(arrangement.geometry(
                            ConvolutionArrangement::twin(arrangement.boundaries(f)[0])));
    Layer& layer = is_hole ? holes : is_candidate ? fallen : no_candidates;
    layer.region.components.push_back(drawing.outline(f));
  }
  const std::size_t of_holes = holes.region.components.size();
  const std::size_t candidates = of_holes + fallen.region.components.size();
  return beside_summands(p, q,
                         "Reduced convolution: " + counted(reduced.size(), "segment", "segments") +
                             ", " + counted(arrangement.face_count(), "face", "faces") + ", " +
                             counted(candidates, "candidate", "candidates") + ", " +
                             counted(of_holes, "hole", "holes"),
                         {std::move(no_candidates),
                          std::move(fallen),
                          std::move(holes),
                          {style::reduced_convolution, {}, segments(reduced)}});
}

}  // namespace oplus
