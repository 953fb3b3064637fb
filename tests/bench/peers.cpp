// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/peers.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/minkowski_sum_2.h>

#include "reference/definitions/contract.hpp"

namespace oplus {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;

/// By way of text: CGAL's exact number type depends on how CGAL was configured.
Kernel::FT number(const Rational& value) {
  const auto exact = [](const mpz_class& integer) {
    std::istringstream text(integer.get_str());
    Kernel::FT::ET result;
    text >> result;
    return Kernel::FT(result);
  };
  return exact(value.get_num()) / exact(value.get_den());
}

Polygon polygon_of(const Region& region) {
  OPLUS_REQUIRES(region.components.size() == 1 && region.components[0].holes.empty(), "simple");
  Polygon polygon;
  for (const Point& p : region.components[0].outer) polygon.push_back({number(p.x), number(p.y)});
  return polygon;
}

}  // namespace

struct CgalSum::Polygons {
  Polygon p;
  Polygon q;
};

CgalSum::CgalSum(const Summands& summands)
    : polygons_(new Polygons{polygon_of(summands.p), polygon_of(summands.q)}) {}

CgalSum::~CgalSum() { delete polygons_; }

std::size_t CgalSum::by_reduced_convolution() const {
  return CGAL::minkowski_sum_by_reduced_convolution_2(polygons_->p, polygons_->q).number_of_holes();
}

}  // namespace oplus
