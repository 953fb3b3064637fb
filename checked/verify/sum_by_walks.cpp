// SPDX-License-Identifier: MIT
#include "checked/verify/sum_by_walks.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "reference/arithmetic/interval.hpp"
#include "reference/chains/touching_points.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/sorted_without_copies.hpp"

namespace oplus {

namespace {

/// A segment by the numbers of its ends.
struct Track {
  std::size_t source;
  std::size_t target;
  bool counts;  ///< is of the convolution; others are walked along, and nothing else
};

/// Where another track meets the one that is walked along.
struct Event {
  std::size_t track;
  std::ptrdiff_t place = -1;           ///< the number of the point, or -1 where two tracks cross
  int turn = 0;                        ///< what it adds to the winding number just to the right
  int same = 0;                        ///< what it adds to the number of tracks that run along,
  int against = 0;                     ///< and that run along in the other direction
  double low = 0, high = 0;            ///< how far along the track, from 0 to 1, is between these
  std::optional<Rational> exact = {};  ///< the same, once it was needed
};

/// What the walks find.
struct Found {
  std::vector<Segment> boundary;         ///< the sum to the left, its complement to the right
  std::vector<Segment> may_be_dangling;  ///< the sum on both sides
  std::set<Point> may_be_isolated;
};

class Walks {
 public:
  Walks(const std::vector<Segment>& convolution, const std::vector<Segment>& more, bool open)
      : open_(open) {
    for (const std::vector<Segment>* of : {&convolution, &more}) {
      for (const Segment& s : *of) {
        points_.push_back(s.source);
        points_.push_back(s.target);
      }
    }
    points_ = sorted_without_copies(std::move(points_));
    const auto number = [&](const Point& p) {
      return static_cast<std::size_t>(std::lower_bound(points_.begin(), points_.end(), p) -
                                      points_.begin());
    };
    for (const Segment& s : convolution)
      tracks_.push_back({number(s.source), number(s.target), true});
    for (const Segment& s : more) tracks_.push_back({number(s.source), number(s.target), false});
    for (const Point& p : points_) near_.push_back(interval(p));
    side_.resize(points_.size());
  }

  Found walk_all() {
    for (std::size_t i = 0; i < tracks_.size(); ++i) walk(i);
    found_.boundary = sorted_without_copies(std::move(found_.boundary));
    return std::move(found_);
  }

 private:
  const Point& source() const { return points_[walked_.source]; }
  const Point& target() const { return points_[walked_.target]; }

  /// Where a point on the track's line is: before the track's source (negative), there (zero), or
  /// after. Points are numbered in lexicographic order.
  int beyond(std::size_t point, std::size_t end) const {
    if (point == end) return 0;
    return (point > end) == (walked_.target > walked_.source) ? 1 : -1;
  }

  /// On which side of the track's line each point is: 1 on the left, -1 on the right, 0 on it.
  void find_sides() {
    const IntervalPoint from = near_[walked_.source];
    const IntervalPoint to = near_[walked_.target];
    for (std::size_t i = 0; i < points_.size(); ++i) {
      side_[i] = static_cast<std::int8_t>(orientation_in_doubles(from, to, near_[i]));
      if (side_[i] != 0) continue;
      const std::optional<int> side = orientation(from, to, near_[i]);
      side_[i] =
          static_cast<std::int8_t>(side ? *side : orientation(source(), target(), points_[i]));
    }
  }

  /// On which side of a track's line an end of the one that is walked along is.
  int side_of_track(std::size_t point, const Track& t) const {
    if (const int side = orientation_in_doubles(near_[t.source], near_[t.target], near_[point]))
      return side;
    const std::optional<int> side = orientation(near_[t.source], near_[t.target], near_[point]);
    return side ? *side : orientation(points_[t.source], points_[t.target], points_[point]);
  }

  /// How far along the track an event is, exactly.
  const Rational& how_far(Event& e) const {
    if (!e.exact) {
      const Vector along = target() - source();
      if (e.place >= 0) {
        const Vector to = points_[static_cast<std::size_t>(e.place)] - source();
        e.exact = sign(along.x) != 0 ? Rational(to.x / along.x) : Rational(to.y / along.y);
      } else {
        const Track& t = tracks_[e.track];
        const Vector across = points_[t.target] - points_[t.source];
        e.exact = cross(points_[t.source] - source(), across) / cross(along, across);
      }
    }
    return *e.exact;
  }

  void estimate(Event& e) const {
    const IntervalPoint& from = near_[walked_.source];
    const IntervalPoint along = near_[walked_.target] - from;
    Interval far;
    if (e.place >= 0) {
      const IntervalPoint to = near_[static_cast<std::size_t>(e.place)] - from;
      const bool steep = along.x.low <= 0 && along.x.high >= 0;
      far = steep ? to.y / along.y : to.x / along.x;
    } else {
      const Track& t = tracks_[e.track];
      const IntervalPoint across = near_[t.target] - near_[t.source];
      far = cross(near_[t.source] - from, across) / cross(along, across);
    }
    e.low = far.low;
    e.high = far.high;
  }

  /// Negative, zero or positive.
  int compare(Event& a, Event& b) const {
    if (a.place >= 0 && a.place == b.place) return 0;
    if (a.high < b.low) return -1;
    if (b.high < a.low) return 1;
    return cmp(how_far(a), how_far(b));
  }

  Point place_of(Event& e) const {
    if (e.place >= 0) return points_[static_cast<std::size_t>(e.place)];
    return source() + how_far(e) * (target() - source());
  }

  /// What another track, not in line, adds to the winding number to the right of the track's line as
  /// the walk passes it: crossed by its part on the right, from its right side to its left or back.
  static int turn_by(int side_of_source, int side_of_target) {
    if (side_of_target < 0) return 1;
    if (OPLUS_MUTANT("walks-count-what-is-on-the-left",
                     "walks count segments whose part to the left ends on the line") &&
        side_of_source > 0)
      return -1;
    return side_of_source < 0 ? -1 : 0;
  }

  void meet(std::size_t number, const Track& t) {
    const int from = side_[t.source];
    const int to = side_[t.target];
    if (from * to > 0) return;
    if (from == 0 && to == 0) {
      run_along(number, t);
      return;
    }
    Event e{.track = number, .turn = t.counts ? turn_by(from, to) : 0};
    int after_source = 0;
    int after_target = 0;
    if (from == 0 || to == 0) {
      const std::size_t at = from == 0 ? t.source : t.target;
      e.place = static_cast<std::ptrdiff_t>(at);
      after_source = beyond(at, walked_.source);
      if (after_source > 0) after_target = beyond(at, walked_.target);
    } else {
      // t runs to the left of the line iff to > 0; then what is before it is on its left.
      after_source = to * side_of_track(walked_.source, t);
      if (after_source > 0) after_target = to * side_of_track(walked_.target, t);
      if (after_source == 0) e.place = static_cast<std::ptrdiff_t>(walked_.source);
      if (after_source > 0 && after_target == 0)
        e.place = static_cast<std::ptrdiff_t>(walked_.target);
    }
    if (after_source <= 0) right_ += e.turn;
    if (after_source > 0 && after_target < 0)
      events_.push_back(std::move(e));
    else if (open_ && after_source == 0)
      at_source_.push_back(number);
    else if (open_ && after_source > 0 && after_target == 0)
      at_target_.push_back(number);
  }

  void run_along(std::size_t number, const Track& t) {
    const bool same = (t.target > t.source) == (walked_.target > walked_.source);
    const std::size_t first = same ? t.source : t.target;
    const std::size_t last = same ? t.target : t.source;
    if (open_ && beyond(last, walked_.source) == 0) at_source_.push_back(number);
    if (open_ && beyond(first, walked_.target) == 0) at_target_.push_back(number);
    if (beyond(last, walked_.source) <= 0 || beyond(first, walked_.target) >= 0) return;
    const auto event = [&](std::size_t at, int step) {
      return Event{.track = number,
                   .place = static_cast<std::ptrdiff_t>(at),
                   .same = same && t.counts ? step : 0,
                   .against = !same && t.counts ? step : 0};
    };
    if (beyond(first, walked_.source) > 0) {
      events_.push_back(event(first, 1));
    } else {
      same_ += same && t.counts;
      against_ += !same && t.counts;
      if (open_) at_source_.push_back(number);
    }
    if (beyond(last, walked_.target) < 0)
      events_.push_back(event(last, -1));
    else if (open_)
      at_target_.push_back(number);
  }

  void walk(std::size_t number) {
    walked_ = tracks_[number];
    number_ = number;
    right_ = same_ = against_ = 0;
    events_.clear();
    at_source_.clear();
    at_target_.clear();
    find_sides();
    for (std::size_t i = 0; i < tracks_.size(); ++i) meet(i, tracks_[i]);
    int least = right_;
    for (const Event& e : events_) least += std::min(e.turn, 0);
    if (!open_ && least > 0) return;  // the sum is to its right, all along

    for (Event& e : events_) estimate(e);
    std::vector<std::size_t> order(events_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return compare(events_[a], events_[b]) < 0; });

    Point here = source();
    bool is_known = true;  // points are evaluated where they are needed only
    Event* last = nullptr;
    const auto before = [&]() -> const Point& {
      if (!is_known) here = place_of(*last);
      is_known = true;
      return here;
    };
    if (open_ && right_ > 0) look_at(source(), at_source_);
    for (std::size_t i = 0; i < order.size();) {
      Event& e = events_[order[i]];
      if (matters()) piece(before(), place_of(e));
      const bool around = right_ > 0 && right_ + same_ - against_ > 0;
      std::vector<std::size_t> through;
      do {
        const Event& next = events_[order[i]];
        right_ += next.turn;
        same_ += next.same;
        against_ += next.against;
        if (open_) through.push_back(next.track);
      } while (++i < order.size() && compare(e, events_[order[i]]) == 0);
      if (open_ && around && right_ > 0 && right_ + same_ - against_ > 0) {
        if (through.size() > 1 || same_ + against_ > 1) {
          add_running_along(through);
          if (may_block(through)) look_at(place_of(e), std::move(through));
        }
      }
      last = &e;
      is_known = false;
    }
    if (matters()) piece(before(), target());
    if (open_ && right_ > 0) look_at(target(), at_target_);
  }

  /// Whether the piece that is walked along is of interest.
  bool matters() const {
    const int left = right_ + same_ - against_;
    if (right_ <= 0) return walked_.counts && left > 0;
    if (OPLUS_MUTANT("walks-see-no-dangling-edges", "walks find no dangling edges")) return false;
    return open_ && left > 0 && ((same_ > 0 && against_ > 0) || !walked_.counts);
  }

  void piece(const Point& from, const Point& to) {
    if (right_ <= 0)
      found_.boundary.push_back({from, to});
    else
      found_.may_be_dangling.push_back(from < to ? Segment{from, to} : Segment{to, from});
  }

  /// Tracks in line with the one that is walked along; those that end elsewhere are taken too, since
  /// one more than needed costs a collision test only.
  void add_running_along(std::vector<std::size_t>& through) const {
    through.push_back(number_);
    for (std::size_t i = 0; against_ > 0 && i < tracks_.size(); ++i) {
      const Track& t = tracks_[i];
      if (side_[t.source] == 0 && side_[t.target] == 0 && i != number_) through.push_back(i);
    }
  }

  /// Whether tracks have three directions (thesis, Theorem 3.2.10).
  bool may_block(const std::vector<std::size_t>& through) const {
    std::vector<Vector> directions;
    for (const std::size_t i : through) {
      const Vector d = points_[tracks_[i].target] - points_[tracks_[i].source];
      const bool is_new = std::none_of(directions.begin(), directions.end(), [&](const Vector& u) {
        return sign(cross(u, d)) == 0 && sign(dot(u, d)) > 0;
      });
      if (is_new) directions.push_back(d);
      if (directions.size() >
          (OPLUS_MUTANT("four-directions-do-not-isolate",
                        "verify looks for isolated vertices where five directions meet")
               ? 4U
               : 2U))
        return true;
    }
    return false;
  }

  void look_at(const Point& x, std::vector<std::size_t> through) {
    if (may_block(through)) found_.may_be_isolated.insert(x);
  }

  bool open_;
  std::vector<Point> points_;  ///< sorted
  std::vector<IntervalPoint> near_;
  std::vector<Track> tracks_;
  Found found_;

  // Of the track that is walked along.
  Track walked_{};
  std::size_t number_ = 0;
  std::vector<std::int8_t> side_;
  std::vector<Event> events_;  ///< inside it
  std::vector<std::size_t> at_source_, at_target_;
  int right_ = 0;    ///< the winding number just to the right
  int same_ = 0;     ///< how many run along in its direction,
  int against_ = 0;  ///< or against it
};

bool contains(const std::vector<Point>& sorted, const Point& p) {
  return std::binary_search(sorted.begin(), sorted.end(), p);
}

/// Around a vertex in which chains touch, the interior is not that of its corners one by one, so
/// that a contact with it may block though its segment is not in the convolution.
std::vector<Segment> contacts_of_touching_points(const Region& p, const Region& q,
                                                 const std::vector<Point>& touching_p,
                                                 const std::vector<Point>& touching_q) {
  std::vector<Segment> result;
  for (const Point& v : touching_p)
    for (const Segment& e : edges(q)) result.push_back({v + e.source, v + e.target});
  for (const Point& v : touching_q)
    for (const Segment& e : edges(p)) result.push_back({v + e.source, v + e.target});
  return result;
}

}  // namespace

std::vector<Segment> exceptional_places(const Region& p, const Region& q) {
  std::vector<Segment> all = segments(convolution(p, q));
  const std::vector<Segment> more =
      contacts_of_touching_points(p, q, touching_points(p), touching_points(q));
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

MinkowskiSum sum_by_walks(const Region& p, const Region& q, Boundary boundary,
                          const Placements& placements) {
  const bool open = boundary == Boundary::open;
  const std::vector<Point> touching_p = open ? touching_points(p) : std::vector<Point>{};
  const std::vector<Point> touching_q = open ? touching_points(q) : std::vector<Point>{};
  Found found = Walks(segments(convolution(p, q)),
                      contacts_of_touching_points(p, q, touching_p, touching_q), open)
                    .walk_all();
  BoundaryFeatures features{std::move(found.boundary), {}, {}};
  MinkowskiSum closed = canonical_sum(features);
  if (!open) return closed;

  for (const Segment& s : sorted_without_copies(std::move(found.may_be_dangling)))
    if (!placements.interiors_meet_at(midpoint(s.source, s.target)))
      features.dangling_edges.push_back(s);

  for (const Segment& e : edges(p))
    for (const Segment& f : edges(q))
      if (contains(touching_p, e.source) || contains(touching_q, f.source))
        found.may_be_isolated.insert(e.source + f.source);
  for (const Point& x : found.may_be_isolated) {
    if (!lies_on_one(x, features.dangling_edges) && !placements.interiors_meet_at(x) &&
        locate(x, closed) == Location::inside)
      features.isolated_vertices.push_back(x);
  }
  return canonical_sum(features);
}

}  // namespace oplus
