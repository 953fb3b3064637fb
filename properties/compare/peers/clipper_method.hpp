// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <polyclipping/clipper.hpp>

#include "properties/compare/peers/integer_scale.hpp"

namespace oplus {

/// Clipper adds the boundaries and fills their sum with the paths, moved to the pattern's first vertex. So
/// the result is complete unless the paths fit into the pattern: the larger summand is the paths.
struct ClipperMethod {
  struct Input {
    IntegerScale scale;
    ClipperLib::Path pattern;
    ClipperLib::Paths paths;
  };
  using Sum = ClipperLib::Paths;
  static constexpr bool rounds = true;

  /// Up to this value Clipper computes with 64 bits, above it with 128, which takes longer.
  static constexpr long most = 0x3FFFFFFF;

  Input converted(const Summands& pair) const {
    if (pair.p.components.size() != 1 || pair.q.components.size() != 1)
      throw Unsupported("supports one component only");
    const Vector p = extent(pair.p);
    const Vector q = extent(pair.q);
    const bool p_may_fit_into_q = p.x < q.x && p.y < q.y;
    const Region& outer = p_may_fit_into_q ? pair.q : pair.p;
    const Region& inner = p_may_fit_into_q ? pair.p : pair.q;
    if (!inner.components[0].holes.empty())
      throw Unsupported("does not support holes in the smaller summand");
    const IntegerScale scale = IntegerScale::of(pair, most);
    Input result{scale, path_of(inner.components[0].outer, scale), {}};
    for (const Chain& chain : oplus::chains(outer)) result.paths.push_back(path_of(chain, scale));
    return result;
  }

  ClipperLib::Paths sum(const Input& pair) const {
    ClipperLib::Paths solution;
    ClipperLib::MinkowskiSum(pair.pattern, pair.paths, solution, true);
    return solution;
  }

  ReturnedChains chains(const Input& pair, const ClipperLib::Paths& sum) const {
    ReturnedChains chains;
    for (const ClipperLib::Path& path : sum) {
      chains.emplace_back();
      for (const ClipperLib::IntPoint& p : path)
        chains.back().push_back(pair.scale.point(p.X, p.Y));
    }
    return chains;
  }

 private:
  static Vector extent(const Region& region) {
    const Chain& chain = region.components.at(0).outer;
    const auto [left, right] = std::ranges::minmax_element(chain, {}, &Point::x);
    const auto [low, high] = std::ranges::minmax_element(chain, {}, &Point::y);
    return {right->x - left->x, high->y - low->y};
  }

  static ClipperLib::Path path_of(const Chain& chain, const IntegerScale& scale) {
    ClipperLib::Path path;
    for (const Point& p : chain) path.emplace_back(scale.scaled(p.x), scale.scaled(p.y));
    return path;
  }
};

}  // namespace oplus
