// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <set>

#include "properties/runner/registry.hpp"
#include "properties/statements/directions_around.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/tangent_set.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

std::string in_words(const Direction& d) {
  return std::string(d.of == Summand::P ? "P" : "Q") + "'s (" + d.vector.x.get_str() + ", " +
         d.vector.y.get_str() + ")";
}

Enumeration enumerate() {
  const DirectionsAround around(4);  // three, and the axis from which the code measures
  Enumeration result;
  const auto direction = [&](std::size_t place) {
    return Direction{around[place / 2], place % 2 == 0 ? Summand::P : Summand::Q};
  };
  for_each_choice<3>(around.places(), [&](const std::array<std::size_t, 3>& places) {
    const auto [d, from, to] = places;
    ++result.cases;
    const bool is_between =
        around.turn(from, d) > 0 && around.turn(from, d) < around.turn(from, to);
    if (!result.failure.empty() ||
        counterclockwise_between(direction(d), direction(from), direction(to)) == is_between)
      return;
    result.failure = "from " + in_words(direction(from)) + " to " + in_words(direction(to)) + ", " +
                     in_words(direction(d)) + (is_between ? " is not" : " is") + " found between";
  });
  return result;
}

const Registered definition_2_2_7({
    .id = "definition-2.2.7",
    .kills = {"ties-go-the-other-way", "left-and-right-are-one-direction", "angles-grow-clockwise",
              "between-is-on-the-other-arc"},
    .enumerate = enumerate,
});

/// The tangent set of a vertex by Definition 2.1.13, computed with skew products only and without a
/// tie rule: the directions strictly between those of its two edges. A vertex inside a straight
/// line is like any other point of a segment: its tangent set is that one direction.
class TangentSet {
 public:
  explicit TangentSet(const Corner& corner)
      : corner_(corner), turn_(sign(cross(corner.in, corner.out))) {}

  bool contains(const Vector& d) const {
    const int after_in = sign(cross(corner_.in, d));
    const int before_out = sign(cross(d, corner_.out));
    if (turn_ > 0) return after_in > 0 && before_out > 0;
    if (turn_ < 0) return after_in > 0 || before_out > 0;
    return after_in == 0 && sign(dot(corner_.in, d)) > 0;
  }

  bool starts_with(const Vector& d) const { return same(corner_.in, d); }
  bool ends_with(const Vector& d) const { return same(corner_.out, d); }

  /// Two arcs of a circle meet iff one contains the start of the other, or both start in the same
  /// direction.
  bool meets(const TangentSet& other) const {
    if (turn_ == 0) return other.contains(corner_.in);
    if (other.turn_ == 0) return contains(other.corner_.in);
    return contains(other.corner_.in) || other.contains(corner_.in) ||
           same(corner_.in, other.corner_.in);
  }

 private:
  static bool same(const Vector& u, const Vector& v) {
    return sign(cross(u, v)) == 0 && sign(dot(u, v)) > 0;
  }

  Corner corner_;
  int turn_;
};

std::vector<std::vector<TangentSet>> tangent_sets(const Region& region) {
  std::vector<std::vector<TangentSet>> all;
  for (const Chain& chain : chains(region)) {
    all.emplace_back();
    for (std::size_t i = 0; i < chain.size(); ++i) all.back().emplace_back(corner_at(chain, i));
  }
  return all;
}

/// Both definitions, as sets of directed pieces of the vertex-edge sum and of ends of pieces.
class TwoDefinitions {
 public:
  explicit TwoDefinitions(const Summands& summands)
      : of_p_(tangent_sets(summands.p)), of_q_(tangent_sets(summands.q)) {
    const std::vector<ConvolutionSegment> all = vertex_edge_sum(summands.p, summands.q);
    const std::vector<std::vector<Segment>> pieces = cut_at_intersections(segments(all));
    std::set<Origin> kept;
    for (const ConvolutionSegment& s : convolution(summands.p, summands.q)) kept.insert(s.origin);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (kept.count(all[i].origin) > 0) {
        add(pieces[i], first_pieces, first_points);
        first_points.insert({all[i].segment.source, all[i].segment.target});
      }
      const auto& [edge_of, edge, v] = all[i].origin;
      const TangentSet& at_vertex = (edge_of == Summand::P ? of_q_ : of_p_)[v.chain][v.vertex];
      const Vector d = direction_of(all[i].segment);
      const bool from_start = at_vertex.starts_with(d), to_end = at_vertex.ends_with(d);
      // The sum of two edges of equal direction is that of either one and the other's two ends, and
      // has the point where these two segments meet or overlap inside.
      if (at_vertex.contains(d) || from_start || to_end)
        add(pieces[i], second_pieces, second_points);
      if (from_start) second_points.insert(all[i].segment.source);
      if (to_end) second_points.insert(all[i].segment.target);
    }
    add_vertex_pairs(summands);
  }

  std::set<Segment> first_pieces, second_pieces;
  std::set<Point> first_points, second_points;

 private:
  /// Without the ends of the segment: the second definition has them as sums of vertices.
  static void add(const std::vector<Segment>& of_segment, std::set<Segment>& pieces,
                  std::set<Point>& points) {
    pieces.insert(of_segment.begin(), of_segment.end());
    for (std::size_t i = 1; i < of_segment.size(); ++i) points.insert(of_segment[i].source);
  }

  void add_vertex_pairs(const Summands& summands) {
    const std::vector<Chain> chains_of_p = chains(summands.p), chains_of_q = chains(summands.q);
    for (std::size_t a = 0; a < of_p_.size(); ++a) {
      for (std::size_t b = 0; b < of_q_.size(); ++b) {
        for (std::size_t i = 0; i < of_p_[a].size(); ++i) {
          for (std::size_t j = 0; j < of_q_[b].size(); ++j)
            if (of_p_[a][i].meets(of_q_[b][j]))
              second_points.insert(chains_of_p[a][i] + chains_of_q[b][j]);
        }
      }
    }
  }

  std::vector<std::vector<TangentSet>> of_p_, of_q_;
};

template <typename Value>
std::optional<Value> missing_in(const std::set<Value>& found, const std::set<Value>& all) {
  for (const Value& value : found)
    if (all.count(value) == 0) return value;
  return std::nullopt;
}

Outcome check_sums_of_tangent_sets(const Summands& summands) {
  const TwoDefinitions both(summands);
  Outcome outcome;
  outcome.counts = {{"pieces of segments", both.second_pieces.size()},
                    {"ends of pieces", both.second_points.size()}};
  const auto fail = [&](const std::string& what, const std::string& definition, const Point& at) {
    if (outcome.kind == Outcome::Kind::holds)
      outcome.fail(what + " is in the convolution by Definition " + definition + " only", at);
  };
  const auto compare_pieces = [&](const std::set<Segment>& a, const std::set<Segment>& b,
                                  const std::string& which) {
    if (const auto s = missing_in(a, b))
      fail("the segment from " + to_string(s->source) + " to " + to_string(s->target), which,
           midpoint(s->source, s->target));
  };
  compare_pieces(both.first_pieces, both.second_pieces, "2.2.7");
  compare_pieces(both.second_pieces, both.first_pieces, "2.2.8");
  if (const auto x = missing_in(both.first_points, both.second_points))
    fail("the point " + to_string(*x), "2.2.7", *x);
  if (const auto x = missing_in(both.second_points, both.first_points))
    fail("the point " + to_string(*x), "2.2.8", *x);
  return outcome;
}

const Registered definition_2_2_8(small_mixture(),
                                  {.id = "definition-2.2.8",
                                   .kills = {"reflex-turns-clockwise", "tangent-set-without-ties",
                                             "tie-rule-depends-on-who-asks"},
                                   .cases = 300,
                                   .check = check_sums_of_tangent_sets});

}  // namespace

}  // namespace oplus
