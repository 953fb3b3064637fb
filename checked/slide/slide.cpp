// SPDX-License-Identifier: MIT
#include "checked/slide/slide.hpp"

#include "checked/slide/numbers.hpp"
#include "checked/slide/scaling.hpp"
#include "checked/slide/search_statistics.hpp"
#include "checked/slide/sum_in.hpp"

namespace oplus {

using namespace slide;

ComputedSum slide_sum(const Region& p, const Region& q, Boundary boundary,
                      const EngineOptions& options) {
  if (p.components.empty() || q.components.empty())
    return {{}, {}, search_statistics(0, 0, 0, {}, Integers::of_64_bits)};
  if (options.numbers == SlideNumbers::rationals ||
      (options.numbers == SlideNumbers::as_needed && has_unlike_denominators(p, q)))
    return sum_in<RationalNumbers>(p, q, scaling_of_rationals(p, q), boundary, options);
  const Scaling scaling = scaling_of(p, q);
  if (options.numbers == SlideNumbers::as_needed && scaling.bits <= SmallNumbers::bits)
    return sum_in<SmallNumbers>(p, q, scaling, boundary, options);
  if (options.numbers != SlideNumbers::gmp && scaling.bits <= WideNumbers::bits)
    return sum_in<WideNumbers>(p, q, scaling, boundary, options);
  return sum_in<AnyNumbers>(p, q, scaling, boundary, options);
}

}  // namespace oplus
