// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_vertical_decomposition_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/minkowski_sum_2.h>

#include <sstream>

#include "tests/bench/sum_engine.hpp"

namespace oplus {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Polygon = CGAL::Polygon_2<Kernel>;
using PolygonWithHoles = CGAL::Polygon_with_holes_2<Kernel>;

/// A double where it is one, which is what CGAL is fastest with; else by way of text, since its exact
/// type depends on how CGAL was configured.
Number number(const Rational& value) {
  if (Rational(value.get_d()) == value) return Number(value.get_d());
  std::istringstream text(value.get_str());
  Number::ET exact;
  text >> exact;
  return Number(exact);
}

Rational rational(const Number& value) {
  std::ostringstream text;
  text << CGAL::exact(value);
  Rational result(text.str());
  result.canonicalize();
  return result;
}

Polygon polygon_of(const Chain& chain) {
  Polygon polygon;
  for (const Point& p : chain) polygon.push_back({number(p.x), number(p.y)});
  return polygon;
}

Chain chain_of(const Polygon& polygon) {
  Chain chain;
  chain.reserve(polygon.size());
  for (const Kernel::Point_2& p : polygon.container())
    chain.push_back({rational(p.x()), rational(p.y())});
  return chain;
}

PolygonWithHoles polygon_of(const Region& region) {
  if (region.components.size() != 1) throw NotTaken("takes one component");
  PolygonWithHoles polygon(polygon_of(region.components[0].outer));
  for (const Chain& hole : region.components[0].holes) polygon.add_hole(polygon_of(hole));
  return polygon;
}

struct PolygonPair {
  PolygonWithHoles p;
  PolygonWithHoles q;

  bool is_simple() const { return p.number_of_holes() == 0 && q.number_of_holes() == 0; }
};

void evaluate_polygon(const Polygon& polygon) {
  for (const Kernel::Point_2& p : polygon.container()) CGAL::exact(p);
}

/// What CGAL's three methods share.
struct Cgal {
  using Input = PolygonPair;
  using Sum = PolygonWithHoles;
  static constexpr Arithmetic arithmetic = Arithmetic::exact;

  PolygonPair converted(const Summands& pair) const {
    return {polygon_of(pair.p), polygon_of(pair.q)};
  }

  ReturnedChains chains(const PolygonPair&, const PolygonWithHoles& sum) const {
    ReturnedChains chains{chain_of(sum.outer_boundary())};
    for (const Polygon& hole : sum.holes()) chains.push_back(chain_of(hole));
    return chains;
  }

  static void evaluate(const PolygonWithHoles& sum) {
    evaluate_polygon(sum.outer_boundary());
    for (const Polygon& hole : sum.holes()) evaluate_polygon(hole);
  }
};

struct Reduced : Cgal {
  PolygonWithHoles sum(const PolygonPair& pair) const {
    if (pair.is_simple())
      return CGAL::minkowski_sum_by_reduced_convolution_2(pair.p.outer_boundary(),
                                                          pair.q.outer_boundary());
    return CGAL::minkowski_sum_by_reduced_convolution_2(pair.p, pair.q);
  }
};

struct Full : Cgal {
  PolygonPair converted(const Summands& pair) const {
    PolygonPair result = Cgal::converted(pair);
    if (!result.is_simple()) throw NotTaken("takes no holes");
    return result;
  }

  PolygonWithHoles sum(const PolygonPair& pair) const {
    return CGAL::minkowski_sum_by_full_convolution_2(pair.p.outer_boundary(),
                                                     pair.q.outer_boundary());
  }
};

struct Vertical : Cgal {
  PolygonWithHoles sum(const PolygonPair& pair) const {
    const CGAL::Polygon_vertical_decomposition_2<Kernel> decomposition;
    if (pair.is_simple())
      return CGAL::minkowski_sum_by_decomposition_2(pair.p.outer_boundary(),
                                                    pair.q.outer_boundary(), decomposition);
    return CGAL::minkowski_sum_by_decomposition_2(pair.p, pair.q, decomposition, decomposition);
  }
};

}  // namespace

std::unique_ptr<PreparedPairs> prepare_cgal_reduced(const std::vector<Summands>& pairs) {
  return sums_by(Reduced{}, pairs);
}

std::unique_ptr<PreparedPairs> prepare_cgal_full(const std::vector<Summands>& pairs) {
  return sums_by(Full{}, pairs);
}

std::unique_ptr<PreparedPairs> prepare_cgal_vertical(const std::vector<Summands>& pairs) {
  return sums_by(Vertical{}, pairs);
}

}  // namespace oplus
