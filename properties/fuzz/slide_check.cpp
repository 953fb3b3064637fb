// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/slide_check.hpp"

#include <array>
#include <string>
#include <utility>

#include "checked/arrangement/sum_by_winding_numbers.hpp"
#include "checked/slide/slide.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/validity.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/io/boundary_name.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

constexpr std::array<std::pair<SlideNumbers, const char*>, 4> stages{{
    {SlideNumbers::as_needed, ""},
    {SlideNumbers::at_least_256_bits, " in 256 bits or more"},
    {SlideNumbers::gmp, " in GMP"},
    {SlideNumbers::rationals, " in rationals"},
}};

void require_same(const MinkowskiSum& sum, const MinkowskiSum& expected, const std::string& what) {
  if (sum == expected) return;
  const auto found = difference(sum, expected);
  throw FuzzFinding(what + (found ? found->what + ", at " + to_string(found->witness)
                                  : std::string("another order")));
}

bool is_in_right_stage(const Statistics& s, SlideNumbers numbers) {
  const std::size_t bits = s.count("bits of a coordinate");
  const bool may_be_small = numbers == SlideNumbers::as_needed && bits <= 29;
  const bool may_be_wide = numbers != SlideNumbers::gmp && bits <= 124;
  return (s.count("in integers of 64 bits") == 0 || may_be_small) &&
         (s.count("in integers of 256 bits") == 0 || (may_be_wide && !may_be_small)) &&
         (s.count("in integers of GMP") == 0 || !may_be_wide);
}

void check(const Summands& summands, Boundary boundary) {
  const auto& [p, q] = summands;
  const std::string which = name(boundary) + " sum: ";
  const ComputedSum expected = sum_by_winding_numbers(p, q, boundary, {.with_origins = true});
  Statistics first;
  for (const auto& [numbers, in_these] : stages) {
    const ComputedSum result =
        slide_sum(p, q, boundary, {.with_origins = true, .numbers = numbers});
    require_same(result.sum, expected.sum,
                 which + "slide" + in_these + ", the first, and winding numbers differ: ");
    require(result.origins == expected.origins, which + "other origins" + in_these);
    const Statistics& s = result.statistics;
    require(is_in_right_stage(s, numbers), which + "decided in the wrong numbers" + in_these);
    if (numbers == SlideNumbers::as_needed) first = s;
    for (const char* same : {"segments slid along", "free pieces of segments"})
      require(s.count(same) == first.count(same), which + "other pieces" + in_these);
  }
  require_same(slide_sum(q, p, boundary).sum, expected.sum,
               which + "slide, the first, with both summands exchanged differs: ");
  const Region region = region_of(expected.sum);
  if (const auto defect = find_defect(region))
    throw FuzzFinding(which + "no valid region: " + describe(defect->kind));
  MinkowskiSum regularized = expected.sum;
  regularized.dangling_edges.clear();
  regularized.isolated_vertices.clear();
  require_same(canonical_sum(region), regularized, which + "the first is the region of the sum: ");
}

}  // namespace

void check_slide(const Summands& summands) {
  check(summands, Boundary::closed);
  check(summands, Boundary::open);
}

}  // namespace oplus
