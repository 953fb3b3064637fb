// SPDX-License-Identifier: MIT
// Verifies a sum that another program computed.
#include <iostream>
#include <oplus/oplus.hpp>

int main() {
  auto frame = oplus::polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {3, 1}, {3, 3}, {1, 3}}});
  auto square = oplus::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});

  // It may be anything: here, the hole is lost.
  oplus::ClaimedSum given = oplus::read_claimed_sum("POLYGON((0 0,5 0,5 5,0 5,0 0))");
  oplus::Verdict verdict = verify(frame, square, given);
  std::cout << (verdict.is_sum() ? "right" : "wrong") << '\n';
  for (const oplus::Reason& reason : verdict.reasons)
    std::cout << describe(reason.kind) << ": " << reason.detail << "\nat " << reason.witness.x
              << ' ' << reason.witness.y << '\n';
  std::cout << "holes: " << verdict.right.holes.size() << '\n';

  // Where a point is missing, points of the summands that add up to it.
  given.region = square.region();
  verdict = verify(square, square, given);
  if (const std::optional<oplus::Addends>& sum = verdict.addends)
    std::cout << verdict.reasons[0].witness.x << " = " << sum->p.x << " + " << sum->q.x << '\n';

  std::cout << verify(frame, square, minkowski_sum(frame, square)).is_sum() << '\n';
}
