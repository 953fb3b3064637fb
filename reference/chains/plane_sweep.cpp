// SPDX-License-Identifier: MIT
#include "reference/chains/plane_sweep.hpp"

#include <boost/intrusive/rbtree.hpp>
#include <numeric>
#include <utility>

#include "reference/chains/near_point.hpp"

namespace oplus {

namespace {

using Index = std::uint32_t;

/// An edge in the status; of which index, its address says.
struct Node
    : boost::intrusive::set_base_hook<boost::intrusive::link_mode<boost::intrusive::normal_link>,
                                      boost::intrusive::optimize_size<true>> {};

struct Unordered {  // where a node is inserted is known already
  bool operator()(const Node&, const Node&) const { return false; }
};

using Status = boost::intrusive::rbtree<Node, boost::intrusive::compare<Unordered>,
                                        boost::intrusive::constant_time_size<false>>;

/// Where two edges cross properly.
struct Crossing {
  Point point;
  IntervalPoint near;
  Index a, b;
};

class Sweep {
 public:
  explicit Sweep(const SweptEdges& of) : of_(of), nodes_(of.edges.size()) {
    points_.reserve(of.points.size());
    for (const Point* p : of.points) points_.push_back(near_point(*p));
    sort_points();
    sort_edges();
  }

  void run(const std::function<bool(const SweptPlace&)>& visit) {
    std::size_t rank = 0;
    while (rank + 1 < first_of_rank_.size() || !crossings_.empty()) {
      const bool has_vertex = rank + 1 < first_of_rank_.size();
      const int compared = crossings_.empty() ? -1
                           : !has_vertex      ? 1
                                              : compare(points_[order_[first_of_rank_[rank]]],
                                                        place_of(crossings_.front()));
      Point crossing_point;
      std::optional<Index> seed;
      std::span<const Index> given;
      starting_ = {};
      rank_ = none;
      if (compared <= 0) {
        rank_ = static_cast<Index>(rank);
        given = std::span(order_).subspan(first_of_rank_[rank],
                                          first_of_rank_[rank + 1] - first_of_rank_[rank]);
        place_ = points_[given.front()];
        starting_ =
            std::span(starting_edges_)
                .subspan(first_starting_[rank], first_starting_[rank + 1] - first_starting_[rank]);
        if (one_that_ends_[rank] != none) seed = one_that_ends_[rank];
        ++rank;
      } else {
        crossing_ = {crossings_.front().a, crossings_.front().b};
        seed = crossings_.front().a;
        const IntervalPoint near = crossings_.front().near;
        crossing_point = take_crossing();
        place_ = {near, &crossing_point};
      }
      while (!crossings_.empty() && compare(place_of(crossings_.front()), place_) == 0)
        take_crossing();
      pass(seed);
      if (!visit(SweptPlace{*place_.exact, given, left_, right_, below_, above_})) return;
    }
  }

 private:
  static constexpr Index none = static_cast<Index>(-1);

  void sort_points() {
    order_.resize(points_.size());
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(), [&](Index i, Index j) {
      const int compared = compare(points_[i], points_[j]);
      return compared != 0 ? compared < 0 : i < j;
    });
    rank_of_.resize(points_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) {
      if (i == 0 || compare(points_[order_[i - 1]], points_[order_[i]]) != 0)
        first_of_rank_.push_back(static_cast<Index>(i));
      rank_of_[order_[i]] = static_cast<Index>(first_of_rank_.size() - 1);
    }
    first_of_rank_.push_back(static_cast<Index>(order_.size()));
  }

  /// Directs edges to the right, and sorts them by where they start.
  void sort_edges() {
    const std::size_t ranks = first_of_rank_.size() - 1;
    ends_ = of_.edges;
    first_starting_.assign(ranks + 2, 0);
    one_that_ends_.assign(ranks, none);
    for (Index e = 0; e < ends_.size(); ++e) {
      if (rank_of_[ends_[e].target] < rank_of_[ends_[e].source])
        std::swap(ends_[e].source, ends_[e].target);
      if (rank_of_[ends_[e].source] == rank_of_[ends_[e].target]) continue;
      ++first_starting_[rank_of_[ends_[e].source] + 2];
      one_that_ends_[rank_of_[ends_[e].target]] = e;
    }
    std::partial_sum(first_starting_.begin(), first_starting_.end(), first_starting_.begin());
    starting_edges_.resize(first_starting_.back());
    for (Index e = 0; e < ends_.size(); ++e)
      if (rank_of_[ends_[e].source] != rank_of_[ends_[e].target])
        starting_edges_[first_starting_[rank_of_[ends_[e].source] + 1]++] = e;
  }

  const NearPoint& low(Index e) const { return points_[ends_[e].source]; }
  const NearPoint& high(Index e) const { return points_[ends_[e].target]; }
  Index index(const Node& node) const { return static_cast<Index>(&node - nodes_.data()); }
  Status::iterator position(Index e) { return Status::s_iterator_to(nodes_[e]); }

  /// Positive where the place is above the edge, negative where it is below.
  int side(Index e) const {
    const bool is_through =
        rank_ != none ? rank_of_[ends_[e].target] == rank_ : e == crossing_.a || e == crossing_.b;
    return is_through ? 0 : orientation(low(e), high(e), place_);
  }

  /// Of edges to the right of the place. The difference of their slopes decides, then the index.
  bool is_below(Index a, Index b) const {
    const auto along = [&](Index e) { return high(e).near - low(e).near; };
    const auto exactly_along = [&](Index e) { return *high(e).exact - *low(e).exact; };
    const std::optional<int> known = sign(cross(along(a), along(b)));
    const int turn = known ? *known : sgn(cross(exactly_along(a), exactly_along(b)));
    return turn != 0 ? turn > 0 : a < b;
  }

  /// Takes the edges to the left of the place out of the status, and those to the right in.
  void pass(const std::optional<Index>& seed) {
    left_.clear();
    right_.clear();
    Status::iterator first, last;  // those through the place, the last one excluded
    if (seed) {
      first = position(*seed);
      while (first != status_.begin() && side(index(*std::prev(first))) == 0) --first;
      last = std::next(position(*seed));
    } else {
      first = last = status_.lower_bound(
          place_, [&](const Node& node, const NearPoint&) { return side(index(node)) > 0; });
    }
    while (last != status_.end() && side(index(*last)) == 0) ++last;
    below_ = first == status_.begin() ? std::nullopt : std::optional(index(*std::prev(first)));
    above_ = last == status_.end() ? std::nullopt : std::optional(index(*last));

    for (Status::iterator i = first; i != last; ++i) {
      left_.push_back(index(*i));
      if (rank_ == none || rank_of_[ends_[index(*i)].target] != rank_) right_.push_back(index(*i));
    }
    right_.insert(right_.end(), starting_.begin(), starting_.end());
    std::sort(right_.begin(), right_.end(), [&](Index a, Index b) { return is_below(a, b); });
    if (left_.size() == 1 && right_.size() == 1 && left_ != right_) {
      status_.replace_node(first, nodes_[right_[0]]);
    } else if (left_ != right_) {
      status_.erase(first, last);
      for (const Index e : right_) status_.insert_before(last, nodes_[e]);
    }

    if (right_.empty()) {
      if (below_ && above_) look_for_crossing(*below_, *above_);
      return;
    }
    if (below_) look_for_crossing(*below_, right_.front());
    if (above_) look_for_crossing(right_.back(), *above_);
  }

  /// Of two neighbours, the first one below the second: beyond the place they meet in a point, or cross,
  /// or neither. What meets at an end is seen there.
  void look_for_crossing(Index a, Index b) {
    const Index end_a = rank_of_[ends_[a].target], end_b = rank_of_[ends_[b].target];
    if (end_a == end_b) return;
    if (end_a < end_b ? orientation(low(b), high(b), high(a)) <= 0
                      : orientation(low(a), high(a), high(b)) >= 0)
      return;
    const Vector u = *high(a).exact - *low(a).exact, v = *high(b).exact - *low(b).exact;
    const Rational t = cross(*low(b).exact - *low(a).exact, v) / cross(u, v);
    Point point = *low(a).exact + t * u;
    const IntervalPoint near = interval(point);
    crossings_.push_back({std::move(point), near, a, b});
    std::push_heap(crossings_.begin(), crossings_.end(), is_after);
  }

  static NearPoint place_of(const Crossing& crossing) { return {crossing.near, &crossing.point}; }
  static bool is_after(const Crossing& a, const Crossing& b) {
    return compare(place_of(a), place_of(b)) > 0;
  }
  Point take_crossing() {
    std::pop_heap(crossings_.begin(), crossings_.end(), is_after);
    Point point = std::move(crossings_.back().point);
    crossings_.pop_back();
    return point;
  }

  const SweptEdges& of_;
  std::vector<NearPoint> points_;
  std::vector<Index> order_;          // of the points, lexicographic
  std::vector<Index> first_of_rank_;  // in order_: equal points have one rank
  std::vector<Index> rank_of_;
  std::vector<SweptEdges::Edge> ends_;  // of each edge, from the smaller end
  std::vector<Index> starting_edges_;   // by the rank at which they start
  std::vector<Index> first_starting_;
  std::vector<Index> one_that_ends_;  // at each rank
  std::vector<Crossing> crossings_;   // a heap

  // Of the current place:
  NearPoint place_;
  Index rank_ = none;  // where it is a given point
  struct {
    Index a, b;
  } crossing_ = {};  // otherwise, two edges that cross there
  std::span<const Index> starting_;
  std::vector<Index> left_, right_;
  std::optional<Index> below_, above_;

  std::vector<Node> nodes_;  // of each edge
  Status status_;            // from the lowest edge to the highest; destroyed before its nodes
};

}  // namespace

void SweptEdges::add(const Point& p) { points.push_back(&p); }

void SweptEdges::add(const Segment& s) {
  const auto first = static_cast<std::uint32_t>(points.size());
  points.push_back(&s.source);
  points.push_back(&s.target);
  edges.push_back({first, first + 1});
}

void SweptEdges::add(const Chain& chain) {
  const std::size_t first = points.size();
  for (std::size_t i = 0; i < chain.size(); ++i) {
    points.push_back(&chain[i]);
    const std::size_t after = i + 1 == chain.size() ? 0 : i + 1;
    edges.push_back(
        {static_cast<std::uint32_t>(first + i), static_cast<std::uint32_t>(first + after)});
  }
}

void sweep(const SweptEdges& edges, const std::function<bool(const SweptPlace&)>& visit) {
  Sweep(edges).run(visit);
}

}  // namespace oplus
