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
#include "reference/chains/region_of.hpp"
#include "reference/definitions/contract.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/mutant.hpp"
#include "reference/definitions/tangent_set.hpp"
#include "reference/definitions/winding_number.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

constexpr int radius = 3;  // 7 x 7 points
constexpr int side = 3;    // of the grid of polygons
constexpr std::size_t most_vertices = 4;

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
/// 0 to 9; a for -1, b for -2, and so on.
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

std::vector<Predicate> predicates(const std::vector<GridPolygon>& polygons,
                                  const std::string& file) {
  const std::string points = std::to_string(radius);
  return {
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
      {"cycle-ends-in-its-column", {"traced_origins", "trace_cycles"}},
      {"edge-of-p-though-visited", {"trace_cycles"}},
      {"every-state-is-a-start", {"trace_cycles"}},
      {"filtered-ties-the-other-way",
       {"compare, of filtered directions", "TracedChain::has_in_tangent_set", "traced_origins"}},
      {"left-and-right-are-one-direction", {"compare, of directions", "counterclockwise_between"}},
      {"no-start-in-the-first-column", {"traced_origins", "trace_cycles"}},
      {"ray-counts-both-ends", {"winding_number, of a segment", "winding_number, of a polygon"}},
      {"rays-shift-down", {"winding_number_right_of"}},
      {"rays-start-left-of-their-edge", {"winding_number_right_of"}},
      {"reflex-turns-clockwise", {"in_tangent_set", "convolution"}},
      {"tangent-set-without-ties", {"in_tangent_set", "convolution"}},
      {"tie-rule-depends-on-who-asks", {"convolution"}},
      {"ties-go-the-other-way",
       {"compare, of directions", "counterclockwise_between", "in_tangent_set", "convolution"}},
  };
  return all;
}
#endif

int run(const std::string& program) {
  const std::vector<GridPolygon> polygons = grid_polygons(side, most_vertices);
  const std::string file =
      (std::filesystem::temp_directory_path() /
       ("oplus-grid-polygons-" + std::to_string(std::hash<std::string>{}(program))))
          .string();
  {
    std::ofstream lines(file);
    for (const GridPolygon& polygon : polygons) lines << words(polygon) << '\n';
    if (!lines.flush()) throw std::runtime_error("cannot write " + file);
  }
  Extracted extracted(program);
  const std::vector<Predicate> all = predicates(polygons, file);
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
  std::filesystem::remove(file);
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
