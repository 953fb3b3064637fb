// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>

#include "reference/definitions/minkowski_sum.hpp"

namespace oplus {

/// How long the stages of a run took (thesis, Section 6.2.1).
struct Stages {
  using Duration = std::chrono::duration<double>;
  Duration cycles{};       ///< finding the convolution
  Duration arrangement{};  ///< splitting its segments where they meet
  Duration hierarchy{};    ///< preparing the hole test
  Duration hole_test{};    ///< deciding which faces are in the sum
  Duration degenerate{};   ///< finding low-dimensional features
  Duration output{};       ///< stitching the canonical form
};

/// Adds the time that `work` takes; returns what it returns.
template <typename Work>
auto timed(Stages::Duration& stage, Work work) {
  struct Clock {
    Stages::Duration& total;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    ~Clock() { total += std::chrono::steady_clock::now() - start; }
  } const clock{stage};
  return work();
}

/// What a run on an arrangement did.
struct RunStatistics {
  std::size_t segments = 0;  ///< of the convolution it is the arrangement of
  std::size_t arrangement_vertices = 0;
  std::size_t arrangement_edges = 0;  ///< A_RC or A_W (thesis, Table 6.1)
  std::size_t arrangement_faces = 0;
  std::size_t hole_tests = 0;   ///< questions about faces and loops that the filters left open
  std::size_t point_tests = 0;  ///< questions about dangling edges and isolated vertices
  Stages stages;
};

struct ComputedSum {
  MinkowskiSum sum;
  Origins origins;  ///< empty unless asked for
  RunStatistics statistics;
};

/// Whether the result says where each edge came from.
enum class WithOrigins { no, yes };

}  // namespace oplus
