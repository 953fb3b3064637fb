// SPDX-License-Identifier: MIT
#include "checked/operations/operations.hpp"

#include "checked/operations/complement.hpp"
#include "checked/oplus/internal/sum_options.hpp"
#include "checked/oplus/oplus.hpp"

namespace oplus {

namespace {

template <typename Compute>
ValidSet operation(Compute compute, const ValidRegion& p, const ValidRegion& q,
                   const SumOptions& options, Boundary of_result = Boundary::closed) {
  const SumOf sum = [&](const Region& a, const Region& b, Boundary boundary) {
    return computed_sum(a, b, boundary, options).sum;
  };
  return set_of(compute(p.region(), q.region(), sum), of_result);
}

}  // namespace

ValidSet nfp(const ValidRegion& p, const ValidRegion& q, const SumOptions& options) {
  return operation(no_fit, p, q, options, Boundary::open);
}

ValidSet ifp(const ValidRegion& p, const ValidRegion& q, const SumOptions& options) {
  return operation(inner_fit, p, q, options);
}

ValidSet erosion(const ValidRegion& p, const ValidRegion& q, const SumOptions& options) {
  return operation(eroded, p, q, options);
}

ValidSet opening(const ValidRegion& p, const ValidRegion& q, const SumOptions& options) {
  return operation(opened, p, q, options);
}

ValidSet closing(const ValidRegion& p, const ValidRegion& q, const SumOptions& options) {
  return operation(closed, p, q, options);
}

ValidRegion complement(const ValidRegion& region) {
  return ValidRegion::found_valid(complement(region.region()));
}

ValidSet complement(const ValidSet& set) {
  return set_of(complement(set.value()),
                set.boundary() == Boundary::open ? Boundary::closed : Boundary::open);
}

}  // namespace oplus
