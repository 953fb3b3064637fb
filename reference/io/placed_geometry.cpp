// SPDX-License-Identifier: MIT
#include "reference/io/placed_geometry.hpp"

#include "reference/io/counted.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

std::string describe(const ChainName& name) {
  const std::string chain = name.hole == 0 ? "outer chain" : "hole " + std::to_string(name.hole);
  return chain + " of component " + std::to_string(name.component);
}

std::string coordinate_name(char axis, std::size_t vertex, const std::string& chain) {
  return std::string(1, axis) + " of vertex " + std::to_string(vertex) + " of " + chain;
}

std::string vertices(std::size_t count) { return counted(count, "vertex", "vertices"); }

void remove_closing_vertex(PlacedChain& ring) {
  if (ring.vertices.size() < 2) return;
  ring.is_open = ring.vertices.front() != ring.vertices.back();
  if (ring.is_open) return;
  ring.vertices.pop_back();
  ring.places.pop_back();
}

void require_closed_rings(const InputText& input, const PlacedGeometry& geometry) {
  for (const PlacedChain& ring : geometry.chains)
    if (ring.is_open)
      input.refuse(ring.places.back(),
                   describe(ring.name) + " is not closed: it starts at " +
                       to_string(ring.vertices.front()) + " and ends at " +
                       to_string(ring.vertices.back()),
                   "the first vertex again at its end");
}

void refuse_dimension(const InputText& input, const Position& at, const std::string& vertex,
                      std::size_t dimension, std::size_t of_others) {
  input.refuse(at, vertex + " has " + counted(dimension, "coordinate", "coordinates"),
               std::to_string(of_others) + ", as the geometry has");
}

void refuse_too_few_vertices(const InputText& input, const Position& at, const ChainName& name,
                             std::size_t count) {
  input.refuse(at, describe(name) + " has " + vertices(count), "at least 3");
}

}  // namespace oplus
