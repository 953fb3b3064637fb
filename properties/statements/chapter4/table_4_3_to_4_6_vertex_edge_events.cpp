// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <set>

#include "properties/runner/registry.hpp"
#include "properties/statements/chapter4/euler_characteristic.hpp"
#include "properties/statements/chapter4/vertex_edge_events.hpp"
#include "properties/statements/directions_around.hpp"
#include "reference/definitions/original_convolution.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

constexpr std::size_t most_events = 10;  // per pair

/// What an event changes.
struct Change {
  int winding_number = 0;
  int components = 0;
  int with_flip_sets = 0;

  friend bool operator==(const Change&, const Change&) = default;
};

Change& operator+=(Change& sum, const TableRow& row) {
  sum.winding_number += row.winding_number;
  sum.components += row.components;
  sum.with_flip_sets += row.with_flip_sets;
  return sum;
}

std::string in_words(const Change& change) {
  return "(" + std::to_string(change.winding_number) + ", " + std::to_string(change.components) +
         ", " + std::to_string(change.with_flip_sets) + ")";
}

/// An open arc of the circle of places, counterclockwise; not the whole circle.
struct Arc {
  std::size_t from;
  std::size_t length;
};

/// How many arcs two arcs have in common. A gap is what is between two neighbouring places.
int common_arcs(const Arc& a, const Arc& b, const DirectionsAround& around) {
  const auto is_common = [&](std::size_t gap) {
    return around.turn(a.from, gap) < a.length && around.turn(b.from, gap) < b.length;
  };
  int starts = 0;
  for (std::size_t gap = 0; gap < around.places(); ++gap) {
    const bool goes_on = is_common((gap + around.places() - 1) % around.places());
    // Two common gaps side by side are one arc: the place between them is an end of neither, or a
    // gap beside that end would not be common.
    if (is_common(gap) && !goes_on) ++starts;
  }
  return starts;
}

/// A vertex and an edge of the other summand, as choices of directions, each directed as its own
/// summand has it.
struct LocalEvent {
  std::size_t in, out, edge;
  Summand edge_of;
};

/// The number of components of the intersection of the sector at the vertex and the half plane at
/// the edge, both open, when the vertex is just off the edge, in the half plane or not. All
/// directions are those of P and -Q; the places of Q's directions keep the turn of the tie rule.
int local_components(const LocalEvent& event, bool vertex_in_half_plane,
                     const DirectionsAround& around) {
  if (vertex_in_half_plane) return 1;  // the half plane sees the whole sector from the vertex
  const Summand of = other(event.edge_of);
  const auto turned = [&](std::size_t i, Summand whose) {  // as P or -Q has it
    return around.place(whose == Summand::P ? i : around.opposite(i), whose);
  };
  const std::size_t out = turned(event.out, of), half = around.places() / 2;
  const std::size_t back = (turned(event.in, of) + half) % around.places();
  // The line passes the vertex at a small distance: far along a common direction is common.
  return common_arcs({out, around.turn(out, back)}, {turned(event.edge, event.edge_of), half},
                     around);
}

/// How the winding number changes from right to left of the middle of a segment of this direction:
/// that of a triangle, of which it is one side.
int change_across(const Vector& direction) {
  const Rational near(1, 1000);
  const Point away = {1000, 0};
  const std::vector<Segment> triangle = {
      {-direction, direction}, {direction, away}, {away, -direction}};
  return winding_number({-near, 0}, triangle) - winding_number({near, 0}, triangle);
}

Change seen_at(const LocalEvent& event, const VertexEdgeEvent& named,
               const DirectionsAround& around) {
  // Seen from -Q moving to the left, a vertex of P comes from an edge's left side; a vertex of -Q
  // comes from the right side of P's edge. Interior is on the left of an upward edge.
  const bool before = (event.edge_of == Summand::P) != named.edge_upwards;
  const Vector& edge = around[event.edge];
  const bool is_flipped = named.vertex_is_reflex && !named.in_convolution;
  const bool is_kept = !named.vertex_is_reflex && named.in_convolution;
  return {named.in_convolution ? change_across(edge) : 0,
          local_components(event, !before, around) - local_components(event, before, around),
          is_flipped ? change_across(-edge)
          : is_kept  ? change_across(edge)
                     : 0};
}

Enumeration enumerate() {
  const DirectionsAround directions(4);
  Enumeration result;
  std::set<const TableRow*> rows;
  for (const Summand edge_of : {Summand::P, Summand::Q}) {
    for_each_choice<3>(directions.size(), [&](const std::array<std::size_t, 3>& choice) {
      const LocalEvent event{choice[0], choice[1], choice[2], edge_of};
      const Vector& edge = directions[event.edge];
      if (event.out == directions.opposite(event.in) || sign(edge.y) == 0) return;
      const Corner corner{directions[event.in], directions[event.out]};
      const VertexEdgeEvent named = event_of(edge, edge_of, corner);
      const TableRow& row = row_of(named);
      Change printed;
      printed += row;
      const Change seen = seen_at(event, named, directions);
      ++result.cases;
      rows.insert(&row);
      if (!result.failure.empty() || seen == printed) return;
      result.failure = "an edge " + to_string(edge) + " of " + (edge_of == Summand::P ? "P" : "Q") +
                       " passing a vertex with edges " + to_string(corner.in) + " and " +
                       to_string(corner.out) + " changes winding number, components and winding " +
                       "number with flip sets by " + in_words(seen) + ", and the tables say " +
                       in_words(printed);
    });
  }
  if (result.failure.empty() && rows.size() != table_rows().size())
    result.failure = "a row of the tables has no case in the enumeration";
  return result;
}

/// A placement at which events happen that all lie on one line, and how far to its right and left
/// there is no other.
struct Placement {
  Point x;
  std::vector<ConvolutionSegment> events;
  Rational clear;
};

/// The distance along the horizontal line through x from x to s, which does not contain x; none if
/// they do not meet.
std::optional<Rational> distance(const Point& x, const Segment& s) {
  const auto& [low, high] = std::minmax(s.source.y, s.target.y);
  if (x.y < low || high < x.y) return {};
  if (low == high) return std::min(abs(s.source.x - x.x), abs(s.target.x - x.x));
  const Vector d = direction_of(s);
  return abs(Rational(s.source.x + (x.y - s.source.y) / d.y * d.x - x.x));
}

/// The events of moving through x, inside s; none unless all are inside segments parallel to s.
std::optional<Placement> placement_at(const Point& x, const ConvolutionSegment& s,
                                      const std::vector<ConvolutionSegment>& sums) {
  Placement result{x, {}, 1};
  for (const ConvolutionSegment& other : sums) {
    if (!lies_on(x, other.segment)) {
      const std::optional<Rational> apart = distance(x, other.segment);
      if (apart) result.clear = std::min(result.clear, *apart);
      continue;
    }
    if (x == other.segment.source || x == other.segment.target ||
        sign(cross(direction_of(s.segment), direction_of(other.segment))) != 0)
      return {};
    result.events.push_back(other);
  }
  return result;
}

Change seen_at(const Placement& placement, const std::vector<Segment>& convolution,
               const std::vector<Segment>& original, const IntersectionCounter& counter) {
  const Vector step = {placement.clear / 2, 0};
  const Point before = placement.x + step, after = placement.x - step;
  return {winding_number(after, convolution) - winding_number(before, convolution),
          counter.at(after).euler_characteristic() - counter.at(before).euler_characteristic(),
          winding_number(after, original) - winding_number(before, original)};
}

Change printed_for(const Placement& placement, const std::vector<Chain>& of_p,
                   const std::vector<Chain>& of_q) {
  Change sum;
  for (const auto& [segment, origin, corner] : placement.events) {
    const std::vector<Chain>& of_vertex = origin.edge_of == Summand::P ? of_q : of_p;
    sum += row_of(event_of(direction_of(segment), origin.edge_of,
                           corner_at(of_vertex[origin.vertex.chain], origin.vertex.vertex)));
  }
  return sum;
}

Outcome check(const Summands& summands) {
  const auto& [p, q] = summands;
  const std::vector<Chain> of_p = chains(p), of_q = chains(q);
  const std::vector<ConvolutionSegment> sums = vertex_edge_sum(p, q);
  const std::vector<Segment> all = segments(convolution(p, q)),
                             original = segments(original_convolution(p, q));
  const IntersectionCounter counter(summands);
  const std::size_t looked_at = std::min(sums.size(), most_events);
  Outcome outcome;
  for (std::size_t k = 0; k < looked_at; ++k) {
    const ConvolutionSegment& s = sums[k * sums.size() / looked_at];
    const Vector along = direction_of(s.segment);
    if (sign(along.y) == 0) {
      ++outcome.counts["horizontal segments, left out"];
      continue;
    }
    const auto placement = placement_at(s.segment.source + Rational(13, 31) * along, s, sums);
    if (!placement) {
      ++outcome.counts["points of several directions, left out"];
      continue;
    }
    const Change seen = seen_at(*placement, all, original, counter);
    const Change printed = printed_for(*placement, of_p, of_q);
    ++outcome.counts["events"];
    if (placement->events.size() > 1) ++outcome.counts["of these several at once"];
    if (seen == printed) continue;
    return outcome.fail(
        "moving left through " + to_string(placement->x) +
            " changes winding number, components and winding number with flip sets by " +
            in_words(seen) + ", and the tables say " + in_words(printed),
        placement->x);
  }
  return outcome;
}

const Registered registered({
    .id = "table-4.3-to-4.6",
    .sources = pairs_with_holes().sources,
    .promises = {{"holes", 15}, {"reflex vertices", 10}, {"parallel edges", 40}},
    .kills = {"acute-vertex-is-reflex", "flip-set-keeps-its-direction", "reflex-turns-clockwise",
              "tangent-set-without-ties"},
    .cases = 100,
    .check = check,
    .enumerate = enumerate,
});

}  // namespace

}  // namespace oplus
