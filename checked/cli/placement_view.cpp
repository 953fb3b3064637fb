// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "checked/arrangement/winding_numbers.hpp"
#include "checked/cli/face_drawing.hpp"
#include "checked/cli/layer_styles.hpp"
#include "checked/cli/view.hpp"
#include "checked/collision/collision_test.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

using Face = ConvolutionArrangement::Face;
using Halfedge = ConvolutionArrangement::Halfedge;
using Vertex = ConvolutionArrangement::Vertex;

/// The edges of both regions, told apart by `edge_of`. Each chain is one translated chain to the
/// arrangement.
std::vector<ConvolutionSegment> both_boundaries(const Region& p, const Region& placed_q) {
  std::vector<ConvolutionSegment> result;
  const auto add = [&](const Region& region, Summand of) {
    const std::vector<Chain> of_region = chains(region);
    for (std::size_t c = 0; c < of_region.size(); ++c) {
      const std::vector<Segment> of_chain = edges(of_region[c]);
      for (std::size_t i = 0; i < of_chain.size(); ++i)
        result.push_back({of_chain[i], {of, {c, i}, {}}, false});
    }
  };
  add(p, Summand::P);
  add(placed_q, Summand::Q);
  return result;
}

/// The arrangement of both boundaries. Winding numbers tell how many of the two regions a face is
/// in.
class Placement {
 public:
  Placement(const Region& p, const Region& placed_q)
      : arrangement_(both_boundaries(p, placed_q)), numbers_(winding_numbers(arrangement_)) {}

  Layer common_interior() const {
    const FaceDrawing drawing(arrangement_);
    Layer layer{style::common_interior};
    for (Face f = 0; f < arrangement_.face_count(); ++f)
      if (is_common(f)) layer.region.components.push_back(drawing.outline(f));
    return layer;
  }

  Layer overlaps() const {
    Layer layer{style::lines("overlap", "", 20, "#c0267e", 4)};
    for (Halfedge h = 0; h < 2 * arrangement_.edge_count(); h += 2)
      if (is_overlap(h)) layer.segments.push_back(arrangement_.geometry(h));
    layer.segments = maximal_segments(std::move(layer.segments));
    layer.style.label = counted(layer.segments.size(), "overlap", "overlaps");
    return layer;
  }

  /// Contacts in a point, by kind; those on overlaps are seen there.
  std::vector<Layer> contacts() const {
    using Sample = Style::Sample;
    Layer crossings{
        {.name = "crossing", .label = "", .place = 21, .sample = Sample::dot, .fill = "#d55e00"}};
    Layer weak{{.name = "weak-intersection",
                .label = "",
                .place = 22,
                .sample = Sample::dot,
                .fill = "#c0267e"}};
    Layer touching{style::touching};
    for (Vertex v = 0; v < arrangement_.vertex_count(); ++v) {
      const Around around = look_around(v);
      if (!around.of_p || !around.of_q || around.overlap) continue;
      Layer& layer = !around.common ? touching : around.straight ? crossings : weak;
      layer.points.push_back(arrangement_.point(v));
    }
    crossings.style.label = counted(crossings.points.size(), "crossing", "crossings");
    weak.style.label = counted(weak.points.size(), "weak intersection", "weak intersections") +
                       " with common interior";
    touching.style.label =
        counted(touching.points.size(), "contact", "contacts") + " without common interior";
    return {touching, weak, crossings};
  }

 private:
  bool is_common(Face f) const { return numbers_[f] == 2; }

  bool runs_along(Halfedge h, Summand of) const {
    const auto is_of = [&](std::uint32_t i) {
      return arrangement_.segment(i).origin.edge_of == of;
    };
    const auto& there = arrangement_.along(h);
    const auto& back = arrangement_.along(ConvolutionArrangement::twin(h));
    return std::any_of(there.begin(), there.end(), is_of) ||
           std::any_of(back.begin(), back.end(), is_of);
  }

  bool is_overlap(Halfedge h) const {
    return runs_along(h, Summand::P) && runs_along(h, Summand::Q);
  }

  /// What there is around a vertex.
  struct Around {
    bool of_p = false;
    bool of_q = false;
    bool overlap = false;
    bool common = false;    ///< interior of both
    bool straight = false;  ///< no edge ends there: an edge of each passes
  };

  Around look_around(Vertex v) const {
    Around around;
    const Point at = arrangement_.point(v);
    around.straight = true;
    const Halfedge first = arrangement_.leaving(v);
    Halfedge h = first;
    do {
      around.of_p = around.of_p || runs_along(h, Summand::P);
      around.of_q = around.of_q || runs_along(h, Summand::Q);
      around.overlap = around.overlap || is_overlap(h);
      around.common = around.common || is_common(arrangement_.face(h));
      for (const Halfedge one : {h, ConvolutionArrangement::twin(h)}) {
        for (const std::uint32_t i : arrangement_.along(one)) {
          const Segment& s = arrangement_.segment(i).segment;
          if (s.source == at || s.target == at) around.straight = false;
        }
      }
      h = arrangement_.clockwise(h);
    } while (h != first);
    return around;
  }

  ConvolutionArrangement arrangement_;
  std::vector<int> numbers_;
};

/// Exactly, or rounded where it would be wider than the drawing.
std::string named(const Point& x) {
  const std::string exact = "x = " + to_string(x);
  constexpr std::size_t longest = 45;
  if (exact.size() <= longest) return exact;
  return "x near (" + approximate(x.x) + ", " + approximate(x.y) + ")";
}

}  // namespace

Panel placement_panel(const Region& p, const Region& q, const Point& x) {
  const Region placed_q = translated(reflected(q), x);
  const Placement placement(p, placed_q);
  const bool meet = hierarchy_collision(p, q)->interiors_meet_at(x);
  Style of_q = labelled(style::summand_q, "\u2212Q + x");
  of_q.name = "placed-q";
  of_q.place = 18;
  // Their outlines once more, since fillings cover them.
  std::vector<Layer> layers = {{style::summand_p, p},       {of_q, placed_q},
                               placement.common_interior(), {style::summand_p, {}, edges(p)},
                               {of_q, {}, edges(placed_q)}, placement.overlaps()};
  for (Layer& contacts : placement.contacts()) layers.push_back(std::move(contacts));
  return {named(x) + ": the interiors " + (meet ? "meet" : "do not meet"), std::move(layers)};
}

std::string placement_view(const Region& p, const Region& q, const Point& x) {
  Panel panel = placement_panel(p, q, x);
  return beside_summands(p, q, std::move(panel.title), std::move(panel.layers));
}

}  // namespace oplus
