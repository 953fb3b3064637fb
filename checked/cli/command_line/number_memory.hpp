// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace oplus {

/// Memory for the numbers of GMP, most of which have one limb or two: of each size from blocks of its own, a
/// multiple of 8 bytes, for which malloc would take 32 at least. As GMP says the size of what it releases, blocks
/// have no headers. Each thread has its free blocks; those of a thread that ends are for a later one. What was
/// taken is used again, but not given back to the system. From 128 bytes on it is malloc's.
class NumberMemory {
 public:
  /// Null where there is no memory.
  static void* allocate(std::size_t size) noexcept;
  /// Null, and nothing changed, where there is no memory.
  static void* reallocate(void* old, std::size_t old_size, std::size_t size) noexcept;
  /// Also of what malloc allocated, which is used again then.
  static void release(void* memory, std::size_t size) noexcept;
};

}  // namespace oplus
