// SPDX-License-Identifier: MIT
#include "checked/slide/slide.hpp"

#include <algorithm>

#include "checked/slide/number_types.hpp"
#include "checked/slide/scaling.hpp"
#include "checked/slide/search_statistics.hpp"
#include "checked/slide/sum_in.hpp"

namespace oplus {

using namespace slide;

namespace {

bool are_small(std::size_t bits_p, std::size_t bits_q, const EngineOptions& options) {
  return options.numbers == SlideNumbers::as_needed && bits_p > 0 && bits_q > 0 &&
         std::max(bits_p, bits_q) <= SmallNumbers::bits;
}

/// Integers that are asked for are taken, however long.
Denominators denominators_for(const EngineOptions& options) {
  return options.numbers == SlideNumbers::as_needed ? Denominators::alike : Denominators::any;
}

/// Calls compute.operator()<Numbers>(scaling) with numbers in which both can be computed.
template <typename Compute>
auto in_numbers_for(const Region& p, const Region& q, const Extent& of_p, const Extent& of_q,
                    SlideNumbers numbers, const Compute& compute) {
  if (numbers == SlideNumbers::rationals ||
      (numbers == SlideNumbers::as_needed && has_unlike_denominators(of_p, of_q)))
    return compute.template operator()<RationalNumbers>(scaling_of_rationals(p, q));
  const Scaling scaling = scaling_of(of_p, of_q);
  if (numbers == SlideNumbers::as_needed && scaling.bits <= SmallNumbers::bits)
    return compute.template operator()<SmallNumbers>(scaling);
  if (numbers != SlideNumbers::gmp && scaling.bits <= WideNumbers::bits)
    return compute.template operator()<WideNumbers>(scaling);
  return compute.template operator()<AnyNumbers>(scaling);
}

/// Summands are regions, or prepared ones.
template <typename OneSummand>
ComputedSum sum_of(const OneSummand& p, const OneSummand& q, const Region& region_p,
                   const Region& region_q, const Extent& extent_p, const Extent& extent_q,
                   Boundary boundary, const EngineOptions& options) {
  return in_numbers_for(region_p, region_q, extent_p, extent_q, options.numbers,
                        [&]<typename Numbers>(const Scaling& scaling) {
                          return sum_in<Numbers>(p, q, scaling, boundary, options);
                        });
}

ComputedSum sum_with_nothing() {
  return {{}, {}, search_statistics(0, 0, 0, {}, Integers::of_64_bits)};
}

}  // namespace

ComputedSum slide_sum(const Region& p, const Region& q, Boundary boundary,
                      const EngineOptions& options) {
  if (p.components.empty() || q.components.empty()) return sum_with_nothing();
  const std::size_t bits_p = bits_of_integers(p), bits_q = bits_of_integers(q);
  if (are_small(bits_p, bits_q, options))
    return sum_in<SmallNumbers>(p, q, scaling_of_integers(std::max(bits_p, bits_q)), boundary,
                                options);
  const Denominators denominators = denominators_for(options);
  return sum_of(p, q, p, q, extent_of(p, denominators), extent_of(q, denominators), boundary,
                options);
}

std::vector<Segment> nearest_boundary(const Region& p, const Region& q) {
  return in_numbers_for(
      p, q, extent_of(p), extent_of(q), SlideNumbers::as_needed,
      [&]<typename Numbers>(const Scaling& scaling) { return nearest_in<Numbers>(p, q, scaling); });
}

ComputedSum sum_of_prepared(const PreparedSummand& p, const PreparedSummand& q, Boundary boundary,
                            const EngineOptions& options) {
  const Region &region_p = p.region(), &region_q = q.region();
  if (region_p.components.empty() || region_q.components.empty()) return sum_with_nothing();
  const std::size_t bits_p = p.bits_of_integers(), bits_q = q.bits_of_integers();
  if (are_small(bits_p, bits_q, options))
    return sum_in<SmallNumbers>(p, q, scaling_of_integers(std::max(bits_p, bits_q)), boundary,
                                options);
  if (const Denominators denominators = denominators_for(options);
      denominators == Denominators::any)
    return sum_of(p, q, region_p, region_q, extent_of(region_p, denominators),
                  extent_of(region_q, denominators), boundary, options);
  return sum_of(p, q, region_p, region_q, p.extent(), q.extent(), boundary, options);
}

}  // namespace oplus
