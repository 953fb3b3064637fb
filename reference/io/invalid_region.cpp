// SPDX-License-Identifier: MIT
#include "reference/io/invalid_region.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reference/io/writing.hpp"

namespace oplus {

namespace {

/// The number of a vertex in the input.
std::size_t number_of(const PlacedChain& chain, std::size_t vertex) {
  if (!chain.numbers.empty()) return chain.numbers[vertex];
  return 1 + (chain.is_turned && vertex != 0 ? chain.vertices.size() - vertex : vertex);
}

/// The vertex that an edge leaves in the input.
std::size_t source_of(const PlacedChain& chain, std::size_t edge) {
  return chain.is_turned ? next(edge, chain.vertices.size()) : edge;
}

/// "(1, 0)", or "about (1.25e+400, 0)" if that would be long.
std::string in_short(const Point& p) {
  constexpr std::size_t longest = 100;
  std::string exact = to_string(p);
  if (exact.size() <= longest) return exact;
  const mpf_class x(p.x), y(p.y);
  std::array<char, 2 * longest> rounded;
  gmp_snprintf(rounded.data(), rounded.size(), "about (%.9Fg, %.9Fg)", x.get_mpf_t(),
               y.get_mpf_t());
  return rounded.data();
}

/// "edge 2 from (1, 0) to (1, 1)", numbered and directed as in the input.
std::string edge_name(const PlacedChain& chain, std::size_t edge) {
  const std::size_t from = source_of(chain, edge);
  const std::size_t to = chain.is_turned ? edge : next(edge, chain.vertices.size());
  return "edge " + std::to_string(number_of(chain, from)) + " from " +
         in_short(chain.vertices[from]) + " to " + in_short(chain.vertices[to]);
}

/// The edge of a chain on which the point lies: the one a defect names, else any.
std::optional<std::size_t> edge_at(const PlacedChain& chain, std::size_t named, const Point& p) {
  const std::vector<Segment> all = edges(chain.vertices);
  if (lies_on(p, all[named])) return named;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Segment& e) { return lies_on(p, e); });
  if (found == all.end()) return std::nullopt;
  return static_cast<std::size_t>(found - all.begin());
}

class DefectMessage {
 public:
  DefectMessage(const InputText& input, const PlacedGeometry& geometry, const Defect& defect)
      : input_(input),
        defect_(defect),
        first_(geometry.chains[defect.first.chain]),
        second_(geometry.chains[defect.second.chain]) {}

  [[noreturn]] void refuse() const {
    const std::string first = describe(first_.name);
    const std::string second = describe(second_.name);
    switch (defect_.kind) {
      case DefectKind::too_few_vertices:
        refuse_too_few_vertices(input_, first_.start, first_.name, first_.vertices.size());
      case DefectKind::zero_length_edge:
        refuse_vertices(first + " has an edge of zero length: " + two_vertices(),
                        "consecutive vertices to differ");
      case DefectKind::repeated_vertex:
        refuse_vertices("a vertex of " + first + " is repeated: " + two_vertices(),
                        "each vertex of a chain once");
      case DefectKind::self_crossing:
        refuse_edges("two edges of " + first + " cross", "a simple chain");
      case DefectKind::self_overlap:
        refuse_edges("two edges of " + first + " overlap", "a simple chain");
      case DefectKind::self_touching:
        refuse_edges(first + " touches itself", "a simple chain");
      case DefectKind::chains_cross:
        refuse_edges(first + " and " + second + " cross", "chains that at most touch");
      case DefectKind::chains_overlap:
        refuse_edges(first + " and " + second + " overlap", "chains that at most touch in points");
      case DefectKind::hole_outside:
        refuse_vertices(first + at() + " is not inside " + second,
                        "each hole inside its outer chain");
      case DefectKind::holes_nested:
        refuse_vertices(first + at() + " is inside " + second, "holes beside each other");
      case DefectKind::components_overlap:
        refuse_vertices(first + at() + " is inside " + second + " and in none of its holes",
                        "components that at most touch");
    }
    refuse_vertices(describe(defect_.kind), "a valid region");
  }

 private:
  std::string at() const { return " at " + in_short(defect_.where); }

  [[noreturn]] void refuse_vertices(const std::string& wrong, const std::string& expected) const {
    refuse_at(std::max(first_.places[defect_.first.vertex], second_.places[defect_.second.vertex]),
              wrong, expected);
  }

  [[noreturn]] void refuse_at(const Position& at, const std::string& wrong,
                              const std::string& expected) const {
    if (first_.name.component != second_.name.component)
      throw OverlappingComponents({input_.name, at.line, at.column}, wrong, expected);
    input_.refuse(at, wrong, expected);
  }

  /// "vertices 1 and 3 are both (2, 3)"
  std::string two_vertices() const {
    const auto [low, high] = std::minmax(
        {number_of(first_, defect_.first.vertex), number_of(second_, defect_.second.vertex)});
    return "vertices " + std::to_string(low) + " and " + std::to_string(high) + " are both " +
           in_short(defect_.where);
  }

  [[noreturn]] void refuse_edges(const std::string& wrong, const std::string& expected) const {
    const auto named = [](const PlacedChain& chain, std::size_t edge) {
      return std::pair(chain.places[source_of(chain, edge)], edge_name(chain, edge));
    };
    const auto a = edge_at(first_, defect_.first.vertex, defect_.where);
    const auto b = edge_at(second_, defect_.second.vertex, defect_.where);
    if (!a || !b) refuse_vertices(wrong, expected);
    const auto [earlier, later] = std::minmax({named(first_, *a), named(second_, *b)});
    refuse_at(later.first, wrong + at() + ": " + earlier.second + " and " + later.second, expected);
  }

  const InputText& input_;
  const Defect& defect_;
  const PlacedChain& first_;
  const PlacedChain& second_;
};

}  // namespace

void refuse_defect(const InputText& input, const PlacedGeometry& geometry, const Defect& defect) {
  DefectMessage(input, geometry, defect).refuse();
}

}  // namespace oplus
