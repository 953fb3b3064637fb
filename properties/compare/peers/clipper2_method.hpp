// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <clipper2/clipper.h>

#include <utility>

#include "properties/compare/peers/method_of_paths.hpp"

namespace oplus {

/// Its MinkowskiSum takes one path and sums boundaries only. So the sums with each path are united with the
/// paths, as Clipper 6 does and as is suggested in Clipper2's issue 719.
struct Clipper2 {
  using Path = Clipper2Lib::Path64;
  using Paths = Clipper2Lib::Paths64;
  static constexpr long limit = 1L << 52;  ///< it takes more, but computes points with doubles

  static Paths sum(const Path& pattern, const Paths& paths) {
    Paths swept;
    for (const Path& path : paths) {
      const Paths of_path = Clipper2Lib::MinkowskiSum(pattern, path, true);
      swept.insert(swept.end(), of_path.begin(), of_path.end());
    }
    const Clipper2Lib::Point64& first = pattern[0];
    return Clipper2Lib::Union(swept, Clipper2Lib::TranslatePaths(paths, first.x, first.y),
                              Clipper2Lib::FillRule::NonZero);
  }

  static std::pair<long, long> coordinates(const Clipper2Lib::Point64& p) { return {p.x, p.y}; }
};

using Clipper2Method = MethodOfPaths<Clipper2>;

}  // namespace oplus
