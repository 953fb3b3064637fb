// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>

#include "checked/certificates/certificate.hpp"
#include "checked/engines/engines.hpp"
#include "checked/operations/operations.hpp"
#include "checked/slide/by_slide.hpp"
#include "checked/verify/verify.hpp"
#include "properties/compare/certified_engine.hpp"
#include "properties/compare/engine_called.hpp"
#include "properties/runner/registry.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/definitions/claimed_sum.hpp"
#include "reference/io/boundary_name.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

Outcome check_proved_sum(const Summands& summands) {
  Outcome outcome;
  const auto& [p, q] = summands;
  const std::string fault = why_it_cannot_run("proved", {});
  if (!fault.empty()) return outcome.fail(fault);
  for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
    const PlanarSet proved = proved_engine({}).compute(p, q, boundary, {}).sum;
    for (const Engine& engine : engines())
      if (engine.compute(p, q, boundary, {}).sum != proved)
        return outcome.fail(engine.name + ", " + std::string(name(boundary)) +
                            ": another sum than the proved one");
    outcome.counts["holes of sums"] += proved.holes.size();
    outcome.counts["edges and points of open sums"] +=
        proved.dangling_edges.size() + proved.isolated_vertices.size();
  }
  return outcome;
}

const Registered fact_proved_sum(tight_mixture(), {.id = "fact-proved-sum",
                                                   .kills = {"slide-components-never-overlap",
                                                             "slide-shifts-to-the-left"},
                                                   .cases = 100,
                                                   .check = check_proved_sum});

Outcome check_verify(const Summands& summands) {
  Outcome outcome;
  const auto& [p, q] = summands;
  const OracleSums sums = oracle_sums(p, q);
  for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
    const PlanarSet& sum = boundary == Boundary::open ? sums.open : sums.closed;
    const Verdict verdict = verify(p, q, boundary, sum);
    if (!verdict.is_sum())
      return outcome.fail("verify refuses the oracle's sum: " + verdict.reasons.front().detail,
                          verdict.reasons.front().witness);
    const auto accepts = [&](const ClaimedSum& given) {
      ++outcome.counts["wrong sums"];
      return verify(p, q, boundary, given).is_sum();
    };

    ClaimedSum turned = given(sum);
    for (Component& component : turned.region.components) {
      std::reverse(component.outer.begin(), component.outer.end());
      if (accepts(turned)) return outcome.fail("verify accepts a clockwise outer chain");
      std::reverse(component.outer.begin(), component.outer.end());
    }
    ClaimedSum with_a_point = given(sum);
    with_a_point.region.components.push_back({Chain(3, Point{}), {}});
    if (accepts(with_a_point)) return outcome.fail("verify accepts a chain that is a point");
    for (std::size_t i = 0; i < sum.holes.size(); ++i) {
      PlanarSet filled = sum;
      filled.holes.erase(filled.holes.begin() + static_cast<std::ptrdiff_t>(i));
      if (accepts(given(filled)))
        return outcome.fail("verify accepts a sum without one of its holes");
    }
  }
  if (sums.open != sums.closed) {
    ++outcome.counts["open sums with low-dimensional features"];
    ++outcome.counts["wrong sums"];
    if (verify(p, q, Boundary::open, sums.closed).is_sum() ||
        verify(p, q, Boundary::closed, sums.open).is_sum())
      return outcome.fail("verify accepts the sum of the other kind of boundary");
  }
  return outcome;
}

const Registered fact_verify(
    tight_mixture(),
    {
        .id = "fact-verify",
        .kills = {"chains-may-run-either-way", "copies-are-anywhere-on-a-line-upwards",
                  "edges-of-convex-sums-count-on-neither-side",
                  "points-between-convex-sums-are-inside", "points-need-not-bound",
                  "sides-of-convex-sums-start-anywhere", "triangles-end-where-edges-do",
                  "verify-sees-no-dangling-edges"},
        .cases = 100,
        .check = check_verify,
    });

const ProcessLimits limits{.is_quiet = true};

/// A set that was computed, and what makes a certificate for it or another one.
struct Claimed {
  std::string claim;
  PlanarSet set;
  std::function<certificates::Certificate(const ClaimedSum& set)> certificate;
};

class Claims {
 public:
  explicit Claims(const Summands& summands) : p_(summands.p), q_(summands.q) {}

  Outcome outcome;

  /// Whether the set is certified, and no set that is damaged.
  bool are_right(const Claimed& claimed) {
    const auto& [claim, set, certificate] = claimed;
    const ClaimedSum given = parts_of(set);
    const std::string right = written(certificate(given));
    const EndedProcess ended = checked_certificate(claim, p_, q_, given, right, limits);
    if (!says_certified(ended))
      return fails(claim + ": the right set is not certified: " + ended.output + ended.errors);

    const auto accepts = [&](const ClaimedSum& wrong) {
      ++outcome.counts["wrong sets"];
      return says_certified(checked_certificate(claim, p_, q_, wrong, right, limits));
    };
    if (!given.region.components.empty() &&
        accepts({translated(given.region, {1, 0}), given.dangling_edges, given.isolated_vertices}))
      return fails(claim + ": a translated set is certified");
    for (std::size_t i = 0; i < set.holes.size(); ++i) {
      PlanarSet filled = set;
      filled.holes.erase(filled.holes.begin() + static_cast<std::ptrdiff_t>(i));
      if (accepts(parts_of(filled)))
        return fails(claim + ": a set without one of its holes is certified");
      if (claim == "ifp") continue;  // what lacks placements has a certificate, which is refused
      if (has_certificate(certificate, parts_of(filled)))
        return fails(claim + ": a certificate is found for a set without one of its holes");
    }
    ClaimedSum without_edge = given, without_vertex = given;
    if (!given.dangling_edges.empty()) {
      without_edge.dangling_edges.pop_back();
      if (!lacks_certificate(claimed, without_edge, accepts)) return false;
    }
    if (!given.isolated_vertices.empty()) {
      without_vertex.isolated_vertices.pop_back();
      if (!lacks_certificate(claimed, without_vertex, accepts)) return false;
    }
    return true;
  }

 private:
  bool fails(const std::string& why) {
    outcome.fail(why);
    return false;
  }

  bool has_certificate(const auto& certificate, const ClaimedSum& set) {
    try {
      certificate(set);
      return true;
    } catch (const certificates::PointOutsideSum&) {
      ++outcome.counts["no certificate"];
      return false;
    }
  }

  /// An edge or a vertex is missing, so there is a point that is no sum and no seam goes through it.
  bool lacks_certificate(const Claimed& claimed, const ClaimedSum& wrong, const auto& accepts) {
    if (accepts(wrong))
      return fails(claimed.claim + ": a set without one of its edges or vertices is certified");
    if (has_certificate(claimed.certificate, wrong))
      return fails(claimed.claim +
                   ": a certificate is found for a set without one of its edges or vertices");
    return true;
  }

  const Region &p_, &q_;
};

Outcome check_certificate(const Summands& summands) {
  Claims claims(summands);
  const auto& [p, q] = summands;
  if (!can_certify()) return claims.outcome.fail("oplus-certified was not built");
  const auto sums = oracle_sums(p, q);
  const Claimed all[] = {
      {"sum", sums.closed,
       [&](const ClaimedSum& s) { return certificates::certificate(p, q, s.region); }},
      {"open-sum", sums.open,
       [&](const ClaimedSum& s) { return certificates::open_certificate(p, q, s); }},
      {"nfp", no_fit(p, q, by_slide),
       [&](const ClaimedSum& s) { return certificates::no_fit_certificate(p, q, s); }},
      {"ifp", inner_fit(p, q, by_slide), [&](const ClaimedSum& s) {
         return certificates::inner_fit_certificate(p, q, s, by_slide);
       }}};
  for (const Claimed& claimed : all)
    if (!claims.are_right(claimed)) break;
  return claims.outcome;
}

const Registered fact_certificate(tight_mixture(),
                                  {.id = "fact-certificate",
                                   .kills = {"cells-stick-out-of-sums", "cuts-swap-their-sides",
                                             "seams-run-along-sides", "seams-change-sums-too-early",
                                             "inner-fits-have-another-frame"},
                                   .cases = 100,
                                   .check = check_certificate});

}  // namespace

}  // namespace oplus
