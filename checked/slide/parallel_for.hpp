// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace oplus::slide {

constexpr std::size_t in_a_lot = 128;  ///< segments or places, for one thread at a time

/// Calls work(0), ..., work(n - 1), each once, on the calling thread and up to threads - 1 others, or as
/// many as can be started. Throws one of the exceptions that work throws; then some calls are left out.
void parallel_for(std::size_t n, unsigned threads, const std::function<void(std::size_t)>& work);

/// Calls work(first, last) for parts of 0 to n that do not depend on the number of threads.
template <typename Work>
void for_each_part(std::size_t n, unsigned threads, const Work& work,
                   std::size_t in_a_part = 4096) {
  // Where there is little to do, a call through std::function is much.
  if (n <= in_a_part) return n > 0 ? work(std::size_t{0}, n) : void();
  parallel_for((n + in_a_part - 1) / in_a_part, threads, [&](std::size_t part) {
    work(part * in_a_part, std::min((part + 1) * in_a_part, n));
  });
}

/// Returns find(first, last) of each such part, in order.
template <typename Find>
auto found_in_parts(std::size_t n, unsigned threads, const Find& find, std::size_t in_a_part) {
  std::vector<decltype(find(n, n))> found((n + in_a_part - 1) / in_a_part);
  for_each_part(
      n, threads,
      [&](std::size_t first, std::size_t last) { found[first / in_a_part] = find(first, last); },
      in_a_part);
  return found;
}

/// Sorts; the result does not depend on the number of threads if no two elements are equivalent.
template <typename Elements, typename Less>
void sort_in_parts(Elements& elements, unsigned threads, const Less& less) {
  constexpr std::size_t parts = 8, too_few = 1 << 14;
  if (threads < 2 || elements.size() < too_few) {
    std::sort(elements.begin(), elements.end(), less);
    return;
  }
  const auto at = [&](std::size_t part) {
    return elements.begin() + static_cast<std::ptrdiff_t>(elements.size() * part / parts);
  };
  parallel_for(parts, threads, [&](std::size_t part) { std::sort(at(part), at(part + 1), less); });
  for (std::size_t width = 1; width < parts; width *= 2)
    parallel_for(parts / (2 * width), threads, [&](std::size_t pair) {
      const std::size_t first = 2 * width * pair;
      std::inplace_merge(at(first), at(first + width), at(first + 2 * width), less);
    });
}

}  // namespace oplus::slide
