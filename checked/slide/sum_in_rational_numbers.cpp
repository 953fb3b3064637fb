// SPDX-License-Identifier: MIT
#include "checked/slide/nearest_in_numbers.hpp"
#include "checked/slide/sum_in_numbers.hpp"

namespace oplus::slide {

template ComputedSum sum_in<RationalNumbers>(const Region&, const Region&, const Scaling&, Boundary,
                                             const EngineOptions&);
template ComputedSum sum_in<RationalNumbers>(const PreparedSummand&, const PreparedSummand&,
                                             const Scaling&, Boundary, const EngineOptions&);
template std::vector<Segment> nearest_in<RationalNumbers>(const Region&, const Region&,
                                                          const Scaling&);

}  // namespace oplus::slide
