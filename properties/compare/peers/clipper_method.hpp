// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <polyclipping/clipper.hpp>
#include <utility>

#include "properties/compare/peers/method_of_paths.hpp"

namespace oplus {

struct Clipper6 {
  using Path = ClipperLib::Path;
  using Paths = ClipperLib::Paths;
  static constexpr long limit = ClipperLib::hiRange;

  static Paths sum(const Path& pattern, const Paths& paths) {
    Paths solution;
    ClipperLib::MinkowskiSum(pattern, paths, solution, true);
    return solution;
  }

  static std::pair<long, long> coordinates(const ClipperLib::IntPoint& p) { return {p.X, p.Y}; }
};

using ClipperMethod = MethodOfPaths<Clipper6>;

}  // namespace oplus
