// SPDX-License-Identifier: MIT
#include "checked/verify/overlay.hpp"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <iterator>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include "reference/chains/near_point.hpp"
#include "reference/chains/swept_cells.hpp"
#include "reference/definitions/cells.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/pairwise_sum.hpp"
#include "reference/definitions/sorted_without_copies.hpp"

namespace oplus {

namespace {

/// That a chain, or the right sum, runs along a piece: forth counts 1, back -1. The right sum is called by a number
/// that no chain has.
struct Turns {
  std::size_t chain;
  int turns;
};

/// The connected parts of a graph, by the number of a node each.
template <typename Edge, typename Connected>
std::vector<std::size_t> parts(std::size_t nodes, const std::vector<Edge>& edges,
                               Connected connected) {
  boost::disjoint_sets_with_storage<> sets(nodes);
  for (const Edge& e : edges)
    if (connected(e.left_face, e.right_face)) sets.union_set(e.left_face, e.right_face);
  std::vector<std::size_t> result(nodes);
  for (std::size_t i = 0; i < nodes; ++i) result[i] = sets.find_set(i);
  return result;
}

/// In which sets the faces are that a walk is in, which passes from face to face.
class Membership {
 public:
  explicit Membership(const std::vector<ClaimedChain>& chains)
      : chains_(chains), around_(chains.size() + 1, 0) {
    for (const ClaimedChain& chain : chains)
      if (chain.component >= outer_.size()) outer_.resize(chain.component + 1, 0);
    holes_.resize(outer_.size(), 0);
  }

  /// Passes an edge to its left, or to its right.
  void pass(std::span<const Turns> along, bool to_left) {
    for (const auto& [chain, turns] : along) {
      const bool was_inside = around_[chain] != 0;
      around_[chain] += to_left ? turns : -turns;
      const bool is_inside = around_[chain] != 0;
      if (chain == chains_.size() || was_inside == is_inside) continue;
      const std::size_t component = chains_[chain].component;
      within_ -= is_within(component);
      std::size_t& count = (chains_[chain].hole == 0 ? outer_ : holes_)[component];
      is_inside ? ++count : --count;
      within_ += is_within(component);
    }
  }

  bool in_given() const { return within_ > 0; }
  bool in_right() const { return around_.back() > 0; }

 private:
  bool is_within(std::size_t component) const {
    return outer_[component] > 0 && holes_[component] == 0;
  }

  const std::vector<ClaimedChain>& chains_;
  std::vector<int> around_;         ///< winding numbers of the chains, and of the right sum
  std::vector<std::size_t> outer_;  ///< of each component, how many outer chains wind around,
  std::vector<std::size_t> holes_;  ///< and how many of its holes
  std::size_t within_ = 0;          ///< the number of components that have the face inside
};

/// Calls `see(face)` for each face when the walk is in it, from the unbounded one on, and `pass(i, to_left)` when it passes
/// edge i: each twice at most.
template <typename Edge, typename EdgesOf, typename Pass, typename See>
void walk_through_faces(std::size_t faces, const std::vector<Edge>& edges, const EdgesOf& edges_of,
                        const Pass& pass, const See& see) {
  struct Visit {
    std::uint32_t face;
    std::uint32_t next;        // of the face's edges
    std::uint32_t entered_by;  // an edge, or none
  };
  constexpr auto none = static_cast<std::uint32_t>(-1);
  std::vector<bool> seen(faces, false);
  std::vector<Visit> way = {{0, 0, none}};
  seen[0] = true;
  see(0U);
  while (!way.empty()) {
    Visit& here = way.back();
    const std::span<const std::uint32_t> around = edges_of(here.face);
    if (here.next == around.size()) {
      if (here.entered_by != none)
        pass(here.entered_by, edges[here.entered_by].right_face == here.face);
      way.pop_back();
      continue;
    }
    const std::uint32_t i = around[here.next++];
    const bool to_left = edges[i].right_face == here.face;
    const std::uint32_t other = to_left ? edges[i].left_face : edges[i].right_face;
    if (seen[other]) continue;
    seen[other] = true;
    pass(i, to_left);
    see(other);
    way.push_back({other, 0, i});
  }
}

}  // namespace

Rational twice_area_inside(const std::vector<Segment>& boundary) {
  PairwiseSum twice;
  for (const Segment& e : boundary) twice.add(cross(e.source, e.target));
  return twice.total();
}

Overlay::Overlay(const ClaimedSum& given, const PlanarSet& right) {
  const std::vector<ClaimedChain> chains = claimed_chains(given);
  const std::size_t of_right = chains.size();
  SweptEdges swept;
  std::vector<std::uint32_t> chain_of;
  std::vector<Point> points;  // chains without length
  const auto add = [&](const Chain& chain, std::size_t number) {
    swept.add(chain);
    chain_of.resize(swept.edges.size(), static_cast<std::uint32_t>(number));
    if (std::ranges::count(chain, chain[0]) == std::ssize(chain) &&
        !OPLUS_MUTANT("points-need-not-bound", "verify overlooks a chain that is a point"))
      points.push_back(chain[0]);
  };
  for (std::size_t c = 0; c < chains.size(); ++c) add(*chains[c].vertices, c);
  for (const std::vector<Chain>* of_sum : {&right.outer, &right.holes})
    for (const Chain& chain : *of_sum) add(chain, of_right);
  NumberedCells cells =
      numbered_cells(swept, [&](const SweptPlace& place) { places_.push_back(place.point); });
  std::ranges::sort(cells.pieces, [](const NumberedCells::Piece& a, const NumberedCells::Piece& b) {
    return std::tie(a.from, a.to, a.edge) < std::tie(b.from, b.to, b.edge);
  });

  std::vector<bool> turned;  // as what a chain is to be
  for (const ClaimedChain& chain : chains)
    turned.push_back((sign_of_area(*chain.vertices) < 0) != (chain.hole != 0));
  std::vector<Turns> turns;                  // along the pieces
  std::vector<std::uint32_t> first_of_edge;  // of these; then their number
  for (const NumberedCells::Piece& piece : cells.pieces) {
    if (edges_.empty() || edges_.back().source != piece.from || edges_.back().target != piece.to) {
      first_of_edge.push_back(static_cast<std::uint32_t>(turns.size()));
      edges_.push_back({piece.from, piece.to, piece.above, piece.below});
    }
    turns.push_back({chain_of[piece.edge], swept.runs_right(piece.edge) ? 1 : -1});
  }
  first_of_edge.push_back(static_cast<std::uint32_t>(turns.size()));
  const auto along = [&](std::size_t edge) {
    return std::span<const Turns>(turns).subspan(first_of_edge[edge],
                                                 first_of_edge[edge + 1] - first_of_edge[edge]);
  };

  faces_.resize(cells.face_count + std::size_t{1});  // one more, which has no edges
  cells = {};
  for (const Edge& e : edges_)
    for (const std::uint32_t f : {e.left_face, e.right_face})
      ++faces_[f + std::size_t{1}].first_edge;
  for (std::size_t f = 1; f < faces_.size(); ++f) faces_[f].first_edge += faces_[f - 1].first_edge;
  edges_of_faces_.resize(2 * edges_.size());
  std::vector<std::uint32_t> next;
  for (const Face& face : faces_) next.push_back(face.first_edge);
  for (std::uint32_t i = 0; i < edges_.size(); ++i)
    for (const std::uint32_t f : {edges_[i].left_face, edges_[i].right_face})
      edges_of_faces_[next[f]++] = i;

  Membership membership(chains);
  walk_through_faces(
      faces_.size() - 1, edges_, [&](std::uint32_t f) { return edges_of(f); },
      [&](std::uint32_t edge, bool to_left) { membership.pass(along(edge), to_left); },
      [&](std::uint32_t f) {
        faces_[f].in_given = membership.in_given();
        faces_[f].in_right = membership.in_right();
      });
  const auto same = [&](bool Face::*in) {
    return [this, in](std::size_t a, std::size_t b) { return faces_[a].*in == faces_[b].*in; };
  };
  const auto of_given = parts(faces_.size(), edges_, same(&Face::in_given));
  const auto of_sum = parts(faces_.size(), edges_, same(&Face::in_right));
  const auto of_both = parts(faces_.size(), edges_, [&](std::size_t a, std::size_t b) {
    return faces_[a].in_given == faces_[b].in_given && faces_[a].in_right == faces_[b].in_right;
  });
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    faces_[f].part_of_given = static_cast<std::uint32_t>(of_given[f]);
    faces_[f].part_of_right = static_cast<std::uint32_t>(of_sum[f]);
    faces_[f].difference = static_cast<std::uint32_t>(of_both[f]);
  }

  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Edge& e = edges_[i];
    const bool left = faces_[e.left_face].in_given;
    const bool right_side = faces_[e.right_face].in_given;
    if (left != right_side) boundary_of_given_.push_back(left ? segment(e) : reversed(segment(e)));
    std::size_t forth = 0, back = 0;
    for (const Turns& one : along(i))
      if (one.chain != of_right) ++((one.turns > 0) != turned[one.chain] ? forth : back);
    const std::size_t times = forth + back;
    const bool is_right_way = left ? back == 0 : forth == 0;
    if (times > 0 && (left == right_side || times > 1 || !is_right_way))
      unsimple_.push_back({segment(e), left, left != right_side, times});
  }
  for (const Point& p : sorted_without_copies(std::move(points))) {
    const Location where = locate(p).of_given;
    unsimple_points_.push_back({{p, p}, where == Location::inside, where == Location::boundary, 1});
  }
}

std::span<const std::uint32_t> Overlay::edges_of(std::size_t face) const {
  return std::span(edges_of_faces_)
      .subspan(faces_[face].first_edge, faces_[face + 1].first_edge - faces_[face].first_edge);
}

std::vector<Segment> Overlay::boundary_of(std::size_t face) const {
  std::vector<Segment> result;
  std::size_t first = 0;
  std::optional<std::uint32_t> before;
  for (const std::uint32_t i : edges_of(face)) {
    const Edge& e = edges_[i];
    const bool forth = e.left_face == face && std::exchange(before, i) != i;
    result.push_back(forth ? segment(e) : reversed(segment(e)));
    if (!forth) continue;
    const Segment &start = result[first], &other = result.back();
    // The lowest one to the right.
    if (start.target < start.source ||
        (start.source == other.source && orientation(start.source, start.target, other.target) < 0))
      first = result.size() - 1;
  }
  std::swap(result[0], result[first]);
  return result;
}

Rational Overlay::twice_area_of(std::size_t face) const {
  PairwiseSum twice;
  for (const std::uint32_t i : edges_of(face)) {
    const Edge& e = edges_[i];
    if (e.left_face == e.right_face) continue;
    const bool forth = e.left_face == face;
    twice.add(cross(places_[forth ? e.source : e.target], places_[forth ? e.target : e.source]));
  }
  return twice.total();
}

std::vector<Overlay::Difference> Overlay::differences() const {
  // Faces by the connected part that they are in, and the parts of the sets beside a difference, which
  // it connects or would connect: one of them, and whether there is another.
  struct Part {
    std::vector<std::size_t> faces;
    std::optional<std::size_t> given_beside, right_beside;
    bool are_more_given = false, are_more_right = false;
  };
  std::vector<Part> parts(faces_.size());
  std::vector<std::size_t> size_in_given(faces_.size(), 0), size_in_right(faces_.size(), 0);
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    ++size_in_given[faces_[f].part_of_given];
    ++size_in_right[faces_[f].part_of_right];
    if (faces_[f].in_given != faces_[f].in_right) parts[faces_[f].difference].faces.push_back(f);
  }
  const auto see = [](std::size_t part, std::optional<std::size_t>& beside, bool& are_more) {
    if (!beside) beside = part;
    are_more = are_more || *beside != part;
  };
  for (const Edge& e : edges_) {
    for (const auto& [in, out] :
         {std::pair(e.left_face, e.right_face), {e.right_face, e.left_face}}) {
      const Face& other = faces_[out];
      if (!other.in_given || !other.in_right) continue;
      Part& part = parts[faces_[in].difference];
      see(other.part_of_given, part.given_beside, part.are_more_given);
      see(other.part_of_right, part.right_beside, part.are_more_right);
    }
  }

  std::vector<Difference> result;
  for (const Part& part : parts) {
    if (part.faces.empty()) continue;
    const Face& one = faces_[part.faces[0]];
    Difference difference{};
    Reason& reason = difference.reason;
    reason.in_sum = one.in_right;
    reason.in_given = one.in_given;
    Rational largest = -1;
    std::size_t of_largest = 0;
    PairwiseSum sizes;
    for (const std::size_t f : part.faces) {
      Rational size = twice_area_of(f);
      sizes.add(size);
      if (size <= largest) continue;
      largest = std::move(size);
      of_largest = f;
    }
    difference.boundary = boundary_of(of_largest);
    reason.size = sizes.total();
    const bool is_all_of_given = size_in_given[one.part_of_given] == part.faces.size();
    const bool is_all_of_right = size_in_right[one.part_of_right] == part.faces.size();
    if (reason.in_given) {
      reason.kind = is_all_of_right       ? ReasonKind::missing_hole
                    : is_all_of_given     ? ReasonKind::additional_component
                    : part.are_more_right ? ReasonKind::joined_components
                                          : ReasonKind::not_in_sum;
    } else {
      reason.kind = is_all_of_right       ? ReasonKind::missing_component
                    : is_all_of_given     ? ReasonKind::additional_hole
                    : part.are_more_given ? ReasonKind::split_component
                                          : ReasonKind::not_in_given;
    }
    result.push_back(std::move(difference));
  }
  return result;
}

std::optional<Point> Overlay::common_point() const {
  for (std::size_t f = 0; f < faces_.size(); ++f)
    if (faces_[f].in_given && faces_[f].in_right) return point_inside(boundary_of(f));
  return std::nullopt;
}

const Overlay::Face& Overlay::face_around(const Point& p) const {
  const std::optional<Crossing> first = first_to_the_right(p, *tree_);
  if (!first) return faces_[0];
  const Edge& e = edges_[first->segment];
  return faces_[first->runs_up ? e.left_face : e.right_face];
}

Overlay::Place Overlay::locate(const Point& p) const {
  if (!tree_) {
    std::vector<Segment> segments;
    for (const Edge& e : edges_) segments.push_back(segment(e));
    tree_.emplace(std::move(segments));
  }
  std::vector<const Face*> around;
  for (const std::size_t i : near({p, p}, *tree_)) {
    if (!lies_on(p, (*tree_)[i])) continue;
    around.push_back(&faces_[edges_[i].left_face]);
    around.push_back(&faces_[edges_[i].right_face]);
  }
  if (around.empty()) around.push_back(&face_around(p));
  const auto location = [&](bool Face::*in) {
    const auto inside = static_cast<std::size_t>(
        std::count_if(around.begin(), around.end(), [&](const Face* face) { return face->*in; }));
    return inside == 0               ? Location::outside
           : inside == around.size() ? Location::inside
                                     : Location::boundary;
  };
  return {location(&Face::in_given), location(&Face::in_right)};
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
