// SPDX-License-Identifier: MIT
#include "checked/verify/verify.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "checked/verify/collision_verdicts.hpp"
#include "checked/verify/overlay.hpp"
#include "checked/verify/sum_by_convex_parts.hpp"
#include "checked/verify/witness.hpp"
#include "reference/chains/near_point.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/sorted_without_copies.hpp"
#include "reference/definitions/squared_distance.hpp"
#include "reference/definitions/verdicts_differ.hpp"
#include "reference/io/counted.hpp"
#include "reference/io/writing.hpp"
#include "reference/pictures/picture.hpp"

namespace oplus {

namespace {

/// What a chain has that changes nothing.
struct Oddities {
  std::size_t repeated = 0;   ///< vertices equal to the one before
  std::size_t collinear = 0;  ///< vertices inside a straight line
};

/// Vertices of chains, which must stay where they are.
using Corners = std::vector<NearPoint>;

bool is_less(const NearPoint& a, const NearPoint& b) { return compare(a, b) < 0; }
bool are_equal(const NearPoint& a, const NearPoint& b) { return compare(a, b) == 0; }

Corners without_oddities(const Chain& chain, Oddities& oddities) {
  Corners distinct;
  distinct.reserve(chain.size());
  for (const Point& p : chain) {
    const NearPoint here = near_point(p);
    if (!distinct.empty() && are_equal(distinct.back(), here))
      ++oddities.repeated;
    else
      distinct.push_back(here);
  }
  while (distinct.size() > 1 && are_equal(distinct.back(), distinct.front())) {
    distinct.pop_back();
    ++oddities.repeated;
  }
  Corners corners;
  corners.reserve(distinct.size());
  for (std::size_t i = 0; i < distinct.size(); ++i) {
    const NearPoint& before = distinct[previous(i, distinct.size())];
    const NearPoint& after = distinct[next(i, distinct.size())];
    if (orientation(before, distinct[i], after) == 0 &&
        sign(dot(*distinct[i].exact - *before.exact, *after.exact - *distinct[i].exact)) >
            0)  // the tip of a spike is no such vertex
      ++oddities.collinear;
    else
      corners.push_back(distinct[i]);
  }
  return corners;
}

bool touches_itself(Corners corners) {
  std::sort(corners.begin(), corners.end(), is_less);
  return std::adjacent_find(corners.begin(), corners.end(), are_equal) != corners.end();
}

/// What the chains of two regions have in common that are equal but for the order of components, of
/// holes, and of the vertices of each chain.
struct NormalForm {
  struct Component {
    Corners outer;
    std::vector<Corners> holes;
  };

  explicit NormalForm(const Region& region) {
    const auto normal = [&](const Chain& chain) {
      Corners corners = without_oddities(chain, oddities);
      chains_that_touch_themselves += touches_itself(corners);
      to_smallest_rotation(corners);
      return corners;
    };
    for (const oplus::Component& component : region.components) {
      components.push_back({normal(component.outer), {}});
      std::vector<Corners>& holes = components.back().holes;
      for (const Chain& hole : component.holes) holes.push_back(normal(hole));
      std::sort(holes.begin(), holes.end(), chain_is_less);
    }
    std::ranges::sort(components, chain_is_less, &Component::outer);
  }

  bool operator==(const NormalForm& other) const {
    const auto are_equal_chains = [](const Corners& a, const Corners& b) {
      return std::equal(a.begin(), a.end(), b.begin(), b.end(), are_equal);
    };
    return std::equal(components.begin(), components.end(), other.components.begin(),
                      other.components.end(), [&](const Component& a, const Component& b) {
                        return are_equal_chains(a.outer, b.outer) &&
                               std::equal(a.holes.begin(), a.holes.end(), b.holes.begin(),
                                          b.holes.end(), are_equal_chains);
                      });
  }

  std::vector<Component> components;
  Oddities oddities;
  std::size_t chains_that_touch_themselves = 0;

 private:
  static bool chain_is_less(const Corners& a, const Corners& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), is_less);
  }

  static void to_smallest_rotation(Corners& chain) {
    const auto smallest = std::min_element(chain.begin(), chain.end(), is_less);
    if (smallest == chain.end()) return;
    std::rotate(chain.begin(), smallest, chain.end());
    const Corners all = chain;
    for (auto i = all.begin(); i != all.end(); ++i) {
      if (i == all.begin() || !are_equal(*i, all[0])) continue;
      Corners other(i, all.end());
      other.insert(other.end(), all.begin(), i);
      if (chain_is_less(other, chain)) chain = std::move(other);
    }
  }
};

std::vector<std::string> notes_of(const NormalForm& given) {
  const Oddities& oddities = given.oddities;
  std::vector<std::string> notes;
  if (oddities.repeated > 0)
    notes.push_back(counted(oddities.repeated, "vertex repeats", "vertices repeat") +
                    " the one before");
  if (oddities.collinear > 0)
    notes.push_back(counted(oddities.collinear, "vertex is", "vertices are") +
                    " inside a straight line");
  if (const std::size_t touching = given.chains_that_touch_themselves; touching > 0)
    notes.push_back(counted(touching, "chain touches itself", "chains touch themselves"));
  return notes;
}

std::string from_to(const Segment& s) {
  return "from " + to_string(s.source) + " to " + to_string(s.target);
}

/// The low-dimensional features in which a given sum differs where the regular sums do not.
class FeatureReasons {
 public:
  FeatureReasons(const ClaimedSum& given, const PlanarSet& right, const Overlay& overlay,
                 Boundary boundary)
      : right_(right),
        overlay_(overlay),
        boundary_(boundary),
        given_edges_(maximal_segments(given.dangling_edges)),
        given_vertices_(sorted_without_copies(given.isolated_vertices)),
        on_given_edges_(given.dangling_edges),
        on_right_edges_(right.dangling_edges),
        cutting_(features_and_edges(given, right, overlay)) {}

  std::vector<Reason> find() {
    for (const Segment& e : right_.dangling_edges) {
      for (const Segment& piece : cut_where_met(e, cutting_)) {
        const Point middle = midpoint(piece.source, piece.target);
        if (!lies_on_one(middle, on_given_edges_) && is_inside_given(middle))
          add(ReasonKind::missing_dangling_edge, middle, false, true,
              squared_length(direction_of(piece)),
              "the dangling edge " + from_to(e) + " is missing" + part_of(piece, e));
      }
    }
    for (const Segment& e : given_edges_) {
      for (const Segment& piece : cut_where_met(e, cutting_)) {
        const Point middle = midpoint(piece.source, piece.target);
        if (lies_on_one(middle, on_right_edges_)) continue;
        add(ReasonKind::additional_dangling_edge, middle, is_in_sum(middle), false,
            squared_length(direction_of(piece)),
            "the line string " + from_to(e) + " is no dangling edge of the sum" +
                part_of(piece, e));
      }
    }
    for (const Point& p : right_.isolated_vertices) {
      if (!is_one_of(p, given_vertices_) && !lies_on_one(p, on_given_edges_) && is_inside_given(p))
        add(ReasonKind::missing_isolated_vertex, p, false, true, 0,
            "the isolated vertex " + to_string(p) + " is missing");
    }
    for (const Point& p : given_vertices_) {
      if (!is_one_of(p, right_.isolated_vertices))
        add(ReasonKind::additional_isolated_vertex, p, is_in_sum(p), false, 0,
            "the point " + to_string(p) + " is no isolated vertex of the sum");
    }
    return std::move(reasons_);
  }

 private:
  static std::vector<Segment> features_and_edges(const ClaimedSum& given, const PlanarSet& right,
                                                 const Overlay& overlay) {
    std::vector<Segment> all = given.dangling_edges;
    for (const std::vector<Segment>& more : {overlay.boundary_of_given(), edges(right)})
      all.insert(all.end(), more.begin(), more.end());
    for (const std::vector<Point>* points : {&given.isolated_vertices, &right.isolated_vertices})
      for (const Point& p : *points) all.push_back({p, p});
    return all;
  }

  static bool is_one_of(const Point& p, const std::vector<Point>& sorted) {
    return std::binary_search(sorted.begin(), sorted.end(), p);
  }

  bool is_inside_given(const Point& p) const {
    return overlay_.locate(p).of_given == Location::inside;
  }

  /// Requires: it is no isolated vertex of the sum.
  bool is_in_sum(const Point& p) const {
    const Location where = overlay_.locate(p).of_right;
    if (boundary_ == Boundary::closed) return where != Location::outside;
    return where == Location::inside && !lies_on_one(p, on_right_edges_);
  }

  static std::string part_of(const Segment& piece, const Segment& whole) {
    return squared_length(direction_of(piece)) == squared_length(direction_of(whole))
               ? ""
               : ", " + from_to(piece);
  }

  void add(ReasonKind kind, const Point& witness, bool in_sum, bool in_given, Rational size,
           std::string detail) {
    reasons_.push_back({kind, witness, in_sum, in_given, std::move(size), std::move(detail)});
  }

  const PlanarSet& right_;
  const Overlay& overlay_;
  Boundary boundary_;
  std::vector<Segment> given_edges_;
  std::vector<Point> given_vertices_;
  SegmentTree on_given_edges_;
  SegmentTree on_right_edges_;
  SegmentTree cutting_;  ///< membership in both sets is constant between these
  std::vector<Reason> reasons_;
};

/// Exactly, or rounded where the exact value is too long to read.
std::string legible(const Rational& value) {
  const std::string exact = to_string(value);
  return exact.size() <= 24 ? exact : "about " + approximate(value);
}

/// What a reason is called, and, of those of faces, what the face is and how the sums differ there.
struct Words {
  const char* name;
  const char* face = "";
  const char* difference = "";
};

const Words& words_for(ReasonKind kind) {
  static constexpr std::array<Words, 15> words = {{
      {"missing hole", "a hole", " of the sum is filled"},
      {"additional hole", "a hole", " is not a hole of the sum"},
      {"missing component", "a component", " of the sum is missing"},
      {"additional component", "a component", " is outside the sum"},
      {"components joined", "a place", " outside the sum joins components of it"},
      {"component split", "a place", " is left out, which splits a component of the sum"},
      {"in the sum but not given", "a place", " of the sum is left out"},
      {"given but not in the sum", "a place", " is outside the sum"},
      {"wrong orientation"},
      {"unsimple boundary"},
      {"wrong kind of boundary"},
      {"missing dangling edge"},
      {"additional dangling edge"},
      {"missing isolated vertex"},
      {"additional isolated vertex"},
  }};
  return words.at(static_cast<std::size_t>(kind));
}

/// Segments on which all points lie that are inside the closed sum and not in the open one: the convolution
/// (thesis, Theorem 2.2.10), computed where it is needed.
class Exceptional {
 public:
  Exceptional(const Region& p, const Region& q) : p_(p), q_(q) {}

  const std::vector<Segment>& places() {
    if (!places_) places_ = segments(convolution(p_, q_));
    return *places_;
  }

 private:
  const Region& p_;
  const Region& q_;
  std::optional<std::vector<Segment>> places_;
};

std::vector<Reason> face_reasons(const Overlay& overlay, const CollisionVerdicts& verdicts,
                                 Exceptional& exceptional) {
  std::vector<Reason> reasons;
  for (auto& [reason, boundary] : overlay.differences()) {
    reason.witness = point_of_face(boundary, {});
    if (verdicts.interiors_meet_by_definition_at(reason.witness) != reason.in_sum) {
      // A point inside the closed sum may be on a dangling edge.
      if (reason.in_sum) reason.witness = point_of_face(boundary, exceptional.places());
      if (!reason.in_sum || !verdicts.interiors_meet_by_definition_at(reason.witness))
        throw VerdictsDiffer("convex parts and the collision test differ at " +
                             to_string(reason.witness));
    }
    const Words& words = words_for(reason.kind);
    reason.detail = words.face + (" of area " + legible(reason.size / 2)) + words.difference;
    reasons.push_back(std::move(reason));
  }
  return reasons;
}

std::vector<Reason> orientation_reasons(const ClaimedSum& given, const Overlay& overlay) {
  std::vector<Reason> reasons;
  for (const ClaimedChain& chain : claimed_chains(given)) {
    const int turn = sign_of_area(*chain.vertices);
    if (turn == 0 || (turn > 0) == (chain.hole == 0) ||
        OPLUS_MUTANT("chains-may-run-either-way",
                     "verify accepts clockwise outer chains and counterclockwise holes"))
      continue;
    const Point witness = midpoint((*chain.vertices)[0], (*chain.vertices)[1]);
    reasons.push_back({ReasonKind::wrong_orientation, witness,
                       overlay.locate(witness).of_right != Location::outside, true,
                       abs(twice_area_inside(edges(*chain.vertices))),
                       describe(chain) + (turn > 0 ? " runs counterclockwise, not clockwise"
                                                   : " runs clockwise, not counterclockwise")});
  }
  return reasons;
}

std::vector<Reason> unsimple_reasons(const Overlay& overlay) {
  std::vector<Reason> reasons;
  for (const Overlay::Unsimple& u : overlay.unsimple_pieces()) {
    const Point middle = midpoint(u.piece.source, u.piece.target);
    const std::string chain = "a chain runs " + from_to(u.piece);
    std::string detail;
    if (u.piece.source == u.piece.target)
      detail = "a chain is only the point " + to_string(middle) + ", and bounds nothing";
    else if (!u.is_boundary)
      detail =
          chain + ", where the given set is on " + (u.in_given ? "both sides" : "neither side");
    else if (u.times > 1)
      detail = "chains run " + std::to_string(u.times) + " times " + from_to(u.piece);
    else
      detail = chain + " the wrong way: it crosses itself or another";
    reasons.push_back({ReasonKind::unsimple_boundary, middle,
                       overlay.locate(middle).of_right != Location::outside,
                       u.in_given || u.is_boundary, squared_length(direction_of(u.piece)),
                       std::move(detail)});
  }
  return reasons;
}

void append(std::vector<Reason>& all, std::vector<Reason> some) {
  std::sort(some.begin(), some.end(), [](const Reason& a, const Reason& b) {
    const int by_size = cmp(a.size, b.size);
    return by_size != 0 ? by_size > 0 : a.witness < b.witness;
  });
  std::move(some.begin(), some.end(), std::back_inserter(all));
}

template <typename Sum>
bool has_features(const Sum& sum) {
  return !sum.dangling_edges.empty() || !sum.isolated_vertices.empty();
}

bool same_features(const ClaimedSum& given, const PlanarSet& right) {
  return maximal_segments(given.dangling_edges) == right.dangling_edges &&
         sorted_without_copies(given.isolated_vertices) == right.isolated_vertices;
}

/// The first edges of chains.
std::vector<Segment> first_edges(const std::vector<const Chain*>& chains) {
  std::vector<Segment> result;
  for (const Chain* chain : chains) {
    if (chain->size() < 3) throw VerdictsDiffer("convex parts leave a chain that bounds nothing");
    result.push_back({(*chain)[0], (*chain)[1]});
  }
  return result;
}

/// How far from such an edge others are looked for.
double room_around(const Box& edge) { return edge.size(); }

/// The edges of chains, but for those that have no such room to all first edges; and which the first ones are.
struct EdgesNearFirstOnes {
  EdgesNearFirstOnes(const std::vector<const Chain*>& chains, const SegmentTree& first_edges) {
    for (const Chain* chain : chains) {
      first.push_back(edges.size());
      IntervalPoint source = interval(chain->front());
      for (std::size_t i = 0; i < chain->size(); ++i) {
        const Point& end = (*chain)[next(i, chain->size())];
        const IntervalPoint target = interval(end);
        const Box box = box_of(IntervalSegment{source, target});
        bool is_near = false;
        first_edges.look_for(
            0,
            [&](const Box& some) {
              return meet(enlarged(some, 2 * room_around(some)), box) ? 0 : SegmentTree::nothing;
            },
            [&](std::size_t) {
              is_near = true;
              return -1;
            });
        if (is_near) edges.push_back({(*chain)[i], end});
        source = target;
      }
    }
  }

  std::vector<Segment> edges;
  std::vector<std::size_t> first;
};

/// A second verdict: a point on either side of each chain of the sum, by the collision test. The points
/// are on no edge of the sum, but one inside it may be on a dangling edge, of which a closed sum says
/// nothing: then another point decides, which is on none.
void ask_collision_test(const PlanarSet& sum, Boundary boundary, const CollisionVerdicts& verdicts,
                        Exceptional& exceptional) {
  std::vector<const Chain*> chains;
  for (const std::vector<Chain>* of_sum : {&sum.outer, &sum.holes})
    for (const Chain& chain : *of_sum) chains.push_back(&chain);
  const SegmentTree first_ones(first_edges(chains));
  auto [near, first] = EdgesNearFirstOnes(chains, first_ones);
  near.insert(near.end(), sum.dangling_edges.begin(), sum.dangling_edges.end());
  for (const Point& p : sum.isolated_vertices) near.push_back({p, p});
  const SegmentTree tree(std::move(near));
  for (std::size_t c = 0; c < chains.size(); ++c) {
    for (const bool left : {true, false}) {
      Point x;
      bool meet = false;
      for (int attempt = 0; attempt < 4; ++attempt) {
        x = attempt < 3 ? point_near(tree, first[c], left, attempt,
                                     room_around(box_of(first_ones.certified(c))))
                        : point_left_of(first_ones[c], edges(sum), exceptional.places());
        meet = verdicts.interiors_meet_at(x);
        const bool may_be_exceptional = left && !meet && boundary == Boundary::closed;
        if (!may_be_exceptional) break;
      }
      if (meet != left)
        throw VerdictsDiffer("convex parts and the collision test differ at " + to_string(x));
    }
  }
}

PlanarSet decided_sum(const Region& p, const Region& q, Boundary boundary,
                      Exceptional& exceptional) {
  PlanarSet sum = sum_by_convex_parts(p, q, boundary);
  ask_collision_test(sum, boundary, CollisionVerdicts(p, q), exceptional);
  return sum;
}

Verdict verdict(PlanarSet computed, const Region& p, const Region& q, Boundary boundary,
                const ClaimedSum& sum, Exceptional& exceptional) {
  Verdict result;
  result.right = std::move(computed);
  const PlanarSet& right = result.right;
  const NormalForm given_normal(sum.region);
  result.notes = notes_of(given_normal);
  const Region region = region_of(right);
  if (given_normal == NormalForm(region) && same_features(sum, right)) return result;

  const Overlay overlay(sum, right);
  const CollisionVerdicts verdicts(p, q);
  append(result.reasons, face_reasons(overlay, verdicts, exceptional));
  append(result.reasons, orientation_reasons(sum, overlay));
  append(result.reasons, unsimple_reasons(overlay));
  const bool same_chains = result.reasons.empty();
  append(result.reasons, FeatureReasons(sum, right, overlay, boundary).find());

  if (same_chains && !result.reasons.empty()) {
    const bool open = boundary == Boundary::open;
    const bool is_the_other = open ? has_features(right) && !has_features(sum)
                                   : same_features(sum, sum_by_convex_parts(p, q, Boundary::open));
    if (is_the_other) {
      Reason other = result.reasons.front();
      other.kind = ReasonKind::wrong_boundary;
      other.size = 0;
      other.detail =
          open ? "it is the sum of the closed regions" : "it is the sum of the regions' interiors";
      result.reasons.push_back(std::move(other));
    }
  }
  if (!result.reasons.empty() && result.reasons.front().in_sum) {
    const Point& x = result.reasons.front().witness;
    if (const std::optional<Point> common = verdicts.common_point_at(x))
      result.addends = Addends{*common, x - *common};
  }
  return result;
}

}  // namespace

std::string describe(ReasonKind kind) { return words_for(kind).name; }

Verdict verify(const Region& p, const Region& q, Boundary boundary, const ClaimedSum& sum) {
  Exceptional exceptional(p, q);
  return verdict(decided_sum(p, q, boundary, exceptional), p, q, boundary, sum, exceptional);
}

Verdict verify(const Region& p, const Region& q, Boundary boundary, const PlanarSet& sum) {
  return verify(p, q, boundary, given(sum));
}

PlanarSet sum_by_definition(const Region& p, const Region& q, Boundary boundary) {
  Exceptional exceptional(p, q);
  return decided_sum(p, q, boundary, exceptional);
}

}  // namespace oplus
