// SPDX-License-Identifier: GPL-3.0-or-later
// Compares predicates with those that were proved and extracted (properties/proofs/extraction/), on
// all of small domains. With mutants compiled in, it also demands that each fault is seen.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>

#include "checked/arrangement/ray_shooting.hpp"
#include "checked/cycles/convolution_cycles.hpp"
#include "checked/cycles/cycle_tracing.hpp"
#include "properties/compare/grid_polygons.hpp"
#include "properties/runner/child_process.hpp"
#include "properties/runner/temporary_folder.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/validity.hpp"
#include "reference/definitions/collision.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/signed_crossings.hpp"
#include "reference/definitions/tangent_count.hpp"
#include "reference/definitions/tangent_set.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

struct Pair {
  const Region* p;
  const Region* q;
};

// What is asked about, in words, and for regions and pairs as the extracted program reads them.

std::string words(const Point& p) { return to_string(p); }

std::string words(const Segment& s) { return to_string(s.source) + " to " + to_string(s.target); }

std::string words(const Direction& d) {
  return to_string(d.vector) + (d.of == Summand::P ? " of P" : " of Q");
}

std::string words(const Region& region) {
  std::string all;
  for (const Chain& chain : chains(region)) {
    if (!all.empty()) all += " ; ";
    for (std::size_t i = 0; i < chain.size(); ++i)
      all += (i == 0 ? "" : " ") + to_string(chain[i].x) + " " + to_string(chain[i].y);
  }
  return all;
}

std::string words(const Pair& pair) { return words(*pair.p) + " | " + words(*pair.q); }

// Answers, as tables have them.

std::string written(std::string text) { return text; }

std::string written(bool value) { return value ? "1" : "0"; }

/// 0 to 9, and what follows in ASCII for more; a for -1, b for -2, and so on.
std::string written(int value) {
  return std::string(1, static_cast<char>(value >= 0 ? '0' + value : 'a' - 1 - value));
}

std::string written(Location where) {
  return where == Location::outside ? "o" : where == Location::boundary ? "b" : "i";
}

std::string order(int compared) { return compared < 0 ? "<" : compared > 0 ? ">" : "="; }

/// f of each combination, the last set's elements changing fastest.
template <typename F>
void each(const F& f) {
  f();
}

template <typename F, typename Set, typename... Sets>
void each(const F& f, const Set& set, const Sets&... sets) {
  for (const auto& one : set) each([&](const auto&... others) { f(one, others...); }, sets...);
}

/// The answers on each combination, one after another.
template <typename Answer, typename... Sets>
std::string answers(const Answer& answer, const Sets&... sets) {
  std::string all;
  each([&](const auto&... asked) { all += written(answer(asked...)); }, sets...);
  return all;
}

/// Reads a table along with what the C++ code says.
class Comparison {
 public:
  struct Seen {};

  /// Throws Seen at the first difference if no more is to be known.
  Comparison(const std::string& proved, bool until_seen)
      : proved_(proved), until_seen_(until_seen) {}

  template <typename... Asked>
  void answer(const std::string& here, const Asked&... asked) {
    for (std::size_t i = 0; i < here.size(); ++i) {
      const char proved = entries_ < proved_.size() ? proved_[entries_] : '?';
      ++entries_;
      if (here[i] == proved) continue;
      if (differences_++ == 0) {
        ((first_ += words(asked) + ", "), ...);
        first_ += "answer " + std::to_string(i + 1) + ": proved " + shown(proved) +
                  ", but C++ says " + shown(here[i]);
      }
      if (until_seen_) throw Seen{};
    }
  }

  void broken_contract(const std::string& what) {
    if (differences_++ == 0) first_ = what;
  }

  /// What differs, or none.
  std::optional<std::string> difference() const {
    if (differences_ > 0) return first_ + "; " + std::to_string(differences_) + " differ";
    if (entries_ != proved_.size() || entries_ == 0)
      return std::to_string(entries_) + " entries, but " + std::to_string(proved_.size()) +
             " in the table of the proved predicate";
    return std::nullopt;
  }

  std::size_t entries() const { return entries_; }

 private:
  static std::string shown(char c) { return c == '\n' ? "end of line" : std::string{'`', c, '`'}; }

  const std::string& proved_;
  bool until_seen_;
  std::size_t entries_ = 0;
  std::size_t differences_ = 0;
  std::string first_;
};

/// A predicate of ours, and which of the tables says what it should be.
struct Predicate {
  std::string name;
  std::vector<std::string> table;  ///< arguments of the extracted program
  std::function<void(Comparison&)> compare;
};

/// The comparison of the answers on each combination. The sets must outlive it.
template <typename Answer, typename... Sets>
std::function<void(Comparison&)> on(Answer answer, Sets&... sets) {
  return [answer, &sets...](Comparison& table) {
    each([&](const auto&... asked) { table.answer(written(answer(asked...)), asked...); }, sets...);
  };
}

std::vector<Point> grid(int least, int most, int denominator = 1) {
  std::vector<Point> all;
  for (int x = least; x <= most; ++x)
    for (int y = least; y <= most; ++y)
      all.push_back({Rational(x) / denominator, Rational(y) / denominator});
  return all;
}

/// Of grid(0, 8), with the corners.
std::vector<Point> some_places() {
  std::vector<Point> all;
  for (const int x : {0, 1, 4, 6, 8})
    for (const int y : {0, 1, 4, 6, 8}) all.push_back({x, y});
  return all;
}

std::vector<Vector> vectors() {
  std::vector<Vector> all = grid(-3, 3);
  all.erase(std::find(all.begin(), all.end(), Vector{0, 0}));
  return all;
}

std::vector<Direction> directions() {
  std::vector<Direction> all;
  for (const Vector& v : vectors())
    for (const Summand of : {Summand::P, Summand::Q}) all.push_back({v, of});
  return all;
}

/// Those between points of a grid, but for points.
std::vector<Segment> segments_of_a_grid() {
  std::vector<Segment> all;
  const std::vector<Point> ends = grid(-2, 2);
  for (const Point& source : ends)
    for (const Point& target : ends)
      if (source != target) all.push_back({source, target});
  return all;
}

Chain box(int left, int below, int right, int above) {
  return {{left, below}, {right, below}, {right, above}, {left, above}};
}

Chain clockwise(Chain chain) {
  std::reverse(chain.begin(), chain.end());
  return chain;
}

/// Regions from 0 to 4 with holes and components that touch in all ways.
std::vector<Region> regions_with_holes() {
  const Chain plate = box(0, 0, 4, 4);
  const std::vector<Region> all = {
      {{{plate, {clockwise(box(1, 1, 3, 3))}}}},
      {{{plate, {{{1, 1}, {2, 3}, {3, 1}}}}}},
      // A hole that touches the outer chain inside an edge, and at a vertex.
      {{{plate, {{{0, 2}, {2, 3}, {2, 1}}}}}},
      {{{plate, {{{0, 0}, {1, 3}, {3, 1}}}}}},
      // Holes that touch each other.
      {{{plate, {clockwise(box(1, 1, 2, 2)), clockwise(box(2, 2, 3, 3))}}}},
      {{{plate, {{{1, 1}, {1, 3}, {2, 2}}, {{2, 1}, {2, 3}, {3, 2}}}}}},
      // Components that touch: vertex on vertex, vertex on edge.
      {{{box(0, 0, 2, 2), {}}, {box(2, 2, 4, 4), {}}}},
      {{{{{0, 0}, {4, 0}, {2, 2}}, {}}, {box(1, 2, 3, 4), {}}}},
      // A component that fills a part of a hole, and touches it.
      {{{plate, {clockwise(box(1, 1, 3, 3))}}, {{{2, 1}, {3, 2}, {2, 3}, {1, 2}}, {}}}},
      {{{plate, {clockwise(box(1, 1, 3, 3))}}, {{{1, 1}, {3, 2}, {2, 3}}, {}}}},
      // No holes, but what fits into them.
      {{{box(0, 0, 2, 2), {}}}},
      {{{box(0, 0, 1, 1), {}}}},
      {{{{{1, 0}, {2, 1}, {1, 2}, {0, 1}}, {}}}},
      {{{{{0, 0}, {2, 0}, {1, 2}}, {}}}},
      {{{{{0, 0}, {4, 0}, {4, 4}, {2, 1}}, {}}}},
  };
  for (const Region& region : all)
    if (find_defect(region)) throw std::logic_error("not valid: " + words(region));
  return all;
}

/// A plate with a hole of the shape of each polygon.
std::vector<Region> plates(const std::vector<Region>& polygons) {
  std::vector<Region> all;
  for (const Region& polygon : polygons)
    all.push_back({{{box(0, 0, 4, 4),
                     {clockwise(translated(polygon.components.front().outer, Vector{1, 1}))}}}});
  return all;
}

/// On 3 x 3 points.
std::vector<Region> polygons_with(std::size_t most_vertices) {
  std::vector<Region> all;
  for (const GridPolygon& polygon : grid_polygons(3, most_vertices))
    all.push_back(region_of(polygon));
  return all;
}

std::vector<Pair> pairs_of(const std::vector<Region>& ps, const std::vector<Region>& qs) {
  std::vector<Pair> all;
  each([&](const Region& p, const Region& q) { all.push_back({&p, &q}); }, ps, qs);
  return all;
}

/// One of each class of all polygons, of every other class: from the first or the second on.
std::vector<Pair> orbits_of(const std::vector<Region>& polygons, std::size_t first) {
  const auto orbits = pair_orbits(grid_polygons(3, 9));
  std::vector<Pair> all;
  for (std::size_t i = first; i < orbits.size(); i += 2)
    all.push_back({&polygons[orbits[i].first], &polygons[orbits[i].second]});
  return all;
}

// What some tables say of one region or pair.

/// To the right of segments between grid points.
std::string shots(const Region& polygon) {
  const RayShooting rays(edges(polygon));
  const std::vector<Point> ends = grid(-3, 3);
  const auto shot = [&](const Point& source, const Point& target) {
    return source == target ? "" : written(rays.winding_number_right_of({source, target}));
  };
  return answers(shot, ends, ends);
}

/// What the theorems on chains ask for, and is not proved of simple polygons: they turn once, holes of
/// their shape once backwards. On valid regions it is what twice_area tells.
std::string turnings(const Region& polygon) {
  const Chain chain = chains(polygon).front();
  return written(sign(twice_area(chain))) + written(sign(twice_area(clockwise(chain))));
}

/// A chain with the corner at its vertex 1; vertex 3 is far from all others.
bool in_traced_tangent_set(const Direction& d, const Vector& in, const Vector& out) {
  return TracedChain({-in, {0, 0}, out, {100, 37}}, other(d.of))
      .has_in_tangent_set(1, FilteredDirection(d));
}

/// Of paths of two steps, one of which may have length zero.
std::string crossings(const Region& region, int most) {
  const std::vector<Segment> boundary = edges(region);
  const std::vector<Point> points = grid(0, most);
  return answers(
      [&](const Point& a, const Point& b, const Point& c) {
        return signed_crossings({a, b, c}, boundary);
      },
      points, points, points);
}

/// A line of coordinates: segments by chain of P, chain of Q, along whose edge, vertex of P, vertex of Q.
template <typename Named, typename Origins>
std::string segments_in_order(const Pair& pair, const Origins& origins) {
  const std::vector<Chain> of_p = chains(*pair.p), of_q = chains(*pair.q);
  std::multimap<std::tuple<std::size_t, std::size_t, Summand, std::size_t, std::size_t>, Segment>
      all;
  for (const Named& named : origins) {
    const Origin& origin = named.origin;
    const bool along_p = origin.edge_of == Summand::P;
    const auto [a, i] = along_p ? origin.edge : origin.vertex;
    const auto [b, j] = along_p ? origin.vertex : origin.edge;
    const Chain &p = of_p[a], &q = of_q[b];
    const Segment segment{p[i] + q[j],
                          along_p ? p[next(i, p.size())] + q[j] : p[i] + q[next(j, q.size())]};
    if constexpr (std::is_same_v<Named, ConvolutionSegment>)
      if (segment != named.segment) return "?";
    all.insert({{a, b, origin.edge_of, i, j}, segment});
  }
  std::string text;
  for (const auto& [name, s] : all)
    for (const Rational* value : {&s.source.x, &s.source.y, &s.target.x, &s.target.y})
      text += written(static_cast<int>(value->get_d()));
  return text + '\n';
}

std::string segments_of_the_definition(const Pair& pair) {
  return segments_in_order<ConvolutionSegment>(pair, convolution(*pair.p, *pair.q));
}

std::string traced_segments(const Pair& pair) {
  return segments_in_order<TracedOrigin>(pair, traced_origins(*pair.p, *pair.q));
}

/// Cycles, line by line, and the number of states looked at.
std::string cycles(const Pair& pair) {
  const GridCycles all = trace_cycles(TracedChain(chains(*pair.p).front(), Summand::P),
                                      TracedChain(chains(*pair.q).front(), Summand::Q));
  std::string text;
  for (const GridCycle& cycle : all.cycles) {
    text += std::to_string(cycle.i) + " " + std::to_string(cycle.j) + " ";
    for (const Summand along : cycle.steps) text += along == Summand::P ? 'P' : 'Q';
    text += '\n';
  }
  return text + std::to_string(all.states_looked_at) + '\n';
}

bool is_collision(const Pair& pair, const Point& x) {
  return interiors_meet(*pair.p, translated(reflected(*pair.q), x));
}

/// What is asked about, and the files by which the extracted program knows it.
struct Domains {
  std::vector<Point> ends = grid(-3, 3), halves = grid(-3, 3, 2);
  std::vector<Vector> all_vectors = vectors();
  std::vector<Direction> all_directions = directions();
  std::vector<Segment> steps = segments_of_a_grid();
  std::vector<Region> few = polygons_with(4), all_polygons = polygons_with(9),
                      plates_with_a_hole = plates(few), regions = regions_with_holes();
  std::vector<Pair> few_pairs = pairs_of(few, few), even_orbits = orbits_of(all_polygons, 0),
                    odd_orbits = orbits_of(all_polygons, 1),
                    in_holes = pairs_of(plates_with_a_hole, few),
                    of_regions = pairs_of(regions, regions);
  std::vector<Point> in_polygons = grid(0, 4, 2), in_regions = grid(0, 8, 2);
  std::vector<Point> one = {{2, 2}}, two = {{2, 2}, {Rational(5, 2), Rational(3, 2)}},
                     three = {{2, 2}, {Rational(5, 2), Rational(3, 2)}, {3, 1}}, in_hole = {{3, 3}},
                     between = {{Rational(5, 2), Rational(3, 2)}}, places = some_places();
  std::vector<Vector> some_directions = {{1, 0}, {-1, 1}, {-1, -2}};
  TemporaryFolder folder{"oplus-extracted"};

  /// A file with a line for each of the set.
  template <typename Set>
  std::string file(const Set& set, const std::string& name) const {
    const std::string path = (folder.path() / name).string();
    std::ofstream lines(path);
    for (const auto& one_of_them : set) lines << words(one_of_them) << '\n';
    if (!lines.flush()) throw std::runtime_error("cannot write " + path);
    return path;
  }
};

/// The arguments, and after them points by twice their coordinates.
std::vector<std::string> with(std::vector<std::string> arguments,
                              const std::vector<Point>& points) {
  for (const Point& p : points)
    for (const Rational& value : {p.x, p.y}) arguments.push_back(to_string(Rational(2 * value)));
  return arguments;
}

std::vector<Predicate> predicates(const Domains& of) {
  const std::string few = of.file(of.few, "few"), polygons = of.file(of.all_polygons, "polygons"),
                    plates = of.file(of.plates_with_a_hole, "plates"),
                    regions = of.file(of.regions, "regions"),
                    few_pairs = of.file(of.few_pairs, "few_pairs"),
                    even = of.file(of.even_orbits, "even"), odd = of.file(of.odd_orbits, "odd"),
                    in_holes = of.file(of.in_holes, "in_holes"),
                    of_regions = of.file(of.of_regions, "of_regions");
  const auto is_valid = [](const Region& region) { return !find_defect(region); };
  const auto location = [](const Region& region, const Point& p) { return locate(p, region); };
  const auto windings = [](const std::vector<Point>& xs) {
    return [&xs](const Pair& pair) {
      const std::vector<Segment> all = segments(convolution(*pair.p, *pair.q));
      return answers([&](const Point& x) { return winding_number(x, all); }, xs);
    };
  };
  const auto tangents = [](const Pair& pair, const Point& x, const Vector& d) {
    return tangent_count(x, *pair.p, *pair.q, d);
  };
  return {
      {"compare, of directions",
       {"orders", "3"},
       on([](const Direction& a, const Direction& b) { return order(compare(a, b)); },
          of.all_directions, of.all_directions)},
      {"compare, of filtered directions",
       {"orders", "3"},
       on(
           [](const Direction& a, const Direction& b) {
             return order(compare(FilteredDirection(a), FilteredDirection(b)));
           },
           of.all_directions, of.all_directions)},
      {"counterclockwise_between",
       {"betweens", "3"},
       on([](const Direction& d, const Direction& from,
             const Direction& to) { return counterclockwise_between(d, from, to); },
          of.all_directions, of.all_directions, of.all_directions)},
      {"is_reflex",
       {"reflex", "3"},
       on(
           [](const Vector& in, const Vector& out) {
             return is_reflex({in, out});
           },
           of.all_vectors, of.all_vectors)},
      {"in_tangent_set",
       {"tangents", "3"},
       on(
           [](const Direction& d, const Vector& in, const Vector& out) {
             return in_tangent_set(d, {in, out});
           },
           of.all_directions, of.all_vectors, of.all_vectors)},
      {"TracedChain::has_in_tangent_set",
       {"tangents", "3"},
       on(in_traced_tangent_set, of.all_directions, of.all_vectors, of.all_vectors)},
      {"winding_number, of a segment",
       {"crossings", "3"},
       on(
           [](const Point& p, const Point& source, const Point& target) {
             return winding_number(p, {{source, target}});
           },
           of.halves, of.ends, of.ends)},
      {"winding_number, of a polygon",
       {"windings", "3", few},
       on([](const Region& polygon, const Point& p) { return winding_number(p, edges(polygon)); },
          of.few, of.halves)},
      {"winding_number_right_of", {"shots", "3", few}, on(shots, of.few)},
      {"twice_area, its sign", {"turnings", few}, on(turnings, of.few)},
      {"trace_cycles", {"cycles", few_pairs}, on(cycles, of.few_pairs)},
      {"signed_crossing",
       {"steps", "2"},
       on([](const Segment& step,
             const Segment& s) { return signed_crossing(step.source, step.target, s); },
          of.steps, of.steps)},
      {"signed_crossings, of polygons",
       {"paths", "2", few},
       on([](const Region& polygon) { return crossings(polygon, 2); }, of.few)},
      {"signed_crossings, of regions",
       {"paths", "3", regions},
       on([](const Region& region) { return crossings(region, 3); }, of.regions)},
      // Whether what the theorems on regions ask for is there. The proved check asks for more: chains
      // that touch have vertices there.
      {"find_defect, of polygons", {"validities", polygons}, on(is_valid, of.all_polygons)},
      {"find_defect, of plates with a hole",
       {"validities", plates},
       on(is_valid, of.plates_with_a_hole)},
      {"locate, in polygons",
       {"locations", "2", polygons},
       on(location, of.all_polygons, of.in_polygons)},
      {"locate, in regions", {"locations", "4", regions}, on(location, of.regions, of.in_regions)},
      {"interiors_meet, of polygons on one grid", with({"collisions", even}, of.one),
       on(is_collision, of.even_orbits, of.one)},
      {"interiors_meet, of polygons between grids", with({"collisions", odd}, of.between),
       on(is_collision, of.odd_orbits, of.between)},
      {"interiors_meet, of plates with a hole and polygons",
       with({"collisions", in_holes}, of.in_hole), on(is_collision, of.in_holes, of.in_hole)},
      {"interiors_meet, of regions", with({"collisions", of_regions}, of.places),
       on(is_collision, of.of_regions, of.places)},
      {"convolution, of polygons",
       {"convolutions", few_pairs},
       on(segments_of_the_definition, of.few_pairs)},
      {"convolution, of regions",
       {"convolutions", of_regions},
       on(segments_of_the_definition, of.of_regions)},
      {"traced_origins, of polygons",
       {"convolutions", few_pairs},
       on(traced_segments, of.few_pairs)},
      {"traced_origins, of regions",
       {"convolutions", of_regions},
       on(traced_segments, of.of_regions)},
      {"winding_number, of the convolution of polygons",
       with({"convolution-windings", few_pairs}, of.two), on(windings(of.two), of.few_pairs)},
      {"winding_number, of the convolution of regions",
       with({"convolution-windings", of_regions}, of.places),
       on(windings(of.places), of.of_regions)},
      {"tangent_count, of polygons", with({"tangent-counts", few_pairs}, of.one),
       on(tangents, of.few_pairs, of.one, of.some_directions)},
      {"tangent_count, of regions", with({"tangent-counts", of_regions}, of.three),
       on(tangents, of.of_regions, of.three, of.some_directions)},
  };
}

class Extracted {
 public:
  explicit Extracted(std::string program) : program_(std::move(program)) {}

  const std::string& table(const std::vector<std::string>& arguments) {
    const auto known = tables_.find(arguments);
    if (known != tables_.end()) return known->second;
    std::vector<std::string> command = {program_};
    command.insert(command.end(), arguments.begin(), arguments.end());
    EndedProcess ended = run_program(command, {});
    if (ended.how != EndedProcess::How::exited || ended.code != 0)
      throw std::runtime_error(program_ + " " + arguments[0] + " failed");
    return tables_[arguments] = std::move(ended.output);
  }

 private:
  std::string program_;
  std::map<std::vector<std::string>, std::string> tables_;
};

#ifdef OPLUS_MUTANTS
/// Faults, and predicates that must show them.
const std::vector<std::pair<std::string, std::vector<std::string>>>& faults() {
  static const std::vector<std::pair<std::string, std::vector<std::string>>> all = {
      {"acute-vertex-is-reflex", {"is_reflex"}},
      {"angles-grow-clockwise",
       {"compare, of directions", "counterclockwise_between", "in_tangent_set",
        "convolution, of polygons"}},
      {"between-is-on-the-other-arc",
       {"counterclockwise_between", "in_tangent_set", "convolution, of polygons"}},
      {"containment-is-no-collision",
       {"interiors_meet, of plates with a hole and polygons", "interiors_meet, of regions"}},
      {"crossings-count-with-a-sign", {"tangent_count, of polygons", "tangent_count, of regions"}},
      {"cycle-ends-in-its-column", {"traced_origins, of polygons", "trace_cycles"}},
      {"edge-of-p-though-visited", {"trace_cycles"}},
      {"ends-are-not-on-their-segment", {"locate, in regions"}},
      {"every-state-is-a-start", {"trace_cycles"}},
      {"filtered-ties-the-other-way",
       {"compare, of filtered directions", "TracedChain::has_in_tangent_set",
        "traced_origins, of polygons"}},
      {"left-and-right-are-one-direction", {"compare, of directions", "counterclockwise_between"}},
      {"no-start-in-the-first-column", {"traced_origins, of polygons", "trace_cycles"}},
      {"parallel-edges-do-not-collide", {"interiors_meet, of regions"}},
      {"ray-counts-both-ends",
       {"winding_number, of a segment", "winding_number, of a polygon", "locate, in regions",
        "winding_number, of the convolution of regions", "tangent_count, of regions"}},
      {"rays-shift-down", {"winding_number_right_of"}},
      {"rays-start-left-of-their-edge", {"winding_number_right_of"}},
      {"reflex-turns-clockwise", {"in_tangent_set", "convolution, of polygons"}},
      {"steps-are-not-shifted",
       {"signed_crossing", "signed_crossings, of polygons", "signed_crossings, of regions"}},
      {"tangent-set-without-ties",
       {"in_tangent_set", "convolution, of polygons",
        "winding_number, of the convolution of regions"}},
      {"tie-rule-depends-on-who-asks", {"convolution, of polygons", "convolution, of regions"}},
      {"ties-go-the-other-way",
       {"compare, of directions", "counterclockwise_between", "in_tangent_set",
        "convolution, of polygons"}},
  };
  return all;
}
#endif

/// Whether the predicate is as proved; prints what differs, of a mutant the first difference.
bool agrees(const Predicate& predicate, Extracted& extracted, const std::string& mutant) {
  Comparison comparison(extracted.table(predicate.table), !mutant.empty());
  try {
    predicate.compare(comparison);
  } catch (const ContractViolation& broken) {
    comparison.broken_contract(broken.what());
  } catch (const Comparison::Seen&) {
  }
  const auto differs = comparison.difference();
  std::cout << mutant << (mutant.empty() ? "" : ", ") << predicate.name << ": "
            << comparison.entries() << " entries, " << differs.value_or("none differs") << '\n';
  return !differs;
}

int run(const std::string& program) {
  const Domains domains;
  Extracted extracted(program);
  const std::vector<Predicate> all = predicates(domains);
  bool is_right = true;
  for (const Predicate& predicate : all) is_right &= agrees(predicate, extracted, "");
#ifdef OPLUS_MUTANTS
  for (const auto& [fault, shown_by] : faults()) {
    active_mutant = fault;
    for (const std::string& name : shown_by)
      is_right &= !agrees(
          *std::find_if(all.begin(), all.end(), [&](const Predicate& p) { return p.name == name; }),
          extracted, fault);
    active_mutant.clear();
  }
#endif
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

}  // namespace oplus

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: " << argv[0] << " EXTRACTED-PROGRAM\n";
    return 2;
  }
  try {
    return oplus::run(argv[1]);
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 2;
  }
}
