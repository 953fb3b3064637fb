// SPDX-License-Identifier: MIT
#include "checked/operations/operations.hpp"

#include "checked/operations/complement.hpp"
#include "checked/oplus/internal/named_operations.hpp"
#include "checked/oplus/internal/sum_options.hpp"
#include "checked/oplus/oplus.hpp"

namespace oplus {

ValidSet value_of(const std::string& operation, const ValidRegion& p, const ValidRegion& q,
                  const SumOptions& options) {
  const Operation& called = operation_called(operation);
  const SumOf sum = [&](const Region& a, const Region& b, Boundary boundary) {
    return computed_sum(a, b, boundary, options).sum;
  };
  return set_of(called.compute(p.region(), q.region(), sum), called.boundary);
}

std::vector<NamedOperation> named_operations() {
  std::vector<NamedOperation> all;
  for (const Operation& operation : operations()) all.push_back({operation.name, operation.what});
  return all;
}

ValidSet nfp(const ValidRegion& p, const ValidRegion& q, const SumOptions& options) {
  return value_of("nfp", p, q, options);
}

ValidSet ifp(const ValidRegion& p, const ValidRegion& q, const SumOptions& options) {
  return value_of("ifp", p, q, options);
}

ValidSet erosion(const ValidRegion& p, const ValidRegion& q, const SumOptions& options) {
  return value_of("erode", p, q, options);
}

ValidSet opening(const ValidRegion& p, const ValidRegion& q, const SumOptions& options) {
  return value_of("open", p, q, options);
}

ValidSet closing(const ValidRegion& p, const ValidRegion& q, const SumOptions& options) {
  return value_of("close", p, q, options);
}

ValidRegion complement(const ValidRegion& region) {
  return ValidRegion::found_valid(complement(region.region()));
}

ValidSet complement(const ValidSet& set) {
  return set_of(complement(set.value()),
                set.boundary() == Boundary::open ? Boundary::closed : Boundary::open);
}

}  // namespace oplus
