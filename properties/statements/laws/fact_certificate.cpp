// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "checked/certificates/certificate.hpp"
#include "checked/operations/operations.hpp"
#include "checked/slide/by_slide.hpp"
#include "properties/compare/certified_engine.hpp"
#include "properties/runner/registry.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {

namespace {

const ProcessLimits limits{.is_quiet = true};

ClaimedSum as_given(const PlanarSet& set) {
  return {region_of(set), set.dangling_edges, set.isolated_vertices};
}

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
    const ClaimedSum given = as_given(set);
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
      if (accepts(as_given(filled)))
        return fails(claim + ": a set without one of its holes is certified");
      if (claim == "ifp") continue;  // what lacks placements has a certificate, which is refused
      if (has_certificate(certificate, as_given(filled)))
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

Outcome check(const Summands& summands) {
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

const Registered registered(tight_mixture(),
                            {.id = "fact-certificate",
                             .kills = {"cells-stick-out-of-sums", "cuts-swap-their-sides",
                                       "seams-run-along-sides", "seams-change-sums-too-early",
                                       "inner-fits-have-another-frame"},
                             .cases = 100,
                             .check = check});

}  // namespace

}  // namespace oplus
