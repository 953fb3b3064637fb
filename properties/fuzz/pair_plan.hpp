// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/definitions/rational.hpp"
#include "reference/families/family.hpp"

namespace oplus {

/// A pair of regions as the fuzzer changes it: chains on a small grid, and how to make large numbers and
/// fractions of them. Any bytes are a plan; its valid part becomes the pair (realized_pair.hpp).

/// A vertex, and by how little it is off the grid: a jitter is -8 to 7 whatever the magnitude.
struct PlannedVertex {
  std::int8_t x = 0;
  std::int8_t y = 0;
  std::int8_t jitter_x = 0;
  std::int8_t jitter_y = 0;

  friend auto operator<=>(const PlannedVertex&, const PlannedVertex&) = default;
};

struct PlannedChain {
  bool is_hole = false;
  std::vector<PlannedVertex> vertices;

  friend bool operator==(const PlannedChain&, const PlannedChain&) = default;
};

/// A hole belongs to the last component before it that can have it.
struct PlannedSummand {
  std::vector<PlannedChain> chains;
  std::uint8_t denominator = 0;  ///< its place in `denominators`
  std::uint8_t offset = 0;       ///< its place in `offsets`

  friend bool operator==(const PlannedSummand&, const PlannedSummand&) = default;
};

struct PairPlan {
  /// The bits of the largest coordinate, its place in `magnitudes`.
  std::uint8_t magnitude = 0;
  bool is_sheared = false;
  PlannedSummand p;
  PlannedSummand q;

  friend bool operator==(const PairPlan&, const PairPlan&) = default;
};

/// Around the limits of slide's stages of numbers, 29 and 124 bits; 0: the grid as it is.
inline constexpr std::array<unsigned, 20> magnitudes{0,  8,  28, 29, 30,  31,  32,  53,  61,  62,
                                                     63, 64, 65, 92, 123, 124, 125, 126, 128, 256};

/// Coordinates are divided by a denominator, then an offset is added.
const std::vector<Rational>& denominators();
const std::vector<Rational>& offsets();

inline constexpr std::size_t most_chains = 7;
inline constexpr std::size_t most_vertices = 16;         ///< of a chain
inline constexpr std::size_t most_vertices_in_all = 40;  ///< of a summand

/// Any bytes are a plan; what exceeds the limits, or is missing, is left out.
PairPlan decoded(std::string_view bytes);

/// decoded(encoded(plan)) == plan, if the plan keeps within the limits.
std::string encoded(const PairPlan& plan);

/// The plan of a pair with integer coordinates of 8 bits with sign, within the limits, neither empty.
/// Requires: both are valid.
std::optional<PairPlan> plan_of(const Summands& summands);

}  // namespace oplus
