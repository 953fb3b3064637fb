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

/// Calls compute.operator()<Numbers>(scaling) with numbers in which both can be computed.
template <typename Compute>
auto in_numbers_for(const Region& p, const Region& q, SlideNumbers numbers,
                    const Compute& compute) {
  if (numbers == SlideNumbers::rationals ||
      (numbers == SlideNumbers::as_needed && has_unlike_denominators(p, q)))
    return compute.template operator()<RationalNumbers>(scaling_of_rationals(p, q));
  const Scaling scaling = scaling_of(p, q);
  if (numbers == SlideNumbers::as_needed && scaling.bits <= SmallNumbers::bits)
    return compute.template operator()<SmallNumbers>(scaling);
  if (numbers != SlideNumbers::gmp && scaling.bits <= WideNumbers::bits)
    return compute.template operator()<WideNumbers>(scaling);
  return compute.template operator()<AnyNumbers>(scaling);
}

/// Summands are regions, or prepared ones.
template <typename OneSummand>
ComputedSum sum_of(const OneSummand& p, const OneSummand& q, const Region& region_p,
                   const Region& region_q, Boundary boundary, const EngineOptions& options) {
  return in_numbers_for(region_p, region_q, options.numbers,
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
  return sum_of(p, q, p, q, boundary, options);
}

std::vector<Segment> nearest_boundary(const Region& p, const Region& q) {
  return in_numbers_for(
      p, q, SlideNumbers::as_needed,
      [&]<typename Numbers>(const Scaling& scaling) { return nearest_in<Numbers>(p, q, scaling); });
}

ComputedSum sum_of_prepared(const PreparedSummand& p, const PreparedSummand& q, Boundary boundary,
                            const EngineOptions& options) {
  if (p.region().components.empty() || q.region().components.empty()) return sum_with_nothing();
  const std::size_t bits = std::max(p.bits_of_integers(), q.bits_of_integers());
  if (options.numbers == SlideNumbers::as_needed && p.bits_of_integers() > 0 &&
      q.bits_of_integers() > 0 && bits <= SmallNumbers::bits)
    return sum_in<SmallNumbers>(p, q, scaling_of_integers(bits), boundary, options);
  return sum_of(p, q, p.region(), q.region(), boundary, options);
}

}  // namespace oplus
