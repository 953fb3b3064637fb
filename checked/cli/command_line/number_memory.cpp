// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/number_memory.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <mutex>

namespace oplus {

namespace {

constexpr std::size_t unit = 8, chunk_size = 1U << 15U;
#ifdef __SANITIZE_ADDRESS__  // which sees more in blocks of malloc
constexpr std::size_t largest = 0;
#else
constexpr std::size_t largest = 120;
#endif

struct Block {
  Block* next;
};

/// What a thread has. Trivially destructible: numbers may be released after the thread's other objects.
struct Pool {
  std::array<Block*, largest / unit + 1> free;  ///< by their sizes in units
  std::byte* next;                              ///< what is left of a chunk
  std::byte* end;
};

constinit thread_local Pool pool{};

/// The pools of threads that ended, in blocks of their own.
struct Left {
  Pool pool;
  Left* next;
};
std::mutex mutex;
constinit Left* left = nullptr;

/// Takes the pool of a thread that ended, and leaves this one's.
struct AtEndOfThread {
  /// Requires: the thread has no chunk.
  AtEndOfThread() {
    const std::lock_guard lock(mutex);
    if (left == nullptr) return;
    Left* const first = left;
    left = first->next;
    for (std::size_t count = 0; count < pool.free.size(); ++count) {
      Block** end = &pool.free[count];  // a thread may release before it allocates
      while (*end != nullptr) end = &(*end)->next;
      *end = first->pool.free[count];
    }
    pool.next = first->pool.next;
    pool.end = first->pool.end;
    std::free(first);
  }
  ~AtEndOfThread() {
    auto* const mine = static_cast<Left*>(std::malloc(sizeof(Left)));
    if (mine == nullptr) return;
    const std::lock_guard lock(mutex);
    *mine = {pool, left};
    left = mine;
    pool = {};
  }
  AtEndOfThread(const AtEndOfThread&) = delete;
  AtEndOfThread& operator=(const AtEndOfThread&) = delete;
};

std::size_t units(std::size_t size) { return std::max<std::size_t>((size + unit - 1) / unit, 1); }

void release_units(void* memory, std::size_t count) {
  auto* const block = static_cast<Block*>(memory);
  block->next = pool.free[count];
  pool.free[count] = block;
}

void* allocate_units(std::size_t count) {
  const auto take = [&]() -> void* {
    if (Block* const block = pool.free[count]) {
      pool.free[count] = block->next;
      return block;
    }
    const std::size_t size = count * unit;
    if (static_cast<std::size_t>(pool.end - pool.next) < size) return nullptr;
    std::byte* const memory = pool.next;
    pool.next += size;
    return memory;
  };
  if (void* const memory = take()) return memory;
  thread_local AtEndOfThread at_end;
  if (void* const memory = take()) return memory;
  auto* const chunk = static_cast<std::byte*>(std::malloc(chunk_size));
  if (chunk == nullptr) return nullptr;
  if (pool.next != pool.end)
    release_units(pool.next, static_cast<std::size_t>(pool.end - pool.next) / unit);
  pool.next = chunk;
  pool.end = chunk + chunk_size;
  return take();
}

}  // namespace

void* NumberMemory::allocate(std::size_t size) noexcept {
  return size > largest ? std::malloc(size) : allocate_units(units(size));
}

void NumberMemory::release(void* memory, std::size_t size) noexcept {
  if (size > largest)
    std::free(memory);
  else
    release_units(memory, units(size));
}

void* NumberMemory::reallocate(void* old, std::size_t old_size, std::size_t size) noexcept {
  if (old_size > largest && size > largest) return std::realloc(old, size);
  if (old_size <= largest && size <= largest && units(old_size) == units(size)) return old;
  void* const memory = allocate(size);
  if (memory == nullptr) return nullptr;
  std::memcpy(memory, old, std::min(old_size, size));
  release(old, old_size);
  return memory;
}

}  // namespace oplus
