// SPDX-License-Identifier: MIT
#include "checked/verify/overlay.hpp"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "checked/verify/witness.hpp"
#include "reference/definitions/cells.hpp"
#include "reference/definitions/cut_at_intersections.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/sorted_without_copies.hpp"
#include "reference/definitions/winding_number.hpp"

namespace oplus {

namespace {

/// How often a chain, or the right sum, runs along a piece: forth counts 1, back -1.
using Turns = std::map<std::size_t, int>;

/// What runs along a piece. The right sum is called by a number that no chain has.
struct Uses {
  Turns turns;
  std::size_t chains_forth = 0;
  std::size_t chains_back = 0;
};

/// The connected parts of a graph, by the number of a node each.
template <typename Connected>
std::vector<std::size_t> parts(std::size_t nodes, const std::vector<Cells::Edge>& edges,
                               Connected connected) {
  boost::disjoint_sets_with_storage<> sets(nodes);
  for (const Cells::Edge& e : edges)
    if (connected(e.left_face, e.right_face)) sets.union_set(e.left_face, e.right_face);
  std::vector<std::size_t> result(nodes);
  for (std::size_t i = 0; i < nodes; ++i) result[i] = sets.find_set(i);
  return result;
}

/// The winding numbers of all chains around each face, zeros left out.
std::vector<Turns> winding_numbers(const Cells& cells, const std::vector<Uses>& uses) {
  std::vector<std::vector<std::size_t>> edges_of(cells.faces.size());
  for (std::size_t i = 0; i < cells.edges.size(); ++i) {
    edges_of[cells.edges[i].left_face].push_back(i);
    edges_of[cells.edges[i].right_face].push_back(i);
  }
  std::vector<Turns> around(cells.faces.size());
  std::vector<bool> seen(cells.faces.size(), false);
  std::vector<std::size_t> open = {cells.unbounded_face};
  seen[cells.unbounded_face] = true;
  while (!open.empty()) {
    const std::size_t face = open.back();
    open.pop_back();
    for (const std::size_t i : edges_of[face]) {
      const Cells::Edge& e = cells.edges[i];
      const bool to_left = e.right_face == face;
      const std::size_t other = to_left ? e.left_face : e.right_face;
      if (seen[other]) continue;
      seen[other] = true;
      around[other] = around[face];
      for (const auto& [chain, turns] : uses[i].turns) {
        int& number = around[other][chain];
        number += to_left ? turns : -turns;
        if (number == 0) around[other].erase(chain);
      }
      open.push_back(other);
    }
  }
  return around;
}

Rational twice_area_inside(const std::vector<Segment>& boundary) {
  Rational twice = 0;
  for (const Segment& e : boundary) twice += cross(e.source, e.target);
  return twice;
}

}  // namespace

Overlay::Overlay(const GivenSum& given, const MinkowskiSum& right, std::vector<Segment> avoided)
    : avoided_(std::move(avoided)) {
  const std::vector<GivenChain> chains = given_chains(given);
  const std::size_t of_right = chains.size();
  std::vector<Segment> segments;
  std::vector<std::size_t> chain_of;
  std::vector<Point> points;  // chains without length
  const auto add = [&](const Chain& chain, std::size_t number) {
    const std::size_t before = segments.size();
    for (const Segment& e : edges(chain)) {
      if (e.source == e.target) continue;
      segments.push_back(e);
      chain_of.push_back(number);
    }
    if (segments.size() == before &&
        !OPLUS_MUTANT("points-need-not-bound", "verify overlooks a chain that is a point"))
      points.push_back(chain[0]);
  };
  for (std::size_t c = 0; c < chains.size(); ++c) add(*chains[c].vertices, c);
  for (const std::vector<Chain>* of_sum : {&right.outer, &right.holes})
    for (const Chain& chain : *of_sum) add(chain, of_right);
  const std::vector<std::vector<Segment>> pieces = cut_at_intersections(segments);
  const Cells cells = cells_of_pieces(pieces);
  std::map<Segment, std::size_t> number_of;
  for (std::size_t i = 0; i < cells.edges.size(); ++i) number_of[cells.edges[i].segment] = i;
  std::vector<Uses> uses(cells.edges.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::size_t chain = chain_of[i];
    bool turned = false;  // as what its chain is to be
    if (chain != of_right)
      turned = (sign(twice_area(*chains[chain].vertices)) < 0) != (chains[chain].hole != 0);
    for (const Segment& piece : pieces[i]) {
      const bool forth = piece.source < piece.target;
      Uses& of_edge = uses[number_of.at(forth ? piece : reversed(piece))];
      of_edge.turns[chain] += forth ? 1 : -1;
      if (chain != of_right) ++(forth != turned ? of_edge.chains_forth : of_edge.chains_back);
    }
  }

  const std::vector<Turns> around = winding_numbers(cells, uses);
  faces_.resize(cells.faces.size());
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    Face& face = faces_[f];
    face.boundary = cells.faces[f];
    std::set<std::size_t> in_outer;
    std::set<std::size_t> in_hole;
    for (const auto& [chain, turns] : around[f]) {
      if (chain == of_right)
        face.in_right = turns > 0;
      else
        (chains[chain].hole == 0 ? in_outer : in_hole).insert(chains[chain].component);
    }
    face.in_given = std::any_of(in_outer.begin(), in_outer.end(),
                                [&](std::size_t c) { return !in_hole.contains(c); });
  }
  const auto same = [&](bool Face::*in) {
    return [this, in](std::size_t a, std::size_t b) { return faces_[a].*in == faces_[b].*in; };
  };
  const auto of_given = parts(faces_.size(), cells.edges, same(&Face::in_given));
  const auto of_sum = parts(faces_.size(), cells.edges, same(&Face::in_right));
  const auto of_both = parts(faces_.size(), cells.edges, [&](std::size_t a, std::size_t b) {
    return faces_[a].in_given == faces_[b].in_given && faces_[a].in_right == faces_[b].in_right;
  });
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    faces_[f].part_of_given = of_given[f];
    faces_[f].part_of_right = of_sum[f];
    faces_[f].difference = of_both[f];
  }

  for (std::size_t i = 0; i < cells.edges.size(); ++i) {
    const Cells::Edge& e = cells.edges[i];
    neighbours_.emplace_back(e.left_face, e.right_face);
    const bool left = faces_[e.left_face].in_given;
    const bool right_side = faces_[e.right_face].in_given;
    if (left != right_side) boundary_of_given_.push_back(left ? e.segment : reversed(e.segment));
    const std::size_t times = uses[i].chains_forth + uses[i].chains_back;
    const bool is_right_way = left ? uses[i].chains_back == 0 : uses[i].chains_forth == 0;
    if (times > 0 && (left == right_side || times > 1 || !is_right_way))
      unsimple_.push_back({e.segment, left, left != right_side, times});
  }
  for (const Point& p : sorted_without_copies(std::move(points))) {
    const bool on_boundary = lies_on_one(p, boundary_of_given_);
    const bool inside = std::any_of(faces_.begin(), faces_.end(), [&](const Face& face) {
      return face.in_given &&
             (lies_on_one(p, face.boundary) || winding_number(p, face.boundary) > 0);
    });
    unsimple_points_.push_back({{p, p}, inside && !on_boundary, on_boundary, 1});
  }
}

std::vector<Reason> Overlay::differing_faces() const {
  std::map<std::size_t, std::vector<std::size_t>> together;
  for (std::size_t f = 0; f < faces_.size(); ++f)
    if (faces_[f].in_given != faces_[f].in_right) together[faces_[f].difference].push_back(f);
  std::vector<Reason> reasons;
  for (const auto& [part, faces] : together) reasons.push_back(reason_for(faces));
  return reasons;
}

Reason Overlay::reason_for(const std::vector<std::size_t>& faces) const {
  const Face& one = faces_[faces[0]];
  Reason reason{};
  reason.in_sum = one.in_right;
  reason.in_given = one.in_given;
  Rational largest = -1;
  std::size_t at = 0;
  for (const std::size_t f : faces) {
    const Rational twice = twice_area_inside(faces_[f].boundary);
    reason.size += twice;
    if (twice <= largest) continue;
    largest = twice;
    at = f;
  }
  reason.witness = point_of_face(faces_[at].boundary, avoided_);

  const auto is_all_of = [&](std::size_t Face::*part) {
    const auto size = static_cast<std::size_t>(std::count_if(
        faces_.begin(), faces_.end(), [&](const Face& face) { return face.*part == one.*part; }));
    return size == faces.size();
  };
  // The parts of the one set that the difference connects, or would connect: those beside it.
  const auto parts_beside = [&](std::size_t Face::*part) {
    std::set<std::size_t> beside;
    for (const auto& [a, b] : neighbours_) {
      for (const auto& [in, out] : {std::pair(a, b), {b, a}}) {
        if (faces_[in].difference != one.difference) continue;
        if (faces_[out].in_given && faces_[out].in_right) beside.insert(faces_[out].*part);
      }
    }
    return beside.size();
  };
  if (reason.in_given) {
    reason.kind = is_all_of(&Face::part_of_right)          ? ReasonKind::missing_hole
                  : is_all_of(&Face::part_of_given)        ? ReasonKind::additional_component
                  : parts_beside(&Face::part_of_right) > 1 ? ReasonKind::joined_components
                                                           : ReasonKind::not_in_sum;
  } else {
    reason.kind = is_all_of(&Face::part_of_right)          ? ReasonKind::missing_component
                  : is_all_of(&Face::part_of_given)        ? ReasonKind::additional_hole
                  : parts_beside(&Face::part_of_given) > 1 ? ReasonKind::split_component
                                                           : ReasonKind::not_in_given;
  }
  return reason;
}

std::vector<Overlay::Unsimple> Overlay::unsimple_pieces() const {
  // Those of one sort, in line and connected, as one.
  std::map<std::tuple<bool, bool, std::size_t>, std::vector<Segment>> sorts;
  for (const Unsimple& u : unsimple_)
    sorts[{u.in_given, u.is_boundary, u.times}].push_back(u.piece);
  std::vector<Unsimple> result = unsimple_points_;
  for (auto& [sort, pieces] : sorts)
    for (const Segment& s : maximal_segments(std::move(pieces)))
      result.push_back({s, std::get<0>(sort), std::get<1>(sort), std::get<2>(sort)});
  return result;
}

}  // namespace oplus
