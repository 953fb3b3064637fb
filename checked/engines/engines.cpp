// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/engines/engines.hpp"

#include "checked/arrangement/rca.hpp"
#include "checked/arrangement/sum_by_loops.hpp"
#include "checked/arrangement/sum_by_winding_numbers.hpp"
#include "checked/slide/slide.hpp"

namespace oplus {

const std::vector<Engine>& engines() {
  static const std::vector<Engine> table = {
      {.name = "slide",
       .what = "segments of the reduced convolution, no arrangement",
       .has_threads = true,
       .compute = slide_sum},
      {.name = "rca",
       .what = "faces of the reduced convolution's arrangement",
       .has_hole_test = true,
       .compute = rca},
      {.name = "loops",
       .what = "orientable loops of the same (Behar and Lien)",
       .has_hole_test = true,
       .compute = sum_by_loops},
      {.name = "winding",
       .what = "winding numbers on the full convolution (Wein)",
       .has_hole_test = true,
       .compute = sum_by_winding_numbers},
  };
  return table;
}

}  // namespace oplus
