// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/arrangement/rca.hpp"

#include "checked/arrangement/sum_on_arrangement.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "reference/definitions/mutant.hpp"

namespace oplus {

namespace {

using Halfedge = ConvolutionArrangement::Halfedge;
using Face = ConvolutionArrangement::Face;

/// Left of a segment is the sum (thesis, Observation 2.2.4), so a face of the complement is to the
/// right of all segments around it. This is the filter for orientable loops (Lemma 3.1.2) on faces
/// instead of loops (Section 3.2.3); antennas fail it, too.
bool may_be_in_complement(const ConvolutionArrangement& arrangement, Face face) {
  return arrangement.all_around(face, [&](Halfedge h) { return arrangement.along(h).empty(); });
}

std::vector<Halfedge> boundary_of_faces(const ConvolutionArrangement& arrangement,
                                        const IsHoleRightOf& is_hole_right_of) {
  const auto is_in_complement = [&](Face face) {
    if (face == ConvolutionArrangement::unbounded) return true;
    if (!may_be_in_complement(arrangement, face)) return false;
    if (OPLUS_MUTANT("candidates-need-no-hole-test",
                     "every face with an orientable boundary is taken for a hole"))
      return true;
    if (OPLUS_MUTANT("no-candidate-is-a-hole", "every face is taken for a part of the sum"))
      return false;
    return is_hole_right_of(ConvolutionArrangement::twin(arrangement.boundaries(face)[0]));
  };
  std::vector<Halfedge> boundary;
  for (Face face = 0; face < arrangement.face_count(); ++face) {
    if (!is_in_complement(face)) continue;
    // On the other side of each edge is the sum.
    arrangement.all_around(face, [&](Halfedge h) {
      boundary.push_back(ConvolutionArrangement::twin(h));
      return true;
    });
  }
  return boundary;
}

}  // namespace

ComputedSum rca(const Region& p, const Region& q, Boundary boundary, const EngineOptions& options) {
  return sum_on_arrangement(p, q, boundary, options,
                            {.convolution = traced_reduced_convolution,
                             .boundary = boundary_of_faces,
                             .has_hole_test = true});
}

}  // namespace oplus
