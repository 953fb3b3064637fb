// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "checked/sweep/strands.hpp"
#include "reference/definitions/convolution.hpp"

namespace oplus {

/// The arrangement of convolution segments as a doubly connected edge list of plain indices: an
/// edge's two halfedges are 2i, from its lexicographically smaller end, and 2i + 1; each has its
/// face to the left. Each edge knows the segments it is a part of.
class ConvolutionArrangement {
 public:
  using Vertex = std::uint32_t;
  using Halfedge = std::uint32_t;
  using Face = std::uint32_t;

  explicit ConvolutionArrangement(std::vector<ConvolutionSegment> segments);
  ConvolutionArrangement(ConvolutionArrangement&&) noexcept;
  ~ConvolutionArrangement();

  std::size_t segment_count() const { return segments_.size(); }
  std::size_t vertex_count() const { return leaving_.size(); }
  std::size_t edge_count() const { return halfedges_.size() / 2; }
  std::size_t face_count() const { return boundaries_.size(); }

  static constexpr Face unbounded = 0;

  static Halfedge twin(Halfedge h) { return h ^ 1U; }
  Vertex source(Halfedge h) const { return halfedges_[h].source; }
  Vertex target(Halfedge h) const { return source(twin(h)); }
  Face face(Halfedge h) const { return halfedges_[h].face; }

  /// The halfedge after h around its face.
  Halfedge next(Halfedge h) const { return halfedges_[h].next; }
  /// The halfedge that leaves the source of h next, clockwise from h.
  Halfedge clockwise(Halfedge h) const { return next(twin(h)); }
  /// One of the halfedges that leave a vertex. Every vertex is on an edge.
  Halfedge leaving(Vertex v) const { return leaving_[v]; }

  /// A halfedge of each boundary of a face; a face with a hole has several. Only the unbounded face
  /// of no segments at all has none.
  const std::vector<Halfedge>& boundaries(Face f) const { return boundaries_[f]; }

  /// Whether `holds` for all halfedges around a face.
  template <typename Holds>
  bool all_around(Face f, Holds holds) const {
    for (const Halfedge first : boundaries(f)) {
      Halfedge h = first;
      do {
        if (!holds(h)) return false;
        h = next(h);
      } while (h != first);
    }
    return true;
  }

  /// The segments that run in the direction of h along it; those against it are along its twin.
  const std::vector<std::uint32_t>& along(Halfedge h) const {
    const Strand& strand = strands_[this->strand(h)];
    return (h & 1U) == 0 ? strand.along : strand.against;
  }
  const ConvolutionSegment& segment(std::uint32_t index) const { return segments_[index]; }

  /// Edges of equal strand are parts of the same segments.
  std::uint32_t strand(Halfedge h) const { return strand_of_edge_[h / 2]; }

  /// Exact coordinates, evaluated when asked for.
  Point point(Vertex v) const;
  Segment geometry(Halfedge h) const { return {point(source(h)), point(target(h))}; }

 private:
  struct HalfedgeRecord {
    Vertex source;
    Halfedge next;
    Face face;
  };
  struct Points;

  std::vector<ConvolutionSegment> segments_;
  std::vector<Strand> strands_;
  std::vector<HalfedgeRecord> halfedges_;
  std::vector<std::uint32_t> strand_of_edge_;
  std::vector<Halfedge> leaving_;
  std::vector<std::vector<Halfedge>> boundaries_;
  std::unique_ptr<Points> points_;
};

}  // namespace oplus
