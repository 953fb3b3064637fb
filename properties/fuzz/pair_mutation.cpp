// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/pair_mutation.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

#include "properties/fuzz/realized_pair.hpp"
#include "reference/families/lattice_polygon.hpp"
#include "reference/families/rich_regions.hpp"

namespace oplus {

namespace {

using Vertices = std::vector<PlannedVertex>;

std::int8_t clamped(int value) {
  using Limits = std::numeric_limits<std::int8_t>;
  return static_cast<std::int8_t>(std::clamp<int>(value, Limits::min(), Limits::max()));
}

PlannedVertex on_grid(int x, int y) { return {clamped(x), clamped(y)}; }

PlannedVertex moved(PlannedVertex v, int dx, int dy) {
  v.x = clamped(v.x + dx);
  v.y = clamped(v.y + dy);
  return v;
}

/// By at most so much along each axis.
void move_all(Random& random, Vertices& vertices, int most) {
  const int dx = uniform(random, -most, most), dy = uniform(random, -most, most);
  for (PlannedVertex& v : vertices) v = moved(v, dx, dy);
}

PlannedVertex opposite(const PlannedVertex& v) {
  const auto jitter = [](int value) { return static_cast<std::int8_t>(std::min(-value, 7)); };
  return {clamped(-v.x), clamped(-v.y), jitter(v.jitter_x), jitter(v.jitter_y)};
}

template <typename T>
T& one_of(Random& random, std::vector<T>& all) {
  return all[uniform_index(random, all.size())];
}

template <typename T>
void erase_one_of(Random& random, std::vector<T>& all) {
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(uniform_index(random, all.size())));
}

template <typename All>
std::uint8_t a_place_in(Random& random, const All& all) {
  return static_cast<std::uint8_t>(uniform_index(random, all.size()));
}

/// A summand, and the other.
std::pair<PlannedSummand&, PlannedSummand&> both(Random& random, PairPlan& plan) {
  if (one_in(random, 2)) return {plan.p, plan.q};
  return {plan.q, plan.p};
}

PlannedSummand& a_summand(Random& random, PairPlan& plan) { return both(random, plan).first; }

PlannedChain& a_chain(Random& random, PairPlan& plan) {
  return one_of(random, a_summand(random, plan).chains);
}

/// What all changes require: there are chains to draw.
bool can_be_changed(const PairPlan& plan) {
  return !plan.p.chains.empty() && !plan.q.chains.empty();
}

std::size_t vertices_in(const PlannedSummand& summand) {
  std::size_t n = 0;
  for (const PlannedChain& chain : summand.chains) n += chain.vertices.size();
  return n;
}

/// Most summands stay as small as this, since faults show on few vertices; `enlarge` makes others.
constexpr std::size_t few_vertices = 10;

bool has_room(const PlannedSummand& summand, std::size_t more) {
  return summand.chains.size() < most_chains && vertices_in(summand) + more <= few_vertices;
}

/// The vertices of a chain more; fewer than 3 where there is no room.
std::size_t most_for_one_more(const PlannedSummand& summand) {
  return has_room(summand, 3) ? std::min<std::size_t>(few_vertices - vertices_in(summand), 5) : 0;
}

Vertices vertices_of(const Chain& chain) {
  Vertices result;
  for (const Point& v : chain)
    result.push_back(on_grid(static_cast<int>(v.x.get_d()), static_cast<int>(v.y.get_d())));
  return result;
}

bool is_small(const Vertices& vertices) {
  const auto extent = [&](std::int8_t PlannedVertex::*axis) {
    const auto [low, high] = std::minmax_element(
        vertices.begin(), vertices.end(),
        [&](const PlannedVertex& a, const PlannedVertex& b) { return a.*axis < b.*axis; });
    return (*high).*axis - (*low).*axis;
  };
  return extent(&PlannedVertex::x) <= 24 && extent(&PlannedVertex::y) <= 24;
}

// Vertices.

bool move_vertex(Random& random, PairPlan& plan) {
  const int most = one_in(random, 4) ? 20 : 2;
  const int dx = uniform(random, -most, most), dy = uniform(random, -most, most);
  PlannedVertex& v = one_of(random, a_chain(random, plan).vertices);
  v = moved(v, dx, dy);
  return true;
}

/// A point of the grid inside a straight edge, if there is one.
std::optional<PlannedVertex> inside_edge(Random& random, const PlannedVertex& a,
                                         const PlannedVertex& b) {
  const int parts = std::gcd(b.x - a.x, b.y - a.y);
  if (parts < 2) return std::nullopt;
  const int part = uniform(random, 1, parts - 1);
  return moved(a, (b.x - a.x) / parts * part, (b.y - a.y) / parts * part);
}

std::optional<PlannedVertex> near_edge(Random& random, const PlannedVertex& a,
                                       const PlannedVertex& b) {
  const int dx = uniform(random, -3, 3), dy = uniform(random, -3, 3);
  return on_grid((a.x + b.x) / 2 + dx, (a.y + b.y) / 2 + dy);
}

/// One vertex more, between both ends of an edge: where `between` says.
template <auto between>
bool grow(Random& random, PairPlan& plan) {
  PlannedSummand& summand = a_summand(random, plan);
  if (vertices_in(summand) >= few_vertices) return false;
  Vertices& vertices = one_of(random, summand.chains).vertices;
  if (vertices.size() == most_vertices) return false;
  const std::size_t i = uniform_index(random, vertices.size());
  const auto more = between(random, vertices[i], vertices[next(i, vertices.size())]);
  if (more) vertices.insert(vertices.begin() + static_cast<std::ptrdiff_t>(i) + 1, *more);
  return more.has_value();
}

bool remove_vertex(Random& random, PairPlan& plan) {
  Vertices& vertices = a_chain(random, plan).vertices;
  if (vertices.size() <= 3) return false;
  erase_one_of(random, vertices);
  return true;
}

std::optional<PlannedVertex> first_end(Random& /*no choice*/, const PlannedVertex& a,
                                       const PlannedVertex& /*b*/) {
  return a;
}

/// A vertex onto an edge of another chain of the summand, where `onto` says, so that the two touch.
template <auto onto>
bool touch(Random& random, PairPlan& plan) {
  PlannedSummand& summand = a_summand(random, plan);
  if (summand.chains.size() < 2) return false;
  Vertices& moving = one_of(random, summand.chains).vertices;
  const Vertices& other = one_of(random, summand.chains).vertices;
  if (&moving == &other) return false;
  const std::size_t i = uniform_index(random, other.size());
  const auto place = onto(random, other[i], other[next(i, other.size())]);
  if (place) one_of(random, moving) = *place;
  return place.has_value();
}

/// An edge becomes parallel to one of the other summand, or just as long.
bool make_parallel(Random& random, PairPlan& plan) {
  const auto [changed, other] = both(random, plan);
  const Vertices& from = one_of(random, other.chains).vertices;
  const std::size_t i = uniform_index(random, from.size());
  const PlannedVertex& a = from[i];
  const PlannedVertex& b = from[next(i, from.size())];
  Vertices& vertices = one_of(random, changed.chains).vertices;
  const std::size_t j = uniform_index(random, vertices.size());
  const int side = one_in(random, 2) ? 1 : -1;
  const int times = side * (one_in(random, 3) ? 2 : 1);
  vertices[next(j, vertices.size())] = moved(vertices[j], times * (b.x - a.x), times * (b.y - a.y));
  return true;
}

// Chains.

bool add_component(Random& random, PairPlan& plan) {
  PlannedSummand& summand = a_summand(random, plan);
  const std::size_t most = most_for_one_more(summand);
  if (most < 3) return false;
  Vertices vertices = vertices_of(lattice_polygon(random, uniform(random, 2, 4), most));
  move_all(random, vertices, 12);
  summand.chains.push_back({false, std::move(vertices)});
  return true;
}

/// A hole in a component, or an island in a hole.
bool add_inside(Random& random, PairPlan& plan) {
  PlannedSummand& summand = a_summand(random, plan);
  const std::size_t most = most_for_one_more(summand);
  if (most < 3) return false;
  const PlannedChain& around = one_of(random, summand.chains);
  Chain chain;
  for (const PlannedVertex& v : around.vertices) chain.push_back({v.x, v.y});
  // All grid points inside are listed, and those of no polygon may be too few.
  if (!is_small(around.vertices) || sign(twice_area(chain)) == 0) return false;
  const auto inside = lattice_polygon_within(random, chain, most);
  if (!inside) return false;
  summand.chains.push_back({!around.is_hole, vertices_of(*inside)});
  return true;
}

bool remove_chain(Random& random, PairPlan& plan) {
  PlannedSummand& summand = a_summand(random, plan);
  if (summand.chains.size() < 2) return false;
  erase_one_of(random, summand.chains);
  return true;
}

bool move_chain(Random& random, PairPlan& plan) {
  move_all(random, a_chain(random, plan).vertices, 4);
  return true;
}

bool copy_chain(Random& random, PairPlan& plan) {
  PlannedChain copy = a_chain(random, plan);
  PlannedSummand& to = a_summand(random, plan);
  if (!has_room(to, copy.vertices.size())) return false;
  move_all(random, copy.vertices, 12);
  to.chains.push_back(std::move(copy));
  return true;
}

/// A component that fits a hole of the other summand, turned by half a turn, in one place only; or
/// that is narrower, and slides in it.
bool fit_hole(Random& random, PairPlan& plan) {
  const auto [around, fitted] = both(random, plan);
  std::vector<const PlannedChain*> holes;
  for (const PlannedChain& chain : around.chains)
    if (chain.is_hole) holes.push_back(&chain);
  if (holes.empty()) return false;
  PlannedChain piece{false, one_of(random, holes)->vertices};
  for (PlannedVertex& v : piece.vertices) v = opposite(v);
  if (one_in(random, 2)) {  // narrower: what is farthest right moves to the left
    const auto right = std::max_element(piece.vertices.begin(), piece.vertices.end())->x;
    for (PlannedVertex& v : piece.vertices)
      if (v.x == right) v = moved(v, -1, 0);
  }
  if (one_in(random, 2) || !has_room(fitted, piece.vertices.size())) fitted.chains.clear();
  fitted.chains.push_back(std::move(piece));
  return true;
}

// Summands.

PlannedSummand new_summand(Random& random) {
  const int kind = uniform(random, 0, 7);
  while (true) {
    const Region region = kind <= 2   ? plain_region(random, 4)
                          : kind == 3 ? plain_region(random, 8)
                          : kind <= 5 ? scattered_region(random, 4)
                                      : holed_region(random, 4);
    if (vertex_count(region) > few_vertices && !one_in(random, 16)) continue;
    // A plan takes regions of a limited size only.
    if (const auto plan = plan_of(Summands{region, region})) return plan->p;
  }
}

bool renew_summand(Random& random, PairPlan& plan) {
  a_summand(random, plan).chains = new_summand(random).chains;
  return true;
}

/// Polygons beside each other, with as many vertices as there is room for.
PlannedSummand large_summand(Random& random, std::size_t most) {
  PlannedSummand summand;
  for (int k = 0; k < int{most_chains}; ++k) {
    const std::size_t room = most - vertices_in(summand);
    if (room < 3) break;
    Vertices vertices = vertices_of(lattice_polygon(random, 8, std::min(room, most_vertices)));
    for (PlannedVertex& v : vertices) v = moved(v, 9 * (k % 3), 9 * (k / 3));
    summand.chains.push_back({false, std::move(vertices)});
  }
  return summand;
}

/// As many vertices as a chain may have; each edge is parallel to another one.
PlannedSummand convex_summand(Random& random) {
  constexpr std::array<std::array<int, 2>, 8> directions{
      {{1, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 1}, {-1, 2}, {-1, 1}, {-2, 1}}};
  std::array<int, 8> lengths;
  for (int& length : lengths) length = uniform(random, 1, 3);
  Vertices vertices;
  PlannedVertex v{};
  for (const int side : {1, -1})
    for (std::size_t i = 0; i < directions.size(); ++i) {
      vertices.push_back(v);
      v = moved(v, side * lengths[i] * directions[i][0], side * lengths[i] * directions[i][1]);
    }
  return {{{false, std::move(vertices)}}};
}

/// So many pairs of edges that slide searches boxes instead of all of them.
bool enlarge(Random& random, PairPlan& plan) {
  if (!one_in(random, 12)) return false;
  const auto [larger, other] = both(random, plan);
  const bool is_convex = one_in(random, 2);
  constexpr std::size_t many_vertices = 24;
  larger.chains = large_summand(random, is_convex ? most_vertices_in_all : many_vertices).chains;
  other.chains = (is_convex ? convex_summand(random) : large_summand(random, many_vertices)).chains;
  return true;
}

bool swap_summands(Random& /*no choice*/, PairPlan& plan) {
  std::swap(plan.p, plan.q);
  return true;
}

/// Q becomes P or -P.
bool copy_summand(Random& random, PairPlan& plan) {
  plan.q = plan.p;
  if (one_in(random, 2)) return true;
  for (PlannedChain& chain : plan.q.chains)
    for (PlannedVertex& v : chain.vertices) v = opposite(v);
  return true;
}

/// A summand mirrored, turned by a quarter, or twice as large.
bool map_summand(Random& random, PairPlan& plan) {
  const int how = uniform(random, 0, 2);
  for (PlannedChain& chain : a_summand(random, plan).chains)
    for (PlannedVertex& v : chain.vertices)
      v = how == 0 ? on_grid(-v.x, v.y) : how == 1 ? on_grid(-v.y, v.x) : on_grid(2 * v.x, 2 * v.y);
  return true;
}

// Numbers.

bool change_magnitude(Random& random, PairPlan& plan) {
  plan.magnitude = a_place_in(random, magnitudes);
  return true;
}

bool change_shear(Random& /*no choice*/, PairPlan& plan) {
  plan.is_sheared = !plan.is_sheared;
  return true;
}

bool change_denominator(Random& random, PairPlan& plan) {
  const std::uint8_t denominator = a_place_in(random, denominators());
  a_summand(random, plan).denominator = denominator;
  if (one_in(random, 2)) plan.p.denominator = plan.q.denominator = denominator;
  return true;
}

bool change_offset(Random& random, PairPlan& plan) {
  a_summand(random, plan).offset = a_place_in(random, offsets());
  return true;
}

/// Off the grid by little, all vertices in that place alike or one alone.
bool change_jitter(Random& random, PairPlan& plan) {
  PlannedSummand& summand = a_summand(random, plan);
  PlannedVertex& one = one_of(random, one_of(random, summand.chains).vertices);
  const PlannedVertex before = one;
  one.jitter_x = static_cast<std::int8_t>(uniform(random, -8, 7));
  one.jitter_y = static_cast<std::int8_t>(uniform(random, -8, 7));
  const PlannedVertex after = one;
  if (one_in(random, 2))
    for (PlannedChain& chain : summand.chains)
      std::replace(chain.vertices.begin(), chain.vertices.end(), before, after);
  return true;
}

bool is_good(const PairPlan& plan) {
  const auto pair = realized(plan);
  return pair && pair->is_as_planned();
}

}  // namespace

const std::vector<PairChange>& pair_changes() {
  static const std::vector<PairChange> all{
      {"add_component", add_component},
      {"add_inside", add_inside},
      {"change_denominator", change_denominator},
      {"change_jitter", change_jitter},
      {"change_magnitude", change_magnitude},
      {"change_offset", change_offset},
      {"change_shear", change_shear},
      {"copy_chain", copy_chain},
      {"copy_summand", copy_summand},
      {"enlarge", enlarge},
      {"fit_hole", fit_hole},
      {"insert_vertex", grow<near_edge>},
      {"make_parallel", make_parallel},
      {"map_summand", map_summand},
      {"move_chain", move_chain},
      {"move_vertex", move_vertex},
      {"remove_chain", remove_chain},
      {"remove_vertex", remove_vertex},
      {"renew_summand", renew_summand},
      {"split_edge", grow<inside_edge>},
      {"swap_summands", swap_summands},
      {"touch_edge", touch<inside_edge>},
      {"touch_vertex", touch<first_end>},
  };
  return all;
}

PairPlan new_plan(Random& random) {
  PairPlan plan;
  plan.p = new_summand(random);
  plan.q = new_summand(random);
  if (one_in(random, 4)) change_magnitude(random, plan);
  return plan;
}

std::string mutated_pair(Random& random, std::string_view bytes) {
  PairPlan plan = decoded(bytes);
  // Large pairs take most of the time, so they have few descendants.
  for (PlannedSummand* const summand : {&plan.p, &plan.q})
    if (vertices_in(*summand) > few_vertices && !one_in(random, 4))
      summand->chains = new_summand(random).chains;
  for (int tries = can_be_changed(plan) ? 16 : 0; tries > 0; --tries) {
    PairPlan changed = plan;
    for (int changes = uniform(random, 1, 3); changes > 0; --changes)
      pair_changes()[uniform_index(random, pair_changes().size())].apply(random, changed);
    if (changed != plan && is_good(changed)) return encoded(changed);
  }
  return encoded(new_plan(random));
}

std::string crossed_pair(Random& random, std::string_view bytes_of_a, std::string_view bytes_of_b) {
  PairPlan a = decoded(bytes_of_a), b = decoded(bytes_of_b);
  for (int tries = can_be_changed(a) && can_be_changed(b) ? 8 : 0; tries > 0; --tries) {
    PairPlan crossed = one_in(random, 2) ? a : b;
    crossed.p = one_in(random, 2) ? a.p : b.q;
    crossed.q = one_in(random, 2) ? b.p : a.q;
    if (one_in(random, 2)) {  // a chain more, from anywhere
      const PlannedChain& chain = a_chain(random, one_in(random, 2) ? a : b);
      PlannedSummand& to = a_summand(random, crossed);
      if (has_room(to, chain.vertices.size())) to.chains.push_back(chain);
    }
    if (is_good(crossed)) return encoded(crossed);
  }
  return encoded(new_plan(random));
}

}  // namespace oplus
