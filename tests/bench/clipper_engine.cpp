// SPDX-License-Identifier: GPL-3.0-or-later
#include <polyclipping/clipper.hpp>

#include <algorithm>

#include "tests/bench/integer_pair.hpp"

namespace oplus {

namespace {

using ClipperLib::cInt;
using ClipperLib::Path;
using ClipperLib::Paths;

/// Up to here Clipper computes with 64 bits, above with 128, which takes longer.
constexpr long most = 0x3FFFFFFF;

struct Width {
  Rational x;
  Rational y;
};

Width width(const Region& region) {
  const Chain& chain = region.components.at(0).outer;
  const auto by_x = std::minmax_element(chain.begin(), chain.end());
  const auto by_y = std::minmax_element(chain.begin(), chain.end(),
                                        [](const Point& a, const Point& b) { return a.y < b.y; });
  return {by_x.second->x - by_x.first->x, by_y.second->y - by_y.first->y};
}

struct PathPair {
  IntegerScale scale;
  Path pattern;
  Paths paths;
};

/// Clipper sums the boundaries and fills what they leave with the paths, moved to the pattern's first
/// vertex. So the sum is complete unless the paths fit into the pattern: the larger one is the paths.
struct Clipper {
  using Input = PathPair;
  using Sum = Paths;
  static constexpr Arithmetic arithmetic = Arithmetic::rounding;

  PathPair converted(const Summands& pair) const {
    if (pair.p.components.size() != 1 || pair.q.components.size() != 1)
      throw NotTaken("takes one component");
    const Width p = width(pair.p);
    const Width q = width(pair.q);
    const bool p_may_fit_into_q = p.x < q.x && p.y < q.y;
    const Region& outer = p_may_fit_into_q ? pair.q : pair.p;
    const Region& inner = p_may_fit_into_q ? pair.p : pair.q;
    if (!inner.components[0].holes.empty()) throw NotTaken("takes no holes in the smaller summand");
    const IntegerScale scale = IntegerScale::of(pair, most);
    PathPair result{scale, path_of(inner.components[0].outer, scale), {}};
    for (const Chain& chain : oplus::chains(outer)) result.paths.push_back(path_of(chain, scale));
    return result;
  }

  Paths sum(const PathPair& pair) const {
    Paths solution;
    ClipperLib::MinkowskiSum(pair.pattern, pair.paths, solution, true);
    return solution;
  }

  ReturnedChains chains(const PathPair& pair, const Paths& sum) const {
    ReturnedChains chains;
    for (const Path& path : sum) {
      chains.emplace_back();
      for (const ClipperLib::IntPoint& p : path)
        chains.back().push_back(pair.scale.point(p.X, p.Y));
    }
    return chains;
  }

 private:
  static Path path_of(const Chain& chain, const IntegerScale& scale) {
    Path path;
    for (const Point& p : chain) path.emplace_back(scale.scaled(p.x), scale.scaled(p.y));
    return path;
  }
};

}  // namespace

std::unique_ptr<PreparedPairs> prepare_clipper(const std::vector<Summands>& pairs) {
  return sums_by(Clipper{}, pairs);
}

}  // namespace oplus
