// SPDX-License-Identifier: MIT
#pragma once

#include <boost/container/small_vector.hpp>

namespace oplus::slide {

/// For what lives no longer than a call: on the stack as long as it is short, since the time of small
/// sums is half allocations.
template <typename T>
using ShortList = boost::container::small_vector<T, 48>;

}  // namespace oplus::slide
