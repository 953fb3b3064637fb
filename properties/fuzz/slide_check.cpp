// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/slide_check.hpp"

#include <array>
#include <string>

#include "checked/slide/number_types.hpp"
#include "checked/slide/slide.hpp"
#include "checked/verify/sum_by_convex_parts.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/validity.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/definitions/difference.hpp"
#include "reference/io/boundary_name.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

struct Stage {
  SlideLaws law;
  SlideNumbers numbers;
  const char* in_these;
};
constexpr std::array<Stage, 4> stages{{
    {SlideLaws::as_needed, SlideNumbers::as_needed, ""},
    {SlideLaws::at_least_128_bits, SlideNumbers::at_least_128_bits, " in 128 bits or more"},
    {SlideLaws::gmp, SlideNumbers::gmp, " in GMP"},
    {SlideLaws::rationals, SlideNumbers::rationals, " in rationals"},
}};

void require_same(const PlanarSet& sum, const PlanarSet& expected, const std::string& what) {
  if (sum == expected) return;
  const auto found = difference(sum, expected);
  throw FuzzFinding(what + (found ? found->what + ", at " + to_string(found->witness)
                                  : std::string("another order")));
}

bool is_in_right_stage(const Statistics& s, SlideNumbers numbers) {
  const std::size_t bits = s.count("bits of a coordinate");
  const bool may_be_small = numbers == SlideNumbers::as_needed && bits <= slide::SmallNumbers::bits;
  const bool may_be_wide = numbers != SlideNumbers::gmp && bits <= slide::WideNumbers::bits;
  return (s.count("in integers of 64 bits") == 0 || may_be_small) &&
         (s.count("in integers of 128 bits") == 0 || (may_be_wide && !may_be_small)) &&
         (s.count("in integers of GMP") == 0 || !may_be_wide);
}

/// A sum and the origins of its edges.
struct Expected {
  const PlanarSet& sum;
  const Origins& origins;
};

void check(const Summands& summands, Boundary boundary, const Expected& expected, SlideLaws laws) {
  const auto& [p, q] = summands;
  const std::string which = name(boundary) + " sum: ";
  Statistics first;
  for (const auto& [law, numbers, in_these] : stages) {
    if (law != SlideLaws::as_needed && law != laws && laws != SlideLaws::all) continue;
    const ComputedSum result =
        slide_sum(p, q, boundary, {.with_origins = true, .numbers = numbers});
    require_same(result.sum, expected.sum,
                 which + "slide" + in_these + ", the first, and convex parts differ: ");
    require(result.origins == expected.origins, which + "other origins" + in_these);
    const Statistics& s = result.statistics;
    require(is_in_right_stage(s, numbers), which + "decided in the wrong numbers" + in_these);
    if (numbers == SlideNumbers::as_needed) first = s;
    for (const char* same : {"segments slid along", "free pieces of segments"})
      require(s.count(same) == first.count(same), which + "other pieces" + in_these);
  }
  if (laws == SlideLaws::exchanged || laws == SlideLaws::all)
    require_same(slide_sum(q, p, boundary).sum, expected.sum,
                 which + "slide, the first, with both summands exchanged differs: ");
}

/// Of the sum that slide found, too, as both are equal by now.
void check_region(const PlanarSet& sum) {
  const Region region = region_of(sum);
  if (const auto defect = find_defect(region))
    throw FuzzFinding("no valid region: " + describe(defect->kind));
  require_same(canonical_sum(region), sum, "the first is the region of the sum: ");
}

}  // namespace

ExpectedSums expected_sums(const Summands& summands) {
  const auto& [p, q] = summands;
  ExpectedSums result;
  result.open = sum_by_convex_parts(p, q, Boundary::open);
  // The boundary of the closed sum is that of the open one without what is low-dimensional, which comes last.
  result.closed = {result.open.outer, result.open.holes, {}, {}};
  result.origins_of_open = origins(result.open, reduced_convolution(p, q));
  result.origins_of_closed = result.origins_of_open;
  result.origins_of_closed.resize(edges(result.closed).size());
  return result;
}

void check_slide(const Summands& summands, const ExpectedSums& expected, SlideLaws laws) {
  check(summands, Boundary::closed, {expected.closed, expected.origins_of_closed}, laws);
  check(summands, Boundary::open, {expected.open, expected.origins_of_open}, laws);
  check_region(expected.closed);
}

SlideLaws laws_for(std::string_view bytes) {
  unsigned mixed = 0;
  for (const char byte : bytes) mixed = 31 * mixed + static_cast<unsigned char>(byte);
  constexpr std::array others{SlideLaws::at_least_128_bits, SlideLaws::gmp, SlideLaws::rationals,
                              SlideLaws::exchanged};
  return mixed % 8 == 0 ? others.at(mixed / 8 % others.size()) : SlideLaws::as_needed;
}

void check_slide(const Summands& summands, SlideLaws laws) {
  check_slide(summands, expected_sums(summands), laws);
}

}  // namespace oplus
