// SPDX-License-Identifier: MIT
#include "checked/distance/distance.hpp"

#include <utility>

#include "checked/distance/point_location.hpp"
#include "checked/distance/ways_out.hpp"
#include "checked/oplus/oplus.hpp"
#include "reference/definitions/region.hpp"

namespace oplus {

namespace {

void require_points(const ValidRegion& p, const ValidRegion& q) {
  for (const ValidRegion* region : {&p, &q})
    if (region->components().empty())
      throw InvalidInput({"distance", 0, 0}, "a region is empty", "regions with points");
}

}  // namespace

NearestPoints distance(const ValidRegion& p, const ValidRegion& q) {
  require_points(p, q);
  return distance(p.region(), q.region());
}

std::optional<Overlap> depth(const ValidRegion& p, const ValidRegion& q) {
  return depth(p.region(), q.region());
}

struct Placements::State {
  State(const ValidRegion& of_p, const ValidRegion& of_q, const SumOptions& options)
      : p(of_p), q(of_q), no_fit(nfp(p, q, options)) {}

  ValidRegion p, q;
  ValidSet no_fit;
  PointLocation location{no_fit.value()};
  WaysOut ways_out{edges(p.region()), edges(q.region()), no_fit.value()};
};

Placements::Placements(const ValidRegion& p, const ValidRegion& q, const SumOptions& options) {
  require_points(p, q);
  state_ = std::make_shared<const State>(p, q, options);
}

const ValidSet& Placements::no_fit() const { return state_->no_fit; }

Location Placements::locate(const Coordinates& x) const {
  return state_->location.locate(x.point());
}

std::optional<Overlap> Placements::depth(const Coordinates& x) const {
  if (locate(x) != Location::inside) return std::nullopt;
  return state_->ways_out.from(x.point());
}

NearestPoints Placements::distance(const Coordinates& x) const {
  if (locate(x) == Location::inside)
    return oplus::distance(state_->p.region(), translated(state_->q.region(), x.point()));
  Overlap to_contact = state_->ways_out.from(x.point());
  Point on_q = to_contact.contact - to_contact.move;
  return {std::move(to_contact.squared_depth), std::move(to_contact.contact), std::move(on_q)};
}

}  // namespace oplus
