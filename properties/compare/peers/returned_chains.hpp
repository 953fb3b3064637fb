// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "properties/compare/peers/method.hpp"

namespace oplus {

/// A method as a function: what it returns for a pair. Throws NotTaken; and may do anything else that
/// somebody else's code does.
using MethodFunction = ReturnedChains(const Summands& pair);

template <typename Method>
ReturnedChains returned_chains(const Summands& pair) {
  const Method method;
  const typename Method::Input input = method.converted(pair);
  return method.chains(input, method.sum(input));
}

MethodFunction cgal_reduced;
MethodFunction cgal_full;
MethodFunction cgal_vertical;
MethodFunction cgal_triangulation;
MethodFunction cgal_small_side;
MethodFunction cgal_optimal;
MethodFunction cgal_hertel_mehlhorn;
MethodFunction cgal_greene;
MethodFunction clipper;
MethodFunction boost_polygon;

}  // namespace oplus
