// SPDX-License-Identifier: MIT
#include "reference/arithmetic/limb_pool.hpp"

#include <gmp.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

namespace oplus {

namespace {

constexpr std::size_t limb = sizeof(mp_limb_t), most_limbs = 4;
constexpr std::size_t in_a_list = 4096;  // blocks that threads exchange at once

struct Block {
  Block* next;
};
static_assert(sizeof(Block) <= limb && alignof(Block) <= limb);

struct List {
  Block* first = nullptr;
  std::size_t size = 0;
};

struct {
  void* (*allocate)(std::size_t);
  void* (*reallocate)(void*, std::size_t, std::size_t);
  void (*free)(void*, std::size_t);
} others;

/// Free blocks that belong to no thread. Never destroyed: numbers may be static.
struct Shared {
  std::mutex mutex;
  std::array<std::vector<List>, most_limbs> lists;
};
Shared& shared() {
  static Shared& of_all = *new Shared;
  return of_all;
}

/// A thread's free blocks of each size: a list to take from and to put to, and one more, empty or full.
struct Blocks {
  List list;
  List reserve;
};
constinit thread_local std::array<Blocks, most_limbs> of_thread;

void share(std::size_t size, List& list) {
  if (list.size == 0) return;
  const std::lock_guard lock(shared().mutex);
  shared().lists[size].push_back(std::exchange(list, {}));
}

/// Leaves a thread's blocks to the others when the thread ends.
struct SharedAtEnd {
  ~SharedAtEnd() {
    for (std::size_t size = 0; size < most_limbs; ++size)
      for (List* list : {&of_thread[size].list, &of_thread[size].reserve}) share(size, *list);
  }
};

[[gnu::noinline]] void share_at_end() { thread_local const SharedAtEnd at_end; }

List list_of_new_blocks(std::size_t size) {
  const std::size_t bytes = (size + 1) * limb;
  char* const memory = static_cast<char*>(others.allocate(in_a_list * bytes));
  List list;
  for (; list.size < in_a_list; ++list.size)
    list.first = new (memory + (in_a_list - 1 - list.size) * bytes) Block{list.first};
  return list;
}

[[gnu::noinline]] void fill(std::size_t size) {
  share_at_end();
  Blocks& blocks = of_thread[size];
  if (blocks.reserve.size > 0) {
    std::swap(blocks.list, blocks.reserve);
    return;
  }
  {
    const std::lock_guard lock(shared().mutex);
    std::vector<List>& lists = shared().lists[size];
    if (!lists.empty()) {
      blocks.list = lists.back();
      lists.pop_back();
      return;
    }
  }
  blocks.list = list_of_new_blocks(size);
}

[[gnu::noinline]] void make_room(std::size_t size) {
  share_at_end();
  Blocks& blocks = of_thread[size];
  if (blocks.list.size == 0) return;
  share(size, blocks.reserve);
  blocks.reserve = std::exchange(blocks.list, {});
}

/// Of a number of bytes, how many limbs more than one; `most_limbs` and more are too many.
std::size_t size_of(std::size_t bytes) { return bytes == 0 ? 0 : (bytes - 1) / limb; }

void* allocate(std::size_t bytes) {
  const std::size_t size = size_of(bytes);
  if (size >= most_limbs) return others.allocate(bytes);
  List& list = of_thread[size].list;
  if (list.size == 0) fill(size);
  --list.size;
  return std::exchange(list.first, list.first->next);
}

void release(void* memory, std::size_t bytes) {
  const std::size_t size = size_of(bytes);
  if (size >= most_limbs) return others.free(memory, bytes);
  List& list = of_thread[size].list;
  if (list.size == 0 || list.size == in_a_list) make_room(size);
  list.first = new (memory) Block{list.first};
  ++list.size;
}

void* reallocate(void* memory, std::size_t bytes, std::size_t wanted) {
  const std::size_t size = size_of(bytes), wanted_size = size_of(wanted);
  if (size == wanted_size && size < most_limbs) return memory;
  if (size >= most_limbs && wanted_size >= most_limbs)
    return others.reallocate(memory, bytes, wanted);
  void* const moved = allocate(wanted);
  std::memcpy(moved, memory, std::min(bytes, wanted));
  release(memory, bytes);
  return moved;
}

}  // namespace

void pool_limbs() {
  mp_get_memory_functions(&others.allocate, &others.reallocate, &others.free);
  mp_set_memory_functions(allocate, reallocate, release);
}

}  // namespace oplus
