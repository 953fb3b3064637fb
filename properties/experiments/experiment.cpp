// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/experiments/experiment.hpp"

namespace oplus {

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all = {
      {"table-6.1", "Wein's pairs, as far as they are at hand (Table 6.1)", run_table_6_1},
      {"convex-star", "Convex P grows, Q a star of 100 vertices (Figures 6.9 and 6.20a)",
       run_convex_star},
      {"star-star", "Star-shaped P grows, Q a star of 100 vertices (Figure 6.10)", run_star_star},
      {"simple-simple",
       "Simple P grows, Q is simple with 100 vertices (Figures 6.11 to 6.13 and 6.20b)",
       run_simple_simple},
      {"fork-l", "A fork grows, Q is an L (Figures 6.14 to 6.16)", run_fork_l},
      {"hole-tests", "The four hole tests on what rca asks (Section 5.3)", run_hole_tests},
      {"cycles", "Tracing cycles beside every edge against every vertex (Theorem 4.1.10)",
       run_cycles},
  };
  return all;
}

}  // namespace oplus
