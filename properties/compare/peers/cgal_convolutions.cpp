// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/minkowski_sum_2.h>

#include "properties/compare/peers/cgal_methods.hpp"
#include "properties/compare/peers/returned_chains.hpp"

namespace oplus {

CgalMethod::Sum CgalReduced::sum(const Input& pair) const {
  if (pair.is_simple())
    return CGAL::minkowski_sum_by_reduced_convolution_2(pair.p.outer_boundary(),
                                                        pair.q.outer_boundary());
  return CGAL::minkowski_sum_by_reduced_convolution_2(pair.p, pair.q);
}

CgalMethod::Sum CgalFull::sum(const Input& pair) const {
  return CGAL::minkowski_sum_by_full_convolution_2(pair.p.outer_boundary(),
                                                   pair.q.outer_boundary());
}

ReturnedChains cgal_reduced(const Summands& pair) { return returned_chains<CgalReduced>(pair); }
ReturnedChains cgal_full(const Summands& pair) { return returned_chains<CgalFull>(pair); }

}  // namespace oplus
