// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "properties/compare/peers/integer_scale.hpp"

namespace oplus {

/// What Clipper 6 and Clipper2 share. They add the boundaries and fill their sum with the paths, moved to the
/// pattern's first vertex. So the result is complete unless the paths fit into the pattern: the larger
/// summand is the paths. `Library` has Path, Paths, limit, sum() and coordinates().
template <typename Library>
struct MethodOfPaths {
  using Path = typename Library::Path;
  using Paths = typename Library::Paths;
  struct Part {
    Paths paths;
    Vector extent;
  };
  struct Input {
    Path pattern;
    Paths paths;
    IntegerScale scale = {1};
  };
  using Sum = Paths;
  static constexpr bool rounds = true;

  /// Up to this value Clipper 6 computes with 64 bits, above it with 128, which takes longer.
  static constexpr long most = 0x3FFFFFFF;

  static IntegerScale scale_of(const std::vector<Region>& regions) {
    return IntegerScale::of(regions, most, Library::limit);
  }

  Part part(const Region& region, const IntegerScale& scale) const {
    if (region.components.size() != 1) throw Unsupported("supports one component only");
    Part result{{}, extent(region.components[0].outer)};
    for (const Chain& chain : oplus::chains(region)) {
      Path& path = result.paths.emplace_back();
      for (const Point& p : chain) path.emplace_back(scale.scaled(p.x), scale.scaled(p.y));
    }
    return result;
  }

  Input paired(const Part& p, const Part& q) const {
    const bool p_may_fit_into_q = p.extent.x < q.extent.x && p.extent.y < q.extent.y;
    const Part& outer = p_may_fit_into_q ? q : p;
    const Part& inner = p_may_fit_into_q ? p : q;
    if (inner.paths.size() > 1) throw Unsupported("does not support holes in the smaller summand");
    return {inner.paths[0], outer.paths};
  }

  Input converted(const Summands& pair) const {
    const IntegerScale scale = scale_of({pair.p, pair.q});
    Input result = paired(part(pair.p, scale), part(pair.q, scale));
    result.scale = scale;
    return result;
  }

  Sum sum(const Input& pair) const { return Library::sum(pair.pattern, pair.paths); }

  ReturnedChains chains(const Input& pair, const Sum& sum) const {
    ReturnedChains chains;
    for (const Path& path : sum) {
      Chain& chain = chains.emplace_back();
      for (const auto& vertex : path) {
        const auto [x, y] = Library::coordinates(vertex);
        chain.push_back(pair.scale.point(x, y));
      }
    }
    return chains;
  }

 private:
  static Vector extent(const Chain& chain) {
    const auto [left, right] = std::ranges::minmax_element(chain, {}, &Point::x);
    const auto [low, high] = std::ranges::minmax_element(chain, {}, &Point::y);
    return {right->x - left->x, high->y - low->y};
  }
};

}  // namespace oplus
