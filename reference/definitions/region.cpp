// SPDX-License-Identifier: MIT
#include "reference/definitions/region.hpp"

#include <algorithm>
#include <utility>

#include "reference/definitions/common_denominator.hpp"
#include "reference/definitions/pairwise_sum.hpp"
#include "reference/definitions/unbounded.hpp"
#include "reference/definitions/winding_number.hpp"

namespace oplus {

namespace {

void add_edges(const Chain& chain, std::vector<Segment>& edges) {
  for (std::size_t i = 0; i < chain.size(); ++i)
    edges.push_back({chain[i], chain[next(i, chain.size())]});
}

}  // namespace

std::vector<Chain> chains(const Region& region) {
  std::vector<Chain> result;
  for (const Component& component : region.components) {
    result.push_back(component.outer);
    result.insert(result.end(), component.holes.begin(), component.holes.end());
  }
  return result;
}

std::vector<Segment> edges(const Chain& chain) {
  std::vector<Segment> result;
  result.reserve(chain.size());
  add_edges(chain, result);
  return result;
}

std::vector<Segment> edges(const Region& region) {
  std::vector<Segment> result;
  result.reserve(vertex_count(region));
  for (const Component& component : region.components) {
    add_edges(component.outer, result);
    for (const Chain& hole : component.holes) add_edges(hole, result);
  }
  return result;
}

std::size_t vertex_count(const Region& region) {
  std::size_t count = 0;
  for (const Component& component : region.components) {
    count += component.outer.size();
    for (const Chain& hole : component.holes) count += hole.size();
  }
  return count;
}

Rational twice_area(const Chain& chain) {
  // Some edges at a time in integers: a sum of fractions would be reduced to lowest terms at each step, and a
  // denominator that all edges have in common may be as long as the chain.
  constexpr std::size_t edges_at_a_time = 32;
  PairwiseSum twice;
  for (std::size_t begin = 0; begin < chain.size(); begin += edges_at_a_time) {
    const std::size_t edges = std::min(edges_at_a_time, chain.size() - begin);
    const auto vertex = [&](std::size_t i) -> const Point& {
      return chain[(begin + i) % chain.size()];
    };
    mpz_class common = 1;
    for (std::size_t i = 0; i <= edges; ++i) add_denominators(common, vertex(i));
    const auto multiple = [&](const Rational& c) {
      return mpz_class(common / c.get_den() * c.get_num());
    };
    mpz_class sum, x = multiple(vertex(0).x), y = multiple(vertex(0).y);
    for (std::size_t i = 1; i <= edges; ++i) {
      mpz_class next_x = multiple(vertex(i).x), next_y = multiple(vertex(i).y);
      sum += x * next_y - y * next_x;
      x.swap(next_x);
      y.swap(next_y);
    }
    Rational part(sum, common * common);
    part.canonicalize();
    twice.add(std::move(part));
  }
  return twice.total();
}

bool is_convex(const Chain& chain) {
  for (std::size_t i = 0; i < chain.size(); ++i)
    if (orientation(chain[previous(i, chain.size())], chain[i], chain[next(i, chain.size())]) < 0)
      return false;
  return true;
}

Rational area(const Region& region) {
  PairwiseSum twice;
  for (const Component& component : region.components) {
    twice.add(twice_area(component.outer));
    for (const Chain& hole : component.holes) twice.add(twice_area(hole));
  }
  return twice.total() / 2;
}

bool has_hole(const Region& region) {
  return std::any_of(region.components.begin(), region.components.end(),
                     [](const Component& c) { return !c.holes.empty(); });
}

Chain translated(Chain chain, const Vector& by) {
  for (Point& p : chain) p = p + by;
  return chain;
}

Region translated(Region region, const Vector& by) {
  return mapped(std::move(region), [&](const Point& p) { return p + by; });
}

Region reflected(Region region) {
  return mapped(std::move(region), [](const Point& p) { return -p; });
}

Chain turned(Chain chain) {
  if (!chain.empty()) std::reverse(chain.begin() + 1, chain.end());
  return chain;
}

Region together(Region a, const Region& b) {
  a.components.insert(a.components.end(), b.components.begin(), b.components.end());
  return a;
}

Region polygon(Chain outer) { return {{{std::move(outer), {}}}}; }

Location locate(const Point& p, const Region& region) {
  const std::vector<Segment> boundary = edges(region);
  if (lies_on_one(p, boundary)) return Location::boundary;
  // A missing outer chain winds around every point.
  return winding_number(p, boundary) + (is_unbounded(region) ? 1 : 0) > 0 ? Location::inside
                                                                          : Location::outside;
}

}  // namespace oplus
