// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/sums_along_lines.hpp"

#include <gtest/gtest.h>

#include "properties/compare/corpus.hpp"
#include "properties/fuzz/pair_mutation.hpp"
#include "properties/fuzz/realized_pair.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {
namespace {

/// Both sums are those of the oracle, and origins as they are defined.
void expect_right(const Region& p, const Region& q, const std::string& name) {
  const SumsAlongLines found = sums_along_lines(p, q);
  const OracleSums right = oracle_sums(p, q);
  EXPECT_TRUE(found.closed == right.closed) << name;
  EXPECT_TRUE(found.open == right.open) << name;
  const auto reduced = reduced_convolution(p, q);
  EXPECT_EQ(found.origins_of_closed, origins(right.closed, reduced)) << name;
  EXPECT_EQ(found.origins_of_open, origins(right.open, reduced)) << name;
}

TEST(SumsAlongLines, are_those_of_the_oracle_on_the_corpus) {
  for (const CorpusPair& row : corpus())
    if (vertex_count(row.p) * vertex_count(row.q) <= 150) expect_right(row.p, row.q, row.name);
}

/// In all numbers, with low-dimensional features of both kinds.
TEST(SumsAlongLines, are_those_of_the_oracle_on_mutated_pairs) {
  Random random(3);
  std::string bytes;
  for (int i = 0; i < 60; ++i) {
    bytes = mutated_pair(random, one_in(random, 20) ? std::string() : bytes);
    const auto pair = realized(decoded(bytes));
    if (!pair || vertex_count(pair->summands.p) * vertex_count(pair->summands.q) > 60) continue;
    expect_right(pair->summands.p, pair->summands.q, std::to_string(i));
  }
}

}  // namespace
}  // namespace oplus
