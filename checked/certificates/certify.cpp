// SPDX-License-Identifier: MIT
#include "checked/certificates/certificate.hpp"
#include "checked/oplus/oplus.hpp"
#include "reference/definitions/region.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

std::string certify(const ValidRegion& p, const ValidRegion& q, const ClaimedSum& given,
                    Boundary boundary) {
  const Verdict verdict = verify(p, q, given, boundary);
  if (!verdict.is_sum()) {
    const Reason& first = verdict.reasons.front();
    throw InvalidInput({"S", 0, 0},
                       "it is not the sum: " + describe(first.kind) + ": " + first.detail +
                           "; at " + to_string(first.witness),
                       "the sum of P and Q");
  }
  const auto checked = [](const Point& point) { return Coordinates(point).point(); };
  ClaimedSum sum{mapped(given.region, checked), {}, {}};
  if (const auto vertex = certificates::repeated_vertex(sum.region))
    throw InvalidInput({"S", 0, 0}, "the vertex " + to_string(*vertex) + " twice in a row",
                       "an edge between them");
  if (boundary == Boundary::closed)
    return written(certificates::certificate(p.region(), q.region(), sum.region));
  for (const auto& [source, target] : given.dangling_edges)
    sum.dangling_edges.push_back({checked(source), checked(target)});
  for (const Point& point : given.isolated_vertices)
    sum.isolated_vertices.push_back(checked(point));
  return written(certificates::open_certificate(p.region(), q.region(), sum));
}

}  // namespace oplus
