// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/sums_along_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "reference/definitions/collision.hpp"

namespace oplus {

namespace {

__extension__ typedef __int128 Int128;

double as_double(std::int64_t value) { return static_cast<double>(value); }
double as_double(Int128 value) { return static_cast<double>(value); }
double as_double(const mpz_class& value) { return value.get_d(); }

mpz_class as_mpz(std::int64_t value) { return static_cast<long>(value); }
mpz_class as_mpz(Int128 value) {
  constexpr Int128 low_part = Int128(1) << 62;
  return (mpz_class(static_cast<long>(value / low_part)) << 62) +
         static_cast<long>(value % low_part);
}
const mpz_class& as_mpz(const mpz_class& value) { return value; }

template <typename T>
T from_mpz(const mpz_class& value) {
  if constexpr (std::is_same_v<T, mpz_class>)
    return value;
  else
    return value.get_si();
}

template <typename T>
int sign_of(const T& value) {
  return (value > 0) - (value < 0);
}

template <typename T>
struct Vec {
  T x, y;

  friend Vec operator+(const Vec& a, const Vec& b) { return {T(a.x + b.x), T(a.y + b.y)}; }
  friend Vec operator-(const Vec& a, const Vec& b) { return {T(a.x - b.x), T(a.y - b.y)}; }
};

template <typename T>
T skew(const Vec<T>& a, const Vec<T>& b) {
  return T(a.x * b.y - a.y * b.x);
}
template <typename T>
T scalar(const Vec<T>& a, const Vec<T>& b) {
  return T(a.x * b.x + a.y * b.y);
}

/// How coordinates become integers, as small as possible: less that of the summand's first vertex, and
/// times a factor.
struct Frame {
  Point first_of_p, first_of_q;
  Rational factor = 1;
  std::size_t bits = 1;  ///< of the largest coordinate of a vertex sum, apart from the sign

  Point back(const Rational& x, const Rational& y) const {
    return {x / factor + first_of_p.x + first_of_q.x, y / factor + first_of_p.y + first_of_q.y};
  }
};

Frame frame_of(const Region& p, const Region& q) {
  Frame frame{p.components.at(0).outer.at(0), q.components.at(0).outer.at(0)};
  std::vector<Rational> all;
  std::array<Rational, 2> largest = {0, 0};
  const auto add = [&](const Region& region, const Point& first, Rational& most) {
    for (const Chain& chain : chains(region))
      for (const Point& v : chain)
        for (Rational value : {Rational(v.x - first.x), Rational(v.y - first.y)}) {
          if (value == 0) continue;
          most = std::max(most, Rational(abs(value)));
          all.push_back(std::move(value));
        }
  };
  add(p, frame.first_of_p, largest[0]);
  add(q, frame.first_of_q, largest[1]);
  mpz_class denominator = 1, divisor = 0;
  for (const Rational& value : all) denominator = lcm(denominator, value.get_den());
  for (const Rational& value : all)
    divisor = gcd(divisor, mpz_class(value.get_num() * (denominator / value.get_den())));
  frame.factor = Rational(denominator, divisor);
  frame.factor.canonicalize();
  const Rational most = (largest[0] + largest[1]) * frame.factor;
  frame.bits = mpz_sizeinbase(most.get_num().get_mpz_t(), 2);
  return frame;
}

/// The vertices of a summand, chain after chain.
template <typename T>
struct Vertices {
  std::vector<Vec<T>> at;
  std::vector<std::size_t> next, before;
  std::vector<VertexIndex> name;
  std::vector<bool> is_touched;  ///< the edge that leaves it, by another vertex inside it

  Vec<T> edge(std::size_t i) const { return at[next[i]] - at[i]; }
  std::size_t size() const { return at.size(); }
};

template <typename T>
Vertices<T> vertices_of(const Region& region, const Point& first, const Frame& frame) {
  Vertices<T> result;
  const std::vector<Chain> all = chains(region);
  for (std::size_t c = 0; c < all.size(); ++c) {
    const std::size_t start = result.size(), n = all[c].size();
    for (std::size_t i = 0; i < n; ++i) {
      const Rational x = (all[c][i].x - first.x) * frame.factor;
      const Rational y = (all[c][i].y - first.y) * frame.factor;
      result.at.push_back({from_mpz<T>(x.get_num()), from_mpz<T>(y.get_num())});
      result.next.push_back(start + (i + 1) % n);
      result.before.push_back(start + (i + n - 1) % n);
      result.name.push_back({c, i});
    }
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Vec<T> d = result.edge(i);
    const T length = scalar(d, d);
    bool touched = false;
    for (std::size_t k = 0; k < result.size() && !touched; ++k) {
      const Vec<T> to = result.at[k] - result.at[i];
      if (sign_of(skew(d, to)) != 0) continue;
      const T along = scalar(d, to);
      touched = along > 0 && along < length;
    }
    result.is_touched.push_back(touched);
  }
  return result;
}

/// Compares the directions as angles in [0, 2π), of equal ones first that of P (Definition 2.2.7).
template <typename T>
int compare_directions(const Vec<T>& a, int of_a, const Vec<T>& b, int of_b) {
  const auto lower = [](const Vec<T>& v) { return v.y < 0 || (v.y == 0 && v.x < 0); };
  const int halves = int{lower(a)} - int{lower(b)};
  if (halves != 0) return halves;
  const int turn = sign_of(skew(a, b));
  return turn != 0 ? -turn : of_a - of_b;
}

/// Whether an edge's direction is in the tangent set of a vertex of the other (Definitions 2.1.13, 2.2.7).
template <typename T>
bool is_tangent(const Vec<T>& d, int of_d, const Vec<T>& in, const Vec<T>& out) {
  const int of = 1 - of_d;
  const bool after_in = compare_directions(in, of, d, of_d) < 0;
  const bool before_out = compare_directions(d, of_d, out, of) < 0;
  const int range = compare_directions(in, of, out, of);
  return range < 0 ? after_in && before_out : range > 0 && (after_in || before_out);
}

/// A segment of 𝒞 between two vertex sums.
struct Track {
  std::uint32_t source, target;
  Origin origin;
  bool is_reduced;
};

/// A place on a line: its x, or y on vertical lines, less that of the line's first point.
template <typename T>
struct Position {
  double near, error;
  T numerator = 0, denominator = 0;  ///< positive, or zero as long as `near` is enough
};

/// Beyond what doubles hold, equal to all: then integers decide.
template <typename T>
Position<T> position(T numerator, T denominator) {
  if (denominator < 0) {
    numerator = T(-numerator);
    denominator = T(-denominator);
  }
  const double a = as_double(numerator), b = as_double(denominator);
  const double near =
      std::isfinite(a) && std::isfinite(b) ? a / b : std::numeric_limits<double>::quiet_NaN();
  return {near, std::abs(near) * 1e-15, std::move(numerator), std::move(denominator)};
}

template <typename T>
int compare_exactly(const Position<T>& a, const Position<T>& b) {
  return sign_of(T(a.numerator * b.denominator - b.numerator * a.denominator));
}

/// The sign of a number that doubles say is near to another; 0 where they do not know.
int certain_sign(double near, double error) { return (near > error) - (near < -error); }

/// Where winding numbers to the left and to the right of a line change.
template <typename T>
struct Change {
  Position<T> at;
  int left, right;
  std::uint32_t track;
};

template <typename T>
class Lines {
  static constexpr bool is_large = std::is_same_v<T, mpz_class>;

 public:
  Lines(const Region& p, const Region& q, const Frame& frame)
      : region_p_(p),
        region_minus_q_(reflected(q)),
        frame_(frame),
        p_(vertices_of<T>(p, frame.first_of_p, frame)),
        q_(vertices_of<T>(q, frame.first_of_q, frame)) {
    for (const Vec<T>& a : p_.at)
      for (const Vec<T>& b : q_.at) sums_.push_back(a + b);
    for (const Vec<T>& v : p_.at) near_p_.push_back({as_double(v.x), as_double(v.y)});
    for (const Vec<T>& v : q_.at) near_q_.push_back({as_double(v.x), as_double(v.y)});
    for (const Vec<T>& sum : sums_) near_.push_back({as_double(sum.x), as_double(sum.y)});
    for (const auto& [x, y] : near_) largest_ = std::max({largest_, std::abs(x), std::abs(y)});
    add_tracks(p_, q_, Summand::P, [&](std::size_t edge, std::size_t vertex) {
      return static_cast<std::uint32_t>(edge * q_.size() + vertex);
    });
    add_tracks(q_, p_, Summand::Q, [&](std::size_t edge, std::size_t vertex) {
      return static_cast<std::uint32_t>(vertex * q_.size() + edge);
    });
  }

  SumsAlongLines sums() {
    beside_.resize(sums_.size());
    near_beside_.resize(sums_.size());
    side_.resize(sums_.size());
    may_be_isolated_.assign(sums_.size(), true);
    is_on_a_line_.assign(sums_.size(), false);
    std::vector<bool> is_done(tracks_.size(), false);
    for (std::uint32_t i = 0; i < tracks_.size(); ++i)
      if (!is_done[i]) walk(i, is_done);
    SumsAlongLines result;
    result.closed = result.open = canonical_sum({boundary_, {}, {}});
    decide_dangling(result.open);
    decide_isolated(result.open);
    result.origins_of_closed = origins(edges(result.closed), false);
    result.origins_of_open = result.origins_of_closed;
    for (std::vector<Origin>& of_edge : origins(result.open.dangling_edges, true))
      result.origins_of_open.push_back(std::move(of_edge));
    return result;
  }

 private:
  template <typename Index>
  void add_tracks(const Vertices<T>& with_edges, const Vertices<T>& with_vertices, Summand edge_of,
                  Index index) {
    for (std::size_t i = 0; i < with_edges.size(); ++i) {
      const Vec<T> d = with_edges.edge(i);
      for (std::size_t j = 0; j < with_vertices.size(); ++j) {
        const Vec<T> in = with_vertices.edge(with_vertices.before[j]);
        const Vec<T> out = with_vertices.edge(j);
        if (!is_tangent(d, edge_of == Summand::Q, in, out)) continue;
        tracks_.push_back({index(i, j),
                           index(with_edges.next[i], j),
                           {edge_of, with_edges.name[i], with_vertices.name[j]},
                           skew(in, out) >= 0});
      }
    }
  }

  // The open sum: vertex sums. One in it is mostly seen to be so by edges that cross.

  /// Whether pairs of edges show that the interiors of P and -Q + x meet.
  bool certainly_meet(const Vec<T>& x) const {
    if constexpr (is_large)
      if (doubles_see_them_meet({as_double(x.x), as_double(x.y)})) return true;
    for (std::size_t i = 0; i < p_.size(); ++i) {
      const Vec<T>& a = p_.at[i];
      const Vec<T>& b = p_.at[p_.next[i]];
      const Vec<T> ab = b - a;
      for (std::size_t j = 0; j < q_.size(); ++j) {
        const Vec<T> c = x - q_.at[j], d = x - q_.at[q_.next[j]];
        // Apart in x or in y?
        if ((a.x <= c.x && a.x <= d.x && b.x <= c.x && b.x <= d.x) ||
            (a.x >= c.x && a.x >= d.x && b.x >= c.x && b.x >= d.x)) {
          if (!(a.x == b.x && c.x == d.x && a.x == c.x)) continue;
        }
        const int side_of_c = sign_of(skew(ab, c - a));
        const int side_of_d = sign_of(skew(ab, d - a));
        if (side_of_c == 0 && side_of_d == 0) {
          if (overlap_alike(a, b, c, d)) return true;
          continue;
        }
        // An edge that leaves a point inside another to the left has its own left side there.
        const bool c_enters = side_of_c == 0 && side_of_d > 0,
                   d_enters = side_of_d == 0 && side_of_c > 0;
        if ((c_enters || d_enters) && !p_.is_touched[i] && is_between(a, c_enters ? c : d, b))
          return true;
        if (side_of_c * side_of_d > 0 || q_.is_touched[j]) continue;
        const Vec<T> cd = d - c;
        const int side_of_a = sign_of(skew(cd, a - c)), side_of_b = sign_of(skew(cd, b - c));
        const bool a_enters = side_of_a == 0 && side_of_b > 0,
                   b_enters = side_of_b == 0 && side_of_a > 0;
        if ((a_enters || b_enters) && is_between(c, a_enters ? a : b, d)) return true;
        if (side_of_c * side_of_d < 0 && side_of_a * side_of_b < 0 && !p_.is_touched[i])
          return true;
      }
    }
    return false;
  }

  /// Of three points on a line.
  static bool is_between(const Vec<T>& a, const Vec<T>& v, const Vec<T>& b) {
    return scalar(v - a, v - b) < 0;
  }

  bool doubles_see_them_meet(const Vec<double>& x) const {
    const double error = largest_ * largest_ * 1e-13;
    const auto side = [&](const Vec<double>& a, const Vec<double>& b, const Vec<double>& c) {
      return certain_sign(skew(Vec<double>(b - a), Vec<double>(c - a)), error);
    };
    for (std::size_t i = 0; i < p_.size(); ++i) {
      if (p_.is_touched[i]) continue;
      const Vec<double>& a = near_p_[i];
      const Vec<double>& b = near_p_[p_.next[i]];
      for (std::size_t j = 0; j < q_.size(); ++j) {
        const Vec<double> c = x - near_q_[j], d = x - near_q_[q_.next[j]];
        if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0 &&
            !q_.is_touched[j])
          return true;
      }
    }
    return false;
  }

  /// Of two segments on a line.
  static bool overlap_alike(const Vec<T>& a, const Vec<T>& b, const Vec<T>& c, const Vec<T>& d) {
    const Vec<T> ab = b - a;
    if (scalar(ab, d - c) <= 0) return false;
    return scalar(ab, d - a) > 0 && scalar(ab, c - b) < 0;
  }

  /// Whether a vertex, or the middle of an edge, of one summand is inside the other.
  bool one_is_inside_the_other(const Vec<T>& x) const {
    return enters(p_, 1, {T(0), T(0)}, q_, -1, x) || enters(q_, -1, x, p_, 1, {T(0), T(0)});
  }

  /// Of summands times 1 or -1, moved.
  static bool enters(const Vertices<T>& a, int times_a, const Vec<T>& by_a, const Vertices<T>& b,
                     int times_b, const Vec<T>& by_b) {
    const auto twice = [](const Vec<T>& v, const Vec<T>& w, int times, const Vec<T>& by) {
      return Vec<T>{T(times * (v.x + w.x) + 2 * by.x), T(times * (v.y + w.y) + 2 * by.y)};
    };
    for (std::size_t i = 0; i < a.size(); ++i)
      for (const std::size_t k : {i, a.next[i]}) {
        const Vec<T> at = twice(a.at[i], a.at[k], times_a, by_a);
        int winding = 0;
        bool is_on_one = false;
        for (std::size_t j = 0; j < b.size() && !is_on_one; ++j) {
          const Vec<T> source = twice(b.at[j], b.at[j], times_b, by_b) - at;
          const Vec<T> target = twice(b.at[b.next[j]], b.at[b.next[j]], times_b, by_b) - at;
          const int side = sign_of(skew(source, target));
          is_on_one = side == 0 && scalar(source, target) <= 0;
          if ((source.y <= 0) == (target.y <= 0)) continue;
          if (source.y <= 0 && side > 0) ++winding;
          if (target.y <= 0 && side < 0) --winding;
        }
        if (!is_on_one && winding > 0) return true;
      }
    return false;
  }

  // Along one line.

  /// Walks along the line of a track, and notes which tracks are on it.
  void walk(std::uint32_t along, std::vector<bool>& is_done) {
    first_ = sums_[tracks_[along].source];
    direction_ = sums_[tracks_[along].target] - first_;
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
        is_done[i] = true;
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
    error_ = (std::abs(dx) + std::abs(dy)) * largest_ * 4e-15;
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      if constexpr (is_large) {
        near_beside_[k] = dx * (near_[k].second - y) - dy * (near_[k].first - x);
        side_[k] = certain_sign(near_beside_[k], error_);
        if (side_[k] == 0) side_[k] = sign_of(beside(static_cast<std::uint32_t>(k)));
      } else {
        beside_[k] = skew(direction_, sums_[k] - first_);
        side_[k] = sign_of(beside_[k]);
      }
    }
  }

  T beside(std::uint32_t sum) const {
    if constexpr (is_large)
      return skew(direction_, sums_[sum] - first_);
    else
      return beside_[sum];
  }

  /// What doubles know of where a track crosses the line.
  Position<T> near_crossing(std::uint32_t track) const {
    if constexpr (!is_large) return {0, 0};
    const std::uint32_t from = tracks_[track].source, to = tracks_[track].target;
    const double a = near_beside_[from], b = near_beside_[to];
    const double from_at = is_vertical_ ? near_[from].second - as_double(first_.y)
                                        : near_[from].first - as_double(first_.x);
    const double length =
        is_vertical_ ? near_[to].second - near_[from].second : near_[to].first - near_[from].first;
    const double apart = std::abs(a - b);
    if (!(apart > 4 * error_)) return {0, std::numeric_limits<double>::infinity()};
    return {from_at + length * (a / (a - b)),
            std::abs(length) * (8 * error_ / apart) + largest_ * 1e-14};
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
    return is_vertical_ ? T(sums_[sum].y - first_.y) : T(sums_[sum].x - first_.x);
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
        boundary_.push_back({std::move(from), std::move(to)});
      } else if (in_left && has_both_ways_ && is_covered_both_ways(g)) {
        may_dangle_.push_back({point(position_of(g)), point(position_of(g + 1))});
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
      const double near = is_vertical_ ? near_[sum].second - as_double(first_.y)
                                       : near_[sum].first - as_double(first_.x);
      const int order = certain_sign(near - at.near, at.error + largest_ * 1e-14);
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
      if (track.is_reduced) passing.push_back(sums_[track.target] - sums_[track.source]);
    }
    for (const std::uint32_t i : on_line_) {
      if (!tracks_[i].is_reduced) continue;
      const auto [from, to] = ends_along(i);
      if (compare_end(from, group) < 0 && compare_end(to, group) > 0)
        passing.push_back(sums_[tracks_[i].target] - sums_[tracks_[i].source]);
    }
    if (passing.size() < 3) return;
    for (const Vec<T>& one : passing)
      for (const int side : {1, -1})
        if (std::all_of(passing.begin(), passing.end(),
                        [&](const Vec<T>& other) { return side * sign_of(skew(other, one)) <= 0; }))
          return;
    crossings_.push_back(point(position_of(group)));
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

  // What the definition decides.

  bool meet(const Point& x) const {
    const Point in_frame = frame_.factor * (x - frame_.first_of_p - frame_.first_of_q);
    return doubles_see_them_meet({in_frame.x.get_d(), in_frame.y.get_d()}) ||
           interiors_meet(region_p_, translated(region_minus_q_, x));
  }

  void decide_dangling(MinkowskiSum& open) const {
    std::vector<Segment> found;
    for (const Segment& piece : may_dangle_)
      if (!meet(midpoint(piece.source, piece.target))) found.push_back(piece);
    open.dangling_edges = maximal_segments(std::move(found));
  }

  void decide_isolated(MinkowskiSum& open) const {
    std::vector<Point> points = crossings_;
    for (std::uint32_t k = 0; k < sums_.size(); ++k)
      if (may_be_isolated_[k] && is_on_a_line_[k] && !certainly_meet(sums_[k]) &&
          !one_is_inside_the_other(sums_[k]))
        points.push_back(frame_.back(Rational(as_mpz(sums_[k].x)), Rational(as_mpz(sums_[k].y))));
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    for (const Point& x : points)
      if (!meet(x) && !lies_on_one(x, boundary_) && !lies_on_one(x, open.dangling_edges))
        open.isolated_vertices.push_back(x);
  }

  /// The tracks of the reduced convolution along each edge.
  Origins origins(const std::vector<Segment>& of_sum, bool either_way) const {
    const Point offset = frame_.first_of_p + frame_.first_of_q;
    Origins result(of_sum.size());
    for (std::size_t e = 0; e < of_sum.size(); ++e) {
      const Point source = frame_.factor * (of_sum[e].source - offset);
      const Point target = frame_.factor * (of_sum[e].target - offset);
      const double x = source.x.get_d(), y = source.y.get_d();
      for (const Track& track : tracks_) {
        if (!track.is_reduced) continue;
        const auto& [ax, ay] = near_[track.source];
        const auto& [bx, by] = near_[track.target];
        const double dx = bx - ax, dy = by - ay;
        const double off = dx * (y - ay) - dy * (x - ax);
        if (std::abs(off) > largest_ * largest_ * 1e-13) continue;
        const Segment s{exact(track.source), exact(track.target)};
        if ((either_way || sign(dot(direction_of(s), Vector(target - source))) > 0) &&
            overlap(s, {source, target}))
          result[e].push_back(track.origin);
      }
      std::sort(result[e].begin(), result[e].end());
    }
    return result;
  }

  Point exact(std::uint32_t sum) const {
    return {Rational(as_mpz(sums_[sum].x)), Rational(as_mpz(sums_[sum].y))};
  }

  const Region& region_p_;
  Region region_minus_q_;
  const Frame& frame_;
  Vertices<T> p_, q_;
  std::vector<Vec<double>> near_p_, near_q_;
  std::vector<Vec<T>> sums_;
  std::vector<std::pair<double, double>> near_;
  double largest_ = 1;  ///< of their coordinates
  std::vector<Track> tracks_;
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

  // What was found.
  std::vector<Segment> boundary_, may_dangle_;
  std::vector<Point> crossings_;
};

}  // namespace

SumsAlongLines sums_along_lines(const Region& p, const Region& q) {
  const Frame frame = frame_of(p, q);
  // Positions are compared in products of 5 bits + 9.
  if (frame.bits <= 10) return Lines<std::int64_t>(p, q, frame).sums();
  if (frame.bits <= 23) return Lines<Int128>(p, q, frame).sums();
  return Lines<mpz_class>(p, q, frame).sums();
}

}  // namespace oplus
