// SPDX-License-Identifier: MIT
#pragma once

#include <boost/container/small_vector.hpp>
#include <span>

namespace oplus::slide {

/// For what lives no longer than a call: on the stack as long as it is short, since the time of small
/// sums is half allocations.
template <typename T>
using ShortList = boost::container::small_vector<T, 48>;

/// Boost's iterators are not contiguous for std::span.
template <typename T>
std::span<const T> span_of(const ShortList<T>& list) {
  return {list.data(), list.size()};
}

}  // namespace oplus::slide
