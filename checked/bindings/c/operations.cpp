// SPDX-License-Identifier: MIT
// Sums, and what is made of them.
#include "checked/bindings/c/set.hpp"

namespace {

using namespace oplus;

Number number(const char* text, const char* name) { return Number(&c::given(text, name)); }

/// The sum of regions is cheaper than that of sets.
ValidSet sum(const ValidSet& p, const ValidSet& q, Boundary boundary) {
  const SumOptions options{.boundary = boundary};
  return c::is_region(p) && c::is_region(q) ? minkowski_sum(p.region(), q.region(), options)
                                            : minkowski_sum(p, q, options);
}

using Operation = ValidSet (*)(const ValidRegion&, const ValidRegion&, const SumOptions&);

oplus_code put(oplus_set** result, Operation operation, const oplus_set* p, const oplus_set* q) {
  return c::put(result, [&] { return operation(c::region(p, "p"), c::region(q, "q"), {}); });
}

}  // namespace

oplus_code oplus_sum(const oplus_set* p, const oplus_set* q, int boundary, oplus_set** result) {
  return c::put(result, [&] { return sum(c::set(p, "p"), c::set(q, "q"), c::boundary(boundary)); });
}

oplus_code oplus_nfp(const oplus_set* p, const oplus_set* q, oplus_set** places) {
  return c::put(places, [&] { return sum(c::set(p, "p"), -c::set(q, "q"), Boundary::open); });
}

oplus_code oplus_ifp(const oplus_set* p, const oplus_set* q, oplus_set** places) {
  return put(places, ifp, p, q);
}

oplus_code oplus_erosion(const oplus_set* p, const oplus_set* q, oplus_set** set) {
  return put(set, erosion, p, q);
}

oplus_code oplus_opening(const oplus_set* p, const oplus_set* q, oplus_set** set) {
  return put(set, opening, p, q);
}

oplus_code oplus_closing(const oplus_set* p, const oplus_set* q, oplus_set** set) {
  return put(set, closing, p, q);
}

oplus_code oplus_reflected(const oplus_set* p, oplus_set** set) {
  return c::put(set, [&] { return -c::set(p, "p"); });
}

oplus_code oplus_complement(const oplus_set* p, oplus_set** set) {
  return c::put(set, [&] { return complement(c::set(p, "p")); });
}

oplus_code oplus_disc(const char* radius, int side, const char* error, oplus_set** set) {
  return c::put(set, [&] {
    if (side != OPLUS_CONTAIN && side != OPLUS_CONTAINED)
      c::refuse("side", "it is " + std::to_string(side), "OPLUS_CONTAIN or OPLUS_CONTAINED");
    return disc(number(radius, "radius"),
                side == OPLUS_CONTAIN ? DiscSide::outside : DiscSide::inside,
                number(error, "error"));
  });
}

oplus_code oplus_rounded(const oplus_set* p, const char* step, int side, oplus_set** set) {
  constexpr Side sides[] = {Side::nearest, Side::contain, Side::contained};
  return c::put(set, [&] {
    return rounded(c::set(p, "p"), number(step, "step"),
                   sides[c::one_of(side, OPLUS_CONTAINED, "side")])
        .sum;
  });
}
