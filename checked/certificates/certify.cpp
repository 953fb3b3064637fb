// SPDX-License-Identifier: MIT
#include "checked/certificates/certificate.hpp"
#include "checked/oplus/oplus.hpp"
#include "reference/definitions/region.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

std::string certify(const ValidRegion& p, const ValidRegion& q, const ClaimedSum& given) {
  const Verdict verdict = verify(p, q, given);
  if (!verdict.is_sum()) {
    const Reason& first = verdict.reasons.front();
    throw InvalidInput({"S", 0, 0},
                       "it is not the sum: " + describe(first.kind) + ": " + first.detail +
                           "; at " + to_string(first.witness),
                       "the sum of P and Q");
  }
  const Region sum =
      mapped(given.region, [](const Point& vertex) { return Coordinates(vertex).point(); });
  if (const auto vertex = certificates::repeated_vertex(sum))
    throw InvalidInput({"S", 0, 0}, "the vertex " + to_string(*vertex) + " twice in a row",
                       "an edge between them");
  return written(certificates::certificate(p.region(), q.region(), sum));
}

}  // namespace oplus
