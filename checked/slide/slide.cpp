// SPDX-License-Identifier: MIT
#include "checked/slide/slide.hpp"

#include <algorithm>

#include "checked/slide/kept_summands.hpp"
#include "checked/slide/number_types.hpp"
#include "checked/slide/scaling.hpp"
#include "checked/slide/search_statistics.hpp"
#include "checked/slide/sum_in.hpp"

namespace oplus {

using namespace slide;

namespace {

#ifdef OPLUS_FEW_NUMBERS  // of WebAssembly, which is to be small: any numbers do for all that are not small
constexpr bool has_all_numbers = false;
#else
constexpr bool has_all_numbers = true;
#endif

// What is asked about summands, which are regions, or prepared ones that know it.
using slide::bits_of_integers, slide::extent_of;
const Region& region_of(const Region& p) { return p; }
const Region& region_of(const PreparedSummand& p) { return p.region(); }
std::size_t bits_of_integers(const PreparedSummand& p) { return p.bits_of_integers(); }
const Extent& extent_of(const PreparedSummand& p) { return p.kept().extent(p.region()); }

/// Calls compute.operator()<Numbers>(scaling) with numbers in which both can be computed.
template <typename OneSummand, typename Compute>
auto in_numbers_for(const OneSummand& p, const OneSummand& q, SlideNumbers numbers,
                    const Compute& compute) {
  const bool as_needed = numbers == SlideNumbers::as_needed;
  if (as_needed) {
    const std::size_t of_p = bits_of_integers(p), of_q = bits_of_integers(q);
    if (of_p > 0 && of_q > 0 && std::max(of_p, of_q) <= SmallNumbers::bits)
      return compute.template operator()<SmallNumbers>(scaling_of_integers(std::max(of_p, of_q)));
  }
  const Extent &of_p = extent_of(p), &of_q = extent_of(q);
  if constexpr (has_all_numbers)
    if (numbers == SlideNumbers::rationals || (as_needed && has_unlike_denominators(of_p, of_q)))
      return compute.template operator()<RationalNumbers>(
          scaling_of_rationals(region_of(p), region_of(q)));
  const auto any = [](const auto& summand) {
    return extent_of(region_of(summand), Denominators::any);
  };
  const Scaling scaling =
      of_p.is_unlike || of_q.is_unlike ? scaling_of(any(p), any(q)) : scaling_of(of_p, of_q);
  if (as_needed && scaling.bits <= SmallNumbers::bits)
    return compute.template operator()<SmallNumbers>(scaling);
  if constexpr (has_all_numbers)
    if (numbers != SlideNumbers::gmp && scaling.bits <= WideNumbers::bits)
      return compute.template operator()<WideNumbers>(scaling);
  return compute.template operator()<AnyNumbers>(scaling);
}

template <typename OneSummand>
ComputedSum sum_of(const OneSummand& p, const OneSummand& q, Boundary boundary,
                   const EngineOptions& options) {
  if (region_of(p).components.empty() || region_of(q).components.empty())
    return {{}, {}, search_statistics(0, 0, 0, {}, Integers::of_64_bits)};
  return in_numbers_for(p, q, options.numbers, [&]<typename Numbers>(const Scaling& scaling) {
    return sum_in<Numbers>(p, q, scaling, boundary, options);
  });
}

}  // namespace

ComputedSum slide_sum(const Region& p, const Region& q, Boundary boundary,
                      const EngineOptions& options) {
  return sum_of(p, q, boundary, options);
}

ComputedSum sum_of_prepared(const PreparedSummand& p, const PreparedSummand& q, Boundary boundary,
                            const EngineOptions& options) {
  return sum_of(p, q, boundary, options);
}

std::vector<Segment> nearest_boundary(const Region& p, const Region& q) {
  return in_numbers_for(
      p, q, SlideNumbers::as_needed,
      [&]<typename Numbers>(const Scaling& scaling) { return nearest_in<Numbers>(p, q, scaling); });
}

}  // namespace oplus
