// SPDX-License-Identifier: GPL-3.0-or-later
// Compares predicates with those that were proved and extracted (properties/proofs/extraction/), on
// all of small domains. With mutants compiled in, it also demands that each fault is seen.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <set>
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

constexpr int radius = 3;  // 7 x 7 points
constexpr int side = 3;    // of the grid of polygons
constexpr std::size_t most_vertices = 4;
constexpr std::size_t any_number_of_vertices = side * side;

// The same order as in properties/proofs/extraction/tables.ml.

std::vector<Point> grid(int denominator = 1) {
  std::vector<Point> all;
  for (int x = -radius; x <= radius; ++x)
    for (int y = -radius; y <= radius; ++y)
      all.push_back({Rational(x) / denominator, Rational(y) / denominator});
  return all;
}

std::vector<Vector> vectors() {
  std::vector<Vector> all = grid();
  all.erase(std::find(all.begin(), all.end(), Vector{0, 0}));
  return all;
}

std::vector<Direction> directions() {
  std::vector<Direction> all;
  for (const Vector& v : vectors())
    for (const Summand of : {Summand::P, Summand::Q}) all.push_back({v, of});
  return all;
}

char order(int compared) { return compared < 0 ? '<' : compared > 0 ? '>' : '='; }
char bit(bool value) { return value ? '1' : '0'; }
/// 0 to 9, and what follows in ASCII for more; a for -1, b for -2, and so on.
char number(int value) { return static_cast<char>(value >= 0 ? '0' + value : 'a' - 1 - value); }

std::string words(const Direction& d) {
  return to_string(d.vector) + (d.of == Summand::P ? " of P" : " of Q");
}

std::string words(const GridPolygon& polygon) {
  std::string all;
  for (const LatticePoint& p : polygon)
    all += (all.empty() ? "" : " ") + std::to_string(p.x) + " " + std::to_string(p.y);
  return all;
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

std::string shown(char c) { return c == '\n' ? "end of line" : std::string("`") + c + '`'; }

/// Reads a table along with what the C++ code says.
class Comparison {
 public:
  explicit Comparison(const std::string& proved) : proved_(proved) {}

  /// `where` says in words what is asked, if it comes to that.
  template <typename Where>
  void entry(char here, Where where) {
    const char proved = entries_ < proved_.size() ? proved_[entries_] : '?';
    ++entries_;
    if (here == proved) return;
    if (differences_++ == 0)
      first_ = where() + ": proved " + shown(proved) + ", but C++ says " + shown(here);
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
  const std::string& proved_;
  std::size_t entries_ = 0;
  std::size_t differences_ = 0;
  std::string first_;
};

template <typename Compared>
void orders(const std::vector<Compared>& all, Comparison& table) {
  const std::vector<Direction> named = directions();
  for (std::size_t a = 0; a < all.size(); ++a)
    for (std::size_t b = 0; b < all.size(); ++b)
      table.entry(order(compare(all[a], all[b])),
                  [&] { return words(named[a]) + " and " + words(named[b]); });
}

void exact_orders(Comparison& table) { orders(directions(), table); }

void filtered_orders(Comparison& table) {
  std::vector<FilteredDirection> all;
  for (const Direction& d : directions()) all.emplace_back(d);
  orders(all, table);
}

void betweens(Comparison& table) {
  const std::vector<Direction> all = directions();
  for (const Direction& d : all)
    for (const Direction& from : all)
      for (const Direction& to : all)
        table.entry(bit(counterclockwise_between(d, from, to)),
                    [&] { return words(d) + " between " + words(from) + " and " + words(to); });
}

void reflex(Comparison& table) {
  const std::vector<Vector> all = vectors();
  for (const Vector& in : all)
    for (const Vector& out : all)
      table.entry(bit(is_reflex({in, out})),
                  [&] { return to_string(in) + " to " + to_string(out); });
}

/// For `is_in(in, out)`, made by `asked_by(d)`.
template <typename IsIn>
void all_tangents(IsIn is_in, Comparison& table) {
  const std::vector<Vector> all = vectors();
  for (const Direction& d : directions())
    for (const Vector& in : all)
      for (const Vector& out : all)
        table.entry(bit(is_in(d, in, out)),
                    [&] { return words(d) + " at " + to_string(in) + " to " + to_string(out); });
}

void tangents(Comparison& table) {
  all_tangents(
      [](const Direction& d, const Vector& in, const Vector& out) {
        return in_tangent_set(d, {in, out});
      },
      table);
}

/// A chain with the corner at its vertex 1; vertex 3 is far from all others.
TracedChain chain_with_corner(const Vector& in, const Vector& out, Summand of) {
  return TracedChain({-in, {0, 0}, out, {100, 37}}, of);
}

void traced_tangents(Comparison& table) {
  const std::vector<Vector> all = vectors();
  std::map<std::pair<Vector, Vector>, std::array<TracedChain, 2>> chains;
  for (const Vector& in : all)
    for (const Vector& out : all)
      chains.insert(
          {{in, out},
           {chain_with_corner(in, out, Summand::P), chain_with_corner(in, out, Summand::Q)}});
  all_tangents(
      [&](const Direction& d, const Vector& in, const Vector& out) {
        const auto& of_both = chains.at({in, out});
        return of_both[static_cast<std::size_t>(other(d.of))].has_in_tangent_set(
            1, FilteredDirection(d));
      },
      table);
}

void crossings(Comparison& table) {
  const std::vector<Point> ends = grid();
  for (const Point& p : grid(2))
    for (const Point& source : ends)
      for (const Point& target : ends)
        table.entry(number(winding_number(p, {{source, target}})), [&] {
          return to_string(p) + " and the segment from " + to_string(source) + " to " +
                 to_string(target);
        });
}

void windings(const std::vector<GridPolygon>& polygons, Comparison& table) {
  for (const GridPolygon& polygon : polygons) {
    const std::vector<Segment> boundary = edges(region_of(polygon));
    for (const Point& p : grid(2))
      table.entry(number(winding_number(p, boundary)),
                  [&] { return to_string(p) + " and the polygon " + words(polygon); });
  }
}

void shots(const std::vector<GridPolygon>& polygons, Comparison& table) {
  const std::vector<Point> ends = grid();
  for (const GridPolygon& polygon : polygons) {
    const RayShooting rays(edges(region_of(polygon)));
    for (const Point& source : ends) {
      for (const Point& target : ends) {
        if (source == target) continue;
        table.entry(number(rays.winding_number_right_of({source, target})), [&] {
          return "right of the segment from " + to_string(source) + " to " + to_string(target) +
                 " and the polygon " + words(polygon);
        });
      }
    }
  }
}

/// What the theorems on chains ask for, and is not proved of simple polygons: they turn once, holes of
/// their shape once backwards. On valid regions it is what twice_area tells.
void turnings(const std::vector<GridPolygon>& polygons, Comparison& table) {
  for (const GridPolygon& polygon : polygons) {
    Chain chain = chains(region_of(polygon)).front();
    for (const std::string kind : {"the polygon ", "a hole, the polygon "}) {
      table.entry(number(sign(twice_area(chain))), [&] { return kind + words(polygon); });
      std::reverse(chain.begin(), chain.end());
    }
  }
}

/// A state of the fiber grid, and along whose edge it is left.
using Leaving = std::tuple<std::size_t, std::size_t, Summand>;

Leaving leaving(const Origin& origin) {
  return origin.edge_of == Summand::P
             ? Leaving{origin.edge.vertex, origin.vertex.vertex, Summand::P}
             : Leaving{origin.vertex.vertex, origin.edge.vertex, Summand::Q};
}

std::multiset<Leaving> of_the_definition(const Region& p, const Region& q) {
  std::multiset<Leaving> all;
  for (const ConvolutionSegment& s : convolution(p, q)) all.insert(leaving(s.origin));
  return all;
}

std::multiset<Leaving> traced(const Region& p, const Region& q) {
  std::multiset<Leaving> all;
  for (const TracedOrigin& s : traced_origins(p, q)) all.insert(leaving(s.origin));
  return all;
}

template <typename Convolved>
void convolutions(const std::vector<GridPolygon>& polygons, Convolved convolved,
                  Comparison& table) {
  std::vector<Region> regions;
  for (const GridPolygon& polygon : polygons) regions.push_back(region_of(polygon));
  for (std::size_t a = 0; a < polygons.size(); ++a) {
    for (std::size_t b = 0; b < polygons.size(); ++b) {
      const std::multiset<Leaving> all = convolved(regions[a], regions[b]);
      for (std::size_t i = 0; i < polygons[a].size(); ++i) {
        for (std::size_t j = 0; j < polygons[b].size(); ++j) {
          for (const Summand along : {Summand::P, Summand::Q}) {
            const std::size_t times = all.count({i, j, along});
            table.entry(times == 0   ? '0'
                        : times == 1 ? '1'
                                     : '+',
                        [&] {
                          return "P " + words(polygons[a]) + ", Q " + words(polygons[b]) +
                                 ", state (" + std::to_string(i) + ", " + std::to_string(j) +
                                 ") along " + (along == Summand::P ? "P" : "Q");
                        });
          }
        }
      }
    }
  }
}

/// Chain of P, chain of Q, along whose edge, vertex of P, vertex of Q.
using NamedByChains = std::tuple<std::size_t, std::size_t, Summand, std::size_t, std::size_t>;

NamedByChains named_by_chains(const Origin& origin) {
  const VertexIndex& of_p = origin.edge_of == Summand::P ? origin.edge : origin.vertex;
  const VertexIndex& of_q = origin.edge_of == Summand::P ? origin.vertex : origin.edge;
  return {of_p.chain, of_q.chain, origin.edge_of, of_p.vertex, of_q.vertex};
}

using NamedSegments = std::multimap<NamedByChains, Segment>;

NamedSegments segments_of_the_definition(const Region& p, const Region& q) {
  NamedSegments all;
  for (const ConvolutionSegment& s : convolution(p, q))
    all.insert({named_by_chains(s.origin), s.segment});
  return all;
}

NamedSegments traced_segments(const Region& p, const Region& q) {
  const std::vector<Chain> of_p = chains(p), of_q = chains(q);
  NamedSegments all;
  for (const TracedOrigin& s : traced_origins(p, q)) {
    const NamedByChains name = named_by_chains(s.origin);
    const auto& [a, b, along, i, j] = name;
    const Chain &chain_p = of_p[a], &chain_q = of_q[b];
    const Point from = chain_p[i] + chain_q[j];
    const Point to = along == Summand::P ? chain_p[next(i, chain_p.size())] + chain_q[j]
                                         : chain_p[i] + chain_q[next(j, chain_q.size())];
    all.insert({name, {from, to}});
  }
  return all;
}

/// The segments of each pair of regions, a line each pair, as coordinates.
template <typename Named>
void convolutions_of_regions(const std::vector<Region>& regions, Named segments_of,
                             Comparison& table) {
  const auto coordinate = [](const Rational& value) {
    return number(static_cast<int>(value.get_d()));
  };
  for (const Region& p : regions)
    for (const Region& q : regions) {
      const auto where = [&] { return "P " + words(p) + ", Q " + words(q); };
      for (const auto& [name, s] : segments_of(p, q))
        for (const Rational* value : {&s.source.x, &s.source.y, &s.target.x, &s.target.y})
          table.entry(coordinate(*value), where);
      table.entry('\n', where);
    }
}

/// The cycles of each pair as text, line by line.
void cycles(const std::vector<GridPolygon>& polygons, Comparison& table) {
  std::vector<std::array<TracedChain, 2>> traced;
  for (const GridPolygon& polygon : polygons) {
    const Chain chain = chains(region_of(polygon)).front();
    traced.push_back({TracedChain(chain, Summand::P), TracedChain(chain, Summand::Q)});
  }
  for (std::size_t a = 0; a < polygons.size(); ++a) {
    for (std::size_t b = 0; b < polygons.size(); ++b) {
      const GridCycles all = trace_cycles(traced[a][0], traced[b][1]);
      std::string text;
      for (const GridCycle& cycle : all.cycles) {
        text += std::to_string(cycle.i) + " " + std::to_string(cycle.j) + " ";
        for (const Summand along : cycle.steps) text += along == Summand::P ? 'P' : 'Q';
        text += '\n';
      }
      text += std::to_string(all.states_looked_at) + '\n';
      for (const char c : text)
        table.entry(c, [&] { return "P " + words(polygons[a]) + ", Q " + words(polygons[b]); });
    }
  }
}

/// Steps and segments between grid points, all but those of length zero.
void steps(int steps_radius, Comparison& table) {
  std::vector<Segment> all;
  std::vector<Point> points;
  for (int x = -steps_radius; x <= steps_radius; ++x)
    for (int y = -steps_radius; y <= steps_radius; ++y) points.push_back({x, y});
  for (const Point& source : points)
    for (const Point& target : points)
      if (source != target) all.push_back({source, target});
  for (const Segment& step : all)
    for (const Segment& s : all)
      table.entry(number(signed_crossing(step.source, step.target, s)), [&] {
        return "from " + to_string(step.source) + " to " + to_string(step.target) +
               " and the segment from " + to_string(s.source) + " to " + to_string(s.target);
      });
}

/// From 0 to `most`, divided.
std::vector<Point> positions(int most, int denominator = 1) {
  std::vector<Point> all;
  for (int x = 0; x <= most; ++x)
    for (int y = 0; y <= most; ++y)
      all.push_back({Rational(x) / denominator, Rational(y) / denominator});
  return all;
}

void paths(const std::vector<Region>& regions, int most, Comparison& table) {
  const std::vector<Point> points = positions(most);
  for (const Region& region : regions) {
    const std::vector<Segment> boundary = edges(region);
    for (const Point& a : points)
      for (const Point& b : points)
        for (const Point& c : points)
          table.entry(number(signed_crossings({a, b, c}, boundary)), [&] {
            return "the path " + to_string(a) + ", " + to_string(b) + ", " + to_string(c) +
                   " and the region " + words(region);
          });
  }
}

void locations(const std::vector<Region>& regions, int most, Comparison& table) {
  const std::vector<Point> points = positions(2 * most, 2);
  for (const Region& region : regions)
    for (const Point& p : points) {
      const Location where = locate(p, region);
      table.entry(where == Location::outside    ? 'o'
                  : where == Location::boundary ? 'b'
                                                : 'i',
                  [&] { return to_string(p) + " and the region " + words(region); });
    }
}

/// Whether what the theorems on regions ask for is there. The proved check asks for more: chains that touch
/// have vertices there.
void validities(const std::vector<Region>& regions, Comparison& table) {
  for (const Region& region : regions)
    table.entry(bit(!find_defect(region)), [&] { return "the region " + words(region); });
}

/// A point as arguments of the extracted program.
std::vector<std::string> halves(const std::vector<Point>& points) {
  std::vector<std::string> all;
  for (const Point& p : points) {
    all.push_back(to_string(Rational(2 * p.x)));
    all.push_back(to_string(Rational(2 * p.y)));
  }
  return all;
}

std::string words(const Region& p, const Region& q, const Point& x) {
  return "P " + words(p) + ", Q " + words(q) + ", x " + to_string(x);
}

std::vector<Region> placed(const std::vector<Region>& regions, const Point& x) {
  std::vector<Region> all;
  for (const Region& region : regions) all.push_back(translated(reflected(region), x));
  return all;
}

void collisions(const std::vector<Region>& ps, const std::vector<Region>& qs,
                const std::vector<Point>& xs, Comparison& table) {
  for (const Point& x : xs) {
    const std::vector<Region> placed_qs = placed(qs, x);
    for (const Region& p : ps)
      for (std::size_t k = 0; k < qs.size(); ++k)
        table.entry(bit(interiors_meet(p, placed_qs[k])), [&] { return words(p, qs[k], x); });
  }
}

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Of pairs by their indices.
void collisions_of_orbits(const std::vector<Region>& regions, const Pairs& pairs,
                          const std::vector<Point>& xs, Comparison& table) {
  for (const Point& x : xs) {
    const std::vector<Region> placed_regions = placed(regions, x);
    for (const auto& [a, b] : pairs)
      table.entry(bit(interiors_meet(regions[a], placed_regions[b])),
                  [&] { return words(regions[a], regions[b], x); });
  }
}

void convolution_windings(const std::vector<Region>& ps, const std::vector<Region>& qs,
                          const std::vector<Point>& xs, Comparison& table) {
  for (const Region& p : ps)
    for (const Region& q : qs) {
      const std::vector<Segment> all = segments(convolution(p, q));
      for (const Point& x : xs)
        table.entry(number(winding_number(x, all)), [&] { return words(p, q, x); });
    }
}

void tangent_counts(const std::vector<Region>& ps, const std::vector<Region>& qs,
                    const std::vector<Point>& xs, Comparison& table) {
  for (const Region& p : ps)
    for (const Region& q : qs)
      for (const Point& x : xs)
        for (const Vector& d : {Vector{1, 0}, Vector{-1, 1}, Vector{-1, -2}})
          table.entry(number(tangent_count(x, p, q, d)),
                      [&] { return words(p, q, x) + ", direction " + to_string(d); });
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

/// A predicate of ours, and which of the tables says what it should be.
struct Predicate {
  std::string name;
  std::vector<std::string> table;  ///< arguments of the extracted program
  std::function<void(Comparison&)> compare;
};

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

/// What differs, or none.
std::optional<std::string> difference(const Predicate& predicate, Extracted& extracted,
                                      std::size_t& entries) {
  Comparison comparison(extracted.table(predicate.table));
  try {
    predicate.compare(comparison);
  } catch (const ContractViolation& broken) {
    comparison.broken_contract(broken.what());
  }
  entries = comparison.entries();
  return comparison.difference();
}

/// What is asked about, and the files by which the extracted program knows it.
class Subjects {
 public:
  Subjects() {
    const std::vector<GridPolygon> all = grid_polygons(side, any_number_of_vertices);
    for (const GridPolygon& polygon : polygons) few_edges.push_back(region_of(polygon));
    for (const GridPolygon& polygon : all) all_polygons.push_back(region_of(polygon));
    pairs = pair_orbits(all);
    plates_with_a_hole = plates(few_edges);
    write("polygons", few_edges);
    write("all_polygons", all_polygons);
    write("plates", plates_with_a_hole);
    write("regions", regions);
    std::ofstream lines(file("pairs"));
    for (const auto& [a, b] : pairs) lines << a << ' ' << b << '\n';
    if (!lines.flush()) throw std::runtime_error("cannot write " + file("pairs"));
  }

  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }

  const std::vector<GridPolygon> polygons = grid_polygons(side, most_vertices);
  std::vector<Region> few_edges;  ///< the same
  std::vector<Region> all_polygons;
  Pairs pairs;  ///< of all polygons
  std::vector<Region> plates_with_a_hole;
  const std::vector<Region> regions = regions_with_holes();

 private:
  void write(const std::string& name, const std::vector<Region>& written) const {
    std::ofstream lines(file(name));
    for (const Region& region : written) lines << words(region) << '\n';
    if (!lines.flush()) throw std::runtime_error("cannot write " + file(name));
  }

  TemporaryFolder folder_{"oplus-extracted"};
};

using Arguments = std::vector<std::string>;

Arguments with(Arguments first, const std::vector<Point>& points) {
  const Arguments others = halves(points);
  first.insert(first.end(), others.begin(), others.end());
  return first;
}

/// Functions on regions, beside all else.
std::vector<Predicate> predicates_of_regions(const Subjects& of) {
  const std::vector<Point> where_polygons_meet = {{2, 2}, {2, 3}, {3, 1}};
  const std::vector<Point> some = {{2, 2}, {Rational(5, 2), Rational(3, 2)}, {3, 1}};
  const std::vector<Point> in_holes = {{3, 3}, {Rational(7, 2), 3}};
  const std::vector<Point> all = positions(8);
  const std::vector<Point> one = {{2, 2}}, two = {{2, 2}, {Rational(5, 2), Rational(3, 2)}};
  const std::string polygons = of.file("polygons"), plates = of.file("plates"),
                    regions = of.file("regions");
  return {
      {"signed_crossing", {"steps", "2"}, [](Comparison& table) { steps(2, table); }},
      {"signed_crossings, of polygons",
       {"paths", "2", polygons},
       [&](Comparison& table) { paths(of.few_edges, 2, table); }},
      {"signed_crossings, of regions",
       {"paths", "3", regions},
       [&](Comparison& table) { paths(of.regions, 3, table); }},
      {"find_defect, of polygons",
       {"validities", of.file("all_polygons")},
       [&](Comparison& table) { validities(of.all_polygons, table); }},
      {"find_defect, of plates with a hole",
       {"validities", plates},
       [&](Comparison& table) { validities(of.plates_with_a_hole, table); }},
      {"locate, in polygons",
       {"locations", "2", of.file("all_polygons")},
       [&](Comparison& table) { locations(of.all_polygons, 2, table); }},
      {"locate, in regions",
       {"locations", "4", regions},
       [&](Comparison& table) { locations(of.regions, 4, table); }},
      {"interiors_meet, of polygons", with({"collisions", polygons, polygons}, where_polygons_meet),
       [&, where_polygons_meet](Comparison& table) {
         collisions(of.few_edges, of.few_edges, where_polygons_meet, table);
       }},
      {"interiors_meet, of all pairs of polygons",
       with({"collisions-of-orbits", of.file("all_polygons"), of.file("pairs")}, two),
       [&, two](Comparison& table) {
         collisions_of_orbits(of.all_polygons, of.pairs, two, table);
       }},
      {"interiors_meet, of plates with a hole and polygons",
       with({"collisions", plates, polygons}, in_holes),
       [&, in_holes](Comparison& table) {
         collisions(of.plates_with_a_hole, of.few_edges, in_holes, table);
       }},
      {"interiors_meet, of regions", with({"collisions", regions, regions}, all),
       [&, all](Comparison& table) { collisions(of.regions, of.regions, all, table); }},
      {"convolution, of regions",
       {"convolutions-of-regions", regions},
       [&](Comparison& table) {
         convolutions_of_regions(of.regions, segments_of_the_definition, table);
       }},
      {"traced_origins, of regions",
       {"convolutions-of-regions", regions},
       [&](Comparison& table) { convolutions_of_regions(of.regions, traced_segments, table); }},
      {"winding_number, of the convolution of polygons",
       with({"convolution-windings", polygons, polygons}, two),
       [&, two](Comparison& table) {
         convolution_windings(of.few_edges, of.few_edges, two, table);
       }},
      {"winding_number, of the convolution of regions",
       with({"convolution-windings", regions, regions}, all),
       [&, all](Comparison& table) { convolution_windings(of.regions, of.regions, all, table); }},
      {"tangent_count, of polygons", with({"tangent-counts", polygons, polygons}, one),
       [&, one](Comparison& table) { tangent_counts(of.few_edges, of.few_edges, one, table); }},
      {"tangent_count, of regions", with({"tangent-counts", regions, regions}, some),
       [&, some](Comparison& table) { tangent_counts(of.regions, of.regions, some, table); }},
  };
}

std::vector<Predicate> predicates(const Subjects& of) {
  const std::string points = std::to_string(radius), file = of.file("polygons");
  const std::vector<GridPolygon>& polygons = of.polygons;
  std::vector<Predicate> all = {
      {"compare, of directions", {"orders", points}, exact_orders},
      {"compare, of filtered directions", {"orders", points}, filtered_orders},
      {"counterclockwise_between", {"betweens", points}, betweens},
      {"is_reflex", {"reflex", points}, reflex},
      {"in_tangent_set", {"tangents", points}, tangents},
      {"TracedChain::has_in_tangent_set", {"tangents", points}, traced_tangents},
      {"winding_number, of a segment", {"crossings", points}, crossings},
      {"winding_number, of a polygon",
       {"windings", points, file},
       [&](Comparison& table) { windings(polygons, table); }},
      {"winding_number_right_of",
       {"shots", points, file},
       [&](Comparison& table) { shots(polygons, table); }},
      {"twice_area, its sign",
       {"turnings", file},
       [&](Comparison& table) { turnings(polygons, table); }},
      {"convolution",
       {"convolutions", file},
       [&](Comparison& table) { convolutions(polygons, of_the_definition, table); }},
      {"traced_origins",
       {"convolutions", file},
       [&](Comparison& table) { convolutions(polygons, traced, table); }},
      {"trace_cycles", {"cycles", file}, [&](Comparison& table) { cycles(polygons, table); }},
  };
  for (Predicate& predicate : predicates_of_regions(of)) all.push_back(std::move(predicate));
  return all;
}

#ifdef OPLUS_MUTANTS
/// Faults, and predicates that must show them.
const std::vector<std::pair<std::string, std::vector<std::string>>>& faults() {
  static const std::vector<std::pair<std::string, std::vector<std::string>>> all = {
      {"acute-vertex-is-reflex", {"is_reflex"}},
      {"angles-grow-clockwise",
       {"compare, of directions", "counterclockwise_between", "in_tangent_set", "convolution"}},
      {"between-is-on-the-other-arc",
       {"counterclockwise_between", "in_tangent_set", "convolution"}},
      {"containment-is-no-collision",
       {"interiors_meet, of plates with a hole and polygons", "interiors_meet, of regions"}},
      {"crossings-count-with-a-sign", {"tangent_count, of polygons", "tangent_count, of regions"}},
      {"cycle-ends-in-its-column", {"traced_origins", "trace_cycles"}},
      {"edge-of-p-though-visited", {"trace_cycles"}},
      {"ends-are-not-on-their-segment", {"locate, in regions"}},
      {"every-state-is-a-start", {"trace_cycles"}},
      {"filtered-ties-the-other-way",
       {"compare, of filtered directions", "TracedChain::has_in_tangent_set", "traced_origins"}},
      {"left-and-right-are-one-direction", {"compare, of directions", "counterclockwise_between"}},
      {"no-start-in-the-first-column", {"traced_origins", "trace_cycles"}},
      {"parallel-edges-do-not-collide", {"interiors_meet, of regions"}},
      {"ray-counts-both-ends",
       {"winding_number, of a segment", "winding_number, of a polygon", "locate, in regions",
        "winding_number, of the convolution of regions", "tangent_count, of regions"}},
      {"rays-shift-down", {"winding_number_right_of"}},
      {"rays-start-left-of-their-edge", {"winding_number_right_of"}},
      {"reflex-turns-clockwise", {"in_tangent_set", "convolution"}},
      {"steps-are-not-shifted",
       {"signed_crossing", "signed_crossings, of polygons", "signed_crossings, of regions"}},
      {"tangent-set-without-ties",
       {"in_tangent_set", "convolution", "winding_number, of the convolution of regions"}},
      {"tie-rule-depends-on-who-asks", {"convolution", "convolution, of regions"}},
      {"ties-go-the-other-way",
       {"compare, of directions", "counterclockwise_between", "in_tangent_set", "convolution"}},
  };
  return all;
}
#endif

int run(const std::string& program) {
  const Subjects subjects;
  Extracted extracted(program);
  const std::vector<Predicate> all = predicates(subjects);
  bool agree = true;
  for (const Predicate& predicate : all) {
    std::size_t entries = 0;
    const auto differs = difference(predicate, extracted, entries);
    std::cout << predicate.name << ": " << entries << " entries, "
              << (differs ? *differs : "none differs") << '\n';
    agree = agree && !differs;
  }
#ifdef OPLUS_MUTANTS
  for (const auto& [fault, shown_by] : faults()) {
    active_mutant = fault;
    for (const std::string& name : shown_by) {
      const auto predicate =
          std::find_if(all.begin(), all.end(), [&](const Predicate& p) { return p.name == name; });
      std::size_t entries = 0;
      const auto differs = difference(*predicate, extracted, entries);
      std::cout << fault << ", " << name << ": " << (differs ? *differs : "not seen") << '\n';
      agree = agree && differs;
    }
    active_mutant.clear();
  }
#endif
  return agree ? EXIT_SUCCESS : EXIT_FAILURE;
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
