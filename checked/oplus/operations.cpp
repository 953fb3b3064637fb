// SPDX-License-Identifier: MIT
#include "checked/operations/operations.hpp"

#include <utility>

#include "checked/operations/complement.hpp"
#include "checked/oplus/internal/sum_options.hpp"
#include "checked/oplus/oplus.hpp"

namespace oplus {

Sum set_of(PlanarSet value, Boundary boundary) { return Sum(std::move(value), boundary, {}, {}); }

namespace {

template <typename Compute>
Sum operation(Compute compute, const ValidRegion& p, const ValidRegion& q,
              const SumOptions& options, Boundary of_result = Boundary::closed) {
  const SumOf sum = [&](const Region& a, const Region& b, Boundary boundary) {
    return computed_sum(a, b, boundary, options).sum;
  };
  return set_of(compute(p.region(), q.region(), sum), of_result);
}

}  // namespace

Sum nfp(const ValidRegion& p, const ValidRegion& q, const SumOptions& options) {
  return operation(no_fit, p, q, options, Boundary::open);
}

Sum ifp(const ValidRegion& p, const ValidRegion& q, const SumOptions& options) {
  return operation(inner_fit, p, q, options);
}

Sum erosion(const ValidRegion& p, const ValidRegion& q, const SumOptions& options) {
  return operation(eroded, p, q, options);
}

Sum opening(const ValidRegion& p, const ValidRegion& q, const SumOptions& options) {
  return operation(opened, p, q, options);
}

Sum closing(const ValidRegion& p, const ValidRegion& q, const SumOptions& options) {
  return operation(closed, p, q, options);
}

ValidRegion complement(const ValidRegion& region) {
  return ValidRegion::found_valid(complement(region.region()));
}

Sum complement(const Sum& set) {
  return set_of(complement(set.value()),
                set.boundary() == Boundary::open ? Boundary::closed : Boundary::open);
}

}  // namespace oplus
