// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "properties/fuzz/along_lines/frame.hpp"
#include "properties/fuzz/along_lines/position.hpp"
#include "properties/fuzz/along_lines/tracks.hpp"
#include "reference/definitions/segment.hpp"

namespace oplus::along_lines {

/// What winding numbers along all lines say. Points are those of the sum, not of the frame.
struct FoundAlongLines {
  std::vector<Segment> boundary;             ///< the sum to the left
  std::vector<Segment> may_dangle;           ///< inside, with tracks of both directions
  std::vector<Point> may_be_isolated;        ///< inside, where at least three tracks cross
  std::vector<std::uint32_t> isolated_sums;  ///< vertex sums with nothing but the sum around them
};

/// Where winding numbers to the left and to the right of a line change.
template <typename T>
struct Change {
  Position<T> at;
  int left, right;
  std::uint32_t track;
};

/// Walks along the line of each track: O(K² log K) for K tracks.
template <typename T>
class LineWalk {
  static constexpr bool is_large = std::is_same_v<T, mpz_class>;

 public:
  LineWalk(const VertexSums<T>& sums, const std::vector<Track>& tracks, const Frame& frame)
      : sums_(sums), tracks_(tracks), frame_(frame) {}

  FoundAlongLines found() {
    beside_.resize(sums_.size());
    near_beside_.resize(sums_.size());
    side_.resize(sums_.size());
    may_be_isolated_.assign(sums_.size(), true);
    is_on_a_line_.assign(sums_.size(), false);
    is_done_.assign(tracks_.size(), false);
    for (std::uint32_t i = 0; i < tracks_.size(); ++i)
      if (!is_done_[i]) walk(i);
    for (std::uint32_t k = 0; k < sums_.size(); ++k)
      if (may_be_isolated_[k] && is_on_a_line_[k]) found_.isolated_sums.push_back(k);
    return std::move(found_);
  }

 private:
  /// Walks along the line of a track, and notes which tracks are on it.
  void walk(std::uint32_t along) {
    first_ = sums_.at[tracks_[along].source];
    direction_ = sums_.at[tracks_[along].target] - first_;
    is_vertical_ = direction_.x == 0;
    if (direction_.x < 0 || (is_vertical_ && direction_.y < 0))
      direction_ = {T(-direction_.x), T(-direction_.y)};
    find_sides();
    changes_.clear();
    on_line_.clear();
    for (std::uint32_t i = 0; i < tracks_.size(); ++i) {
      const int from = side_[tracks_[i].source], to = side_[tracks_[i].target];
      if (from == to) {
        if (from != 0) continue;
        is_done_[i] = true;
        on_line_.push_back(i);
        continue;
      }
      // Towards the left: the left side of the track is what was passed.
      const int left = (from > 0) - (to > 0), right = (from >= 0) - (to >= 0);
      changes_.push_back({near_crossing(i), left, right, i});
      if constexpr (!is_large) make_exact(changes_.back());
    }
    has_both_ways_ = false;
    for (const std::uint32_t i : on_line_)
      has_both_ways_ |= goes_along(i) != goes_along(on_line_.front());
    // What dangles may end where one track follows another and nothing changes.
    if (has_both_ways_)
      for (const std::uint32_t i : on_line_)
        for (const std::uint32_t end : {tracks_[i].source, tracks_[i].target})
          changes_.push_back({position<T>(along_line(end), T(1)), 0, 0, i});
    std::sort(changes_.begin(), changes_.end(),
              [&](Change<T>& a, Change<T>& b) { return compare(a, b) < 0; });
    sweep();
  }

  /// On which side of the line each vertex sum is.
  void find_sides() {
    const double dx = as_double(direction_.x), dy = as_double(direction_.y);
    const double x = as_double(first_.x), y = as_double(first_.y);
    error_ = (std::abs(dx) + std::abs(dy)) * sums_.largest * 4e-15;
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      if constexpr (is_large) {
        near_beside_[k] = dx * (sums_.near[k].y - y) - dy * (sums_.near[k].x - x);
        side_[k] = certain_sign(near_beside_[k], error_);
        if (side_[k] == 0) side_[k] = sign_of(beside(static_cast<std::uint32_t>(k)));
      } else {
        beside_[k] = skew(direction_, sums_.at[k] - first_);
        side_[k] = sign_of(beside_[k]);
      }
    }
  }

  T beside(std::uint32_t sum) const {
    if constexpr (is_large)
      return skew(direction_, sums_.at[sum] - first_);
    else
      return beside_[sum];
  }

  /// What doubles know of where a track crosses the line.
  Position<T> near_crossing(std::uint32_t track) const {
    if constexpr (!is_large) return {0, 0};
    const std::uint32_t from = tracks_[track].source, to = tracks_[track].target;
    const double a = near_beside_[from], b = near_beside_[to];
    const double from_at = is_vertical_ ? sums_.near[from].y - as_double(first_.y)
                                        : sums_.near[from].x - as_double(first_.x);
    const double length = is_vertical_ ? sums_.near[to].y - sums_.near[from].y
                                       : sums_.near[to].x - sums_.near[from].x;
    const double apart = std::abs(a - b);
    if (!(apart > 4 * error_)) return {0, std::numeric_limits<double>::infinity()};
    return {from_at + length * (a / (a - b)),
            std::abs(length) * (8 * error_ / apart) + sums_.largest * 1e-14};
  }

  /// Requires: the change is at a crossing.
  void make_exact(Change<T>& change) const {
    if (change.at.denominator != 0) return;
    const Track& track = tracks_[change.track];
    const T a = beside(track.source), b = beside(track.target);
    const T from_at = along_line(track.source), to_at = along_line(track.target);
    change.at = position<T>(T(from_at * b - to_at * a), T(b - a));
  }

  int compare(Change<T>& a, Change<T>& b) const {
    const int order = certain_sign(a.at.near - b.at.near, a.at.error + b.at.error);
    if (order != 0) return order;
    make_exact(a);
    make_exact(b);
    return compare_exactly(a.at, b.at);
  }

  T along_line(std::uint32_t sum) const {
    return is_vertical_ ? T(sums_.at[sum].y - first_.y) : T(sums_.at[sum].x - first_.x);
  }

  /// All changes at one place, and the winding numbers after it.
  struct Group {
    std::size_t first, last;
    int left, right;

    bool is_inside() const { return left > 0 && right > 0; }
  };

  void sweep() {
    groups_.clear();
    int left = 0, right = 0;
    for (std::size_t first = 0; first < changes_.size();) {
      std::size_t last = first;
      for (; last < changes_.size() && compare(changes_[first], changes_[last]) == 0; ++last) {
        left += changes_[last].left;
        right += changes_[last].right;
      }
      groups_.push_back({first, last, left, right});
      first = last;
    }
    for (std::size_t g = 0; g + 1 < groups_.size(); ++g) {
      const bool in_left = groups_[g].left > 0, in_right = groups_[g].right > 0;
      if (in_left != in_right) {
        Point from = point(position_of(g)), to = point(position_of(g + 1));
        if (in_right) swap(from, to);
        found_.boundary.push_back({std::move(from), std::move(to)});
      } else if (in_left && has_both_ways_ && is_covered_both_ways(g)) {
        found_.may_dangle.push_back({point(position_of(g)), point(position_of(g + 1))});
      }
    }
    for (std::size_t g = 1; g < groups_.size(); ++g) find_crossing(g);
    for (std::uint32_t k = 0; k < sums_.size(); ++k)
      if (may_be_isolated_[k] && side_[k] == 0) look_around(k);
  }

  const Position<T>& position_of(std::size_t group) {
    Change<T>& first = changes_[groups_[group].first];
    make_exact(first);
    return first.at;
  }

  /// Of a vertex sum on the line, and a group.
  int compare_end(std::uint32_t sum, std::size_t group) {
    if constexpr (is_large) {
      const Position<T>& at = changes_[groups_[group].first].at;
      const double near = is_vertical_ ? sums_.near[sum].y - as_double(first_.y)
                                       : sums_.near[sum].x - as_double(first_.x);
      const int order = certain_sign(near - at.near, at.error + sums_.largest * 1e-14);
      if (order != 0) return order;
    }
    const Position<T>& at = position_of(group);
    return sign_of(T(along_line(sum) * at.denominator - at.numerator));
  }

  bool goes_along(std::uint32_t track) const {
    return along_line(tracks_[track].target) > along_line(tracks_[track].source);
  }

  /// The ends of a track on the line, in the direction of the walk.
  std::pair<std::uint32_t, std::uint32_t> ends_along(std::uint32_t track) const {
    const auto [source, target] = std::pair(tracks_[track].source, tracks_[track].target);
    return goes_along(track) ? std::pair(source, target) : std::pair(target, source);
  }

  bool is_covered_both_ways(std::size_t group) {
    std::array<bool, 2> covered = {false, false};
    for (const std::uint32_t i : on_line_) {
      if (!tracks_[i].is_reduced) continue;
      const auto [from, to] = ends_along(i);
      if (compare_end(from, group) <= 0 && compare_end(to, group + 1) >= 0)
        covered.at(goes_along(i)) = true;
    }
    return covered[0] && covered[1];
  }

  /// A place inside the sum that at least three tracks pass, such that the left sides of those of the
  /// reduced convolution are all around it: elsewhere some direction leads out of no contact.
  void find_crossing(std::size_t group) {
    const Group& here = groups_[group];
    if (here.last - here.first < 2 || !here.is_inside() || !groups_[group - 1].is_inside()) return;
    std::vector<Vec<T>> passing;
    for (std::size_t k = here.first; k < here.last; ++k) {
      const Track& track = tracks_[changes_[k].track];
      // A vertex sum is looked at as such.
      if (side_[track.source] == 0 || side_[track.target] == 0) return;
      if (track.is_reduced) passing.push_back(sums_.at[track.target] - sums_.at[track.source]);
    }
    for (const std::uint32_t i : on_line_) {
      if (!tracks_[i].is_reduced) continue;
      const auto [from, to] = ends_along(i);
      if (compare_end(from, group) < 0 && compare_end(to, group) > 0)
        passing.push_back(sums_.at[tracks_[i].target] - sums_.at[tracks_[i].source]);
    }
    if (passing.size() < 3) return;
    for (const Vec<T>& one : passing)
      for (const int side : {1, -1})
        if (std::all_of(passing.begin(), passing.end(),
                        [&](const Vec<T>& other) { return side * sign_of(skew(other, one)) <= 0; }))
          return;
    found_.may_be_isolated.push_back(point(position_of(group)));
  }

  /// Of a vertex sum on the line: what is around it must be in the sum.
  void look_around(std::uint32_t sum) {
    is_on_a_line_[sum] = true;
    std::size_t first = 0, last = groups_.size();  // the first one that is not before it
    while (first < last) {
      const std::size_t middle = (first + last) / 2;
      if (compare_end(sum, middle) > 0)
        first = middle + 1;
      else
        last = middle;
    }
    const bool is_at_one = first < groups_.size() && compare_end(sum, first) == 0;
    const std::size_t after = is_at_one ? first + 1 : first;
    if (first == 0 || !groups_[first - 1].is_inside() || after == 0 ||
        !groups_[after - 1].is_inside())
      may_be_isolated_[sum] = false;
  }

  Point point(const Position<T>& at) const {
    Rational along(as_mpz(at.numerator), as_mpz(at.denominator));
    along.canonicalize();
    const Rational x0(as_mpz(first_.x)), y0(as_mpz(first_.y));
    if (is_vertical_) return frame_.back(x0, Rational(y0 + along));
    Rational slope(as_mpz(direction_.y), as_mpz(direction_.x));
    slope.canonicalize();
    return frame_.back(Rational(x0 + along), Rational(y0 + along * slope));
  }

  const VertexSums<T>& sums_;
  const std::vector<Track>& tracks_;
  const Frame& frame_;
  std::vector<bool> is_done_;                         ///< tracks: their line was walked
  std::vector<bool> may_be_isolated_, is_on_a_line_;  ///< vertex sums

  // The line that is walked.
  Vec<T> first_, direction_;
  bool is_vertical_ = false;
  std::vector<int> side_;            ///< for each vertex sum, 1: to the left
  std::vector<T> beside_;            ///< how far, of small numbers
  std::vector<double> near_beside_;  ///< about how far, of large ones
  double error_ = 0;
  std::vector<Change<T>> changes_;
  std::vector<Group> groups_;
  std::vector<std::uint32_t> on_line_;
  bool has_both_ways_ = false;

  FoundAlongLines found_;
};

template <typename T>
FoundAlongLines found_along_lines(const VertexSums<T>& sums, const std::vector<Track>& tracks,
                                  const Frame& frame) {
  return LineWalk<T>(sums, tracks, frame).found();
}

}  // namespace oplus::along_lines
