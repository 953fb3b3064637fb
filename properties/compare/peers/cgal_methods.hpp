// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_vertical_decomposition_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/minkowski_sum_2.h>

#include <cmath>
#include <sstream>

#include "properties/compare/peers/integer_scale.hpp"
#include "reference/chains/touching_points.hpp"

namespace oplus {

/// What CGAL's methods share. The kernel is that of its manual's examples.
struct CgalMethod {
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Number = Kernel::FT;
  using Polygon = CGAL::Polygon_2<Kernel>;
  using PolygonWithHoles = CGAL::Polygon_with_holes_2<Kernel>;

  using Part = PolygonWithHoles;
  struct Input {
    PolygonWithHoles p;
    PolygonWithHoles q;

    bool is_simple() const { return p.number_of_holes() == 0 && q.number_of_holes() == 0; }
  };
  using Sum = PolygonWithHoles;
  static constexpr bool rounds = false;

  /// With integers its filters of doubles decide most.
  static IntegerScale scale_of(const std::vector<Region>& regions) {
    return IntegerScale::least(regions);
  }
  Part part(const Region& region, const IntegerScale& scale) const {
    return polygon_of(mapped(region, [&](const Point& p) { return scale.factor * p; }));
  }
  Input paired(const Part& p, const Part& q) const { return {p, q}; }
  Input converted(const Summands& pair) const { return {polygon_of(pair.p), polygon_of(pair.q)}; }

  ReturnedChains chains(const Input&, const PolygonWithHoles& sum) const {
    ReturnedChains chains{chain_of(sum.outer_boundary())};
    for (const Polygon& hole : sum.holes()) chains.push_back(chain_of(hole));
    return chains;
  }

  static void evaluate(const PolygonWithHoles& sum) {
    evaluate_polygon(sum.outer_boundary());
    for (const Polygon& hole : sum.holes()) evaluate_polygon(hole);
  }

 private:
  /// A double where it is one, which is what CGAL is fastest with; else by way of text, since its
  /// exact type depends on how CGAL was configured.
  static Number number(const Rational& value) {
    const double nearest = value.get_d();
    if (std::isfinite(nearest) && Rational(nearest) == value) return Number(nearest);
    std::istringstream text(value.get_str());
    Number::ET exact;
    text >> exact;
    return Number(exact);
  }

  static Rational rational(const Number& value) {
    std::ostringstream text;
    text << CGAL::exact(value);
    Rational result(text.str());
    result.canonicalize();
    return result;
  }

  static Polygon polygon_of(const Chain& chain) {
    Polygon polygon;
    for (const Point& p : chain) polygon.push_back({number(p.x), number(p.y)});
    return polygon;
  }

  static Chain chain_of(const Polygon& polygon) {
    Chain chain;
    chain.reserve(polygon.size());
    for (const Kernel::Point_2& p : polygon.container())
      chain.push_back({rational(p.x()), rational(p.y())});
    return chain;
  }

  /// CGAL wants chains to touch in common vertices only (is_valid_polygon_with_holes), so a vertex is
  /// added where one touches an edge of another.
  static PolygonWithHoles polygon_of(const Region& region) {
    if (region.components.size() != 1) throw Unsupported("supports one component only");
    PolygonWithHoles polygon;
    for (const std::vector<Segment>& pieces : pieces_by_chain(region)) {
      Chain chain;
      for (const Segment& piece : pieces) chain.push_back(piece.source);
      if (polygon.outer_boundary().is_empty())
        polygon.outer_boundary() = polygon_of(chain);
      else
        polygon.add_hole(polygon_of(chain));
    }
    return polygon;
  }

  static void evaluate_polygon(const Polygon& polygon) {
    for (const Kernel::Point_2& p : polygon.container()) CGAL::exact(p);
  }
};

struct CgalWithoutHoles : CgalMethod {
  Input paired(const Part& p, const Part& q) const {
    Input result{p, q};
    if (!result.is_simple()) throw Unsupported("does not support holes");
    return result;
  }
  Input converted(const Summands& pair) const {
    const auto [p, q] = CgalMethod::converted(pair);
    return paired(p, q);
  }
};

struct CgalReduced : CgalMethod {
  Sum sum(const Input& pair) const {
    if (pair.is_simple())
      return CGAL::minkowski_sum_by_reduced_convolution_2(pair.p.outer_boundary(),
                                                          pair.q.outer_boundary());
    return CGAL::minkowski_sum_by_reduced_convolution_2(pair.p, pair.q);
  }
};

struct CgalFull : CgalWithoutHoles {
  Sum sum(const Input& pair) const {
    return CGAL::minkowski_sum_by_full_convolution_2(pair.p.outer_boundary(),
                                                     pair.q.outer_boundary());
  }
};

/// By decomposition into convex polygons.
template <typename Decomposition>
struct CgalDecomposing : CgalWithoutHoles {
  Sum sum(const Input& pair) const {
    return CGAL::minkowski_sum_by_decomposition_2(pair.p.outer_boundary(), pair.q.outer_boundary(),
                                                  Decomposition());
  }
};

/// Two of CGAL's decompositions take holes.
template <typename Decomposition>
struct CgalDecomposingHoles : CgalMethod {
  Sum sum(const Input& pair) const {
    if (pair.is_simple()) return CgalDecomposing<Decomposition>().sum(pair);
    const Decomposition decomposition;
    return CGAL::minkowski_sum_by_decomposition_2(pair.p, pair.q, decomposition, decomposition);
  }
};

using CgalVertical =
    CgalDecomposingHoles<CGAL::Polygon_vertical_decomposition_2<CgalMethod::Kernel>>;

}  // namespace oplus
