// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/number_memory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <set>
#include <thread>
#include <vector>

namespace oplus {
namespace {

constexpr std::size_t sizes[] = {8, 16, 24, 40, 112, 120, 128, 136, 1000};

struct Block {
  unsigned char* memory;
  std::size_t size;
  unsigned char content;
};

Block filled(void* memory, std::size_t size, unsigned char content) {
  std::memset(memory, content, size);
  return {static_cast<unsigned char*>(memory), size, content};
}

void expect_content(const Block& block, std::size_t size) {
  EXPECT_TRUE(std::all_of(block.memory, block.memory + size,
                          [&](unsigned char byte) { return byte == block.content; }));
}

TEST(NumberMemory, is_of_one_number_alone) {
  std::vector<Block> blocks;
  for (unsigned i = 0; i < 20000; ++i) {
    const std::size_t size = sizes[i % std::size(sizes)];
    blocks.push_back(filled(NumberMemory::allocate(size), size, static_cast<unsigned char>(i)));
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(blocks.back().memory) % 8, 0U);
    if (i % 3 != 0) continue;
    Block& other = blocks[i / 2];
    expect_content(other, other.size);
    const std::size_t larger = sizes[i / 3 % std::size(sizes)];
    other.memory =
        static_cast<unsigned char*>(NumberMemory::reallocate(other.memory, other.size, larger));
    expect_content(other, std::min(other.size, larger));
    other = filled(other.memory, larger, other.content);
  }
  for (const Block& block : blocks) {
    expect_content(block, block.size);
    NumberMemory::release(block.memory, block.size);
  }
}

#ifndef __SANITIZE_ADDRESS__
TEST(NumberMemory, is_used_again_also_that_of_malloc_and_of_a_thread_that_ended) {
  void* const first = NumberMemory::allocate(16);
  NumberMemory::release(first, 16);
  EXPECT_EQ(NumberMemory::allocate(16), first);
  void* const of_malloc = std::malloc(16);
  NumberMemory::release(of_malloc, 16);
  EXPECT_EQ(NumberMemory::allocate(16), of_malloc);

  // A thread takes the memory that the one before left: blocks that were released, and the rest.
  std::set<void*> seen;
  std::size_t again = 0;
  for (int thread = 0; thread < 4; ++thread) {
    std::jthread([&] {
      std::vector<void*> mine;
      NumberMemory::release(std::malloc(32), 32);  // before it has any
      for (int i = 0; i < 100; ++i) mine.push_back(NumberMemory::allocate(48));
      for (void* const memory : mine) {
        again += seen.insert(memory).second ? 0 : 1;
        NumberMemory::release(memory, 48);
      }
    }).join();
  }
  EXPECT_EQ(again, 300U);
}
#endif

}  // namespace
}  // namespace oplus
