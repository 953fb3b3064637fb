// SPDX-License-Identifier: MIT
// Sets of arrays, and arrays of sets.
#include <vector>

#include "checked/bindings/c/set.hpp"

namespace {

using namespace oplus;

/// A set of chains, put together one by one.
struct Gathered {
  Region region = {};
  std::vector<std::vector<Coordinates>> lines = {};
  std::vector<Coordinates> points = {};

  void add(int kind, const std::vector<Coordinates>& vertices) {
    Chain chain;
    for (const Coordinates& vertex : vertices) chain.push_back(vertex.point());
    switch (c::one_of(kind, OPLUS_POINT, "kinds")) {
      case OPLUS_OUTER:
        return region.components.push_back({std::move(chain), {}});
      case OPLUS_HOLE:
        if (region.components.empty())
          c::refuse("kinds", "a hole is first", "an outer chain before it");
        return region.components.back().holes.push_back(std::move(chain));
      case OPLUS_LINE:
        return lines.push_back(vertices);
      default:
        if (vertices.size() != 1)
          c::refuse("lengths", "a point has " + std::to_string(vertices.size()) + " vertices", "1");
        points.push_back(vertices.front());
    }
  }
};

template <typename Coordinate>
oplus_code from_arrays(const Coordinate* xy, const size_t* lengths, const int* kinds, size_t chains,
                       oplus_set** set) {
  return c::put(set, [&] {
    Gathered gathered;
    for (size_t i = 0; i < chains; ++i) {
      std::vector<Coordinates> vertices;
      for (size_t left = (&c::given(lengths, "lengths"))[i]; left > 0; --left, xy += 2)
        vertices.emplace_back(c::given(xy, "xy"), xy[1]);
      gathered.add(kinds != nullptr ? kinds[i] : i == 0 ? OPLUS_OUTER : OPLUS_HOLE, vertices);
    }
    return ValidSet(ValidRegion(std::move(gathered.region)), gathered.lines, gathered.points);
  });
}

/// Calls with the kind and the vertices of each chain.
template <typename Visit>
void for_each_chain(const oplus_set* handle, const Visit& visit) {
  const ValidSet& set = c::set(handle, "set");
  for (const auto& [outer, holes] : set.components()) {
    visit(OPLUS_OUTER, outer);
    for (const Chain& hole : holes) visit(OPLUS_HOLE, hole);
  }
  for (const auto& [source, target] : set.dangling_edges())
    visit(OPLUS_LINE, Chain{source, target});
  for (const Point& point : set.isolated_vertices()) visit(OPLUS_POINT, Chain{point});
}

}  // namespace

oplus_code oplus_from_doubles(const double* xy, const size_t* lengths, const int* kinds,
                              size_t chains, oplus_set** set) {
  return from_arrays(xy, lengths, kinds, chains, set);
}

oplus_code oplus_from_integers(const int64_t* xy, const size_t* lengths, const int* kinds,
                               size_t chains, oplus_set** set) {
  return from_arrays(xy, lengths, kinds, chains, set);
}

oplus_code oplus_sizes(const oplus_set* set, size_t* chains, size_t* vertices) {
  return c::code_of([&] {
    size_t all = 0, of_all = 0;
    for_each_chain(set, [&](int /*kind*/, const Chain& chain) {
      ++all;
      of_all += chain.size();
    });
    c::given(vertices, "vertices");
    c::given(chains, "chains") = all;
    *vertices = of_all;
  });
}

oplus_code oplus_to_doubles(const oplus_set* set, int* kinds, size_t* lengths, double* xy) {
  return c::code_of([&] {
    for_each_chain(set, [&](int kind, const Chain& chain) {
      if (kinds != nullptr) *kinds++ = kind;
      if (lengths != nullptr) *lengths++ = chain.size();
      if (xy != nullptr)
        for (const Point& vertex : chain)
          for (const double coordinate : to_double(vertex)) *xy++ = coordinate;
    });
  });
}

oplus_code oplus_fractions(const oplus_set* set, char** text) {
  return c::put(text, [&] {
    std::string all;
    for_each_chain(set, [&](int /*kind*/, const Chain& chain) {
      for (const Point& vertex : chain) c::append(all, vertex);
    });
    return all;
  });
}
