// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>

#include "checked/slide/blocking_search.hpp"
#include "checked/slide/number_types.hpp"
#include "checked/statistics.hpp"

namespace oplus::slide {

/// Which arithmetic the pairs of edges that took integers are counted for.
enum class Integers { of_64_bits, of_128_bits, of_gmp, rationals };

template <typename Numbers>
constexpr Integers integers_of() {
  if constexpr (is_small<Numbers>) return Integers::of_64_bits;
  if constexpr (is_wide<Numbers>) return Integers::of_128_bits;
  return is_rational<Numbers> ? Integers::rationals : Integers::of_gmp;
}

inline Statistics search_statistics(std::size_t segments, std::size_t bits, std::size_t free_pieces,
                                    const SearchEffort& effort, Integers integers) {
  const auto decided_in = [&](Integers these) {
    return these == integers ? effort.by_integers : std::size_t{0};
  };
  return {{"segments slid along", segments},
          {"bits of a coordinate", bits},
          {"free pieces of segments", free_pieces},
          {"segments inside a convex summand, moved", effort.covered},
          {"probes", effort.probes},
          {"pairs of boxes", effort.box_pairs},
          {"pairs of edges decided by doubles", effort.by_doubles},
          {"in integers of 64 bits", decided_in(Integers::of_64_bits)},
          {"in integers of 128 bits", decided_in(Integers::of_128_bits)},
          {"in integers of GMP", decided_in(Integers::of_gmp)},
          {"in rationals", decided_in(Integers::rationals)}};
}

}  // namespace oplus::slide
