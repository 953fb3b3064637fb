// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/exhaustive/exhaustive_run.hpp"

#include <gtest/gtest.h>

#include "properties/compare/exhaustive/grid_polygons.hpp"
#include "properties/runner/checked_engines.hpp"
#include "reference/io/invalid_input.hpp"
#include "reference/oracle/oracle.hpp"

namespace oplus {
namespace {

/// The oracle itself, for speed: what is tested here is the run.
const std::vector<Engine> right = {named_engine("right", oracle_sum)};

/// Wrong where Q is not a triangle and P is one.
const std::vector<Engine> wrong = {
    named_engine("wrong", [](const Region& p, const Region& q, Boundary boundary) {
      return oracle_sum(p, vertex_count(q) > 3 ? p : q, boundary);
    })};

ExhaustiveState begun(int side, std::size_t most, std::size_t shard = 1, std::size_t shards = 1) {
  ExhaustiveState state;
  state.scope = {side, most, shard, shards};
  state.engines = {"right"};
  return state;
}

ExhaustiveReports silent() {
  return {[](const ExhaustiveState&) {}, [] { return false; },
          [](const std::string&, const Summands&, const Disagreement&) {}};
}

TEST(ExhaustiveRun, compares_every_orbit) {
  const ExhaustiveState state = run_exhaustively(begun(3, 3), right, 1, silent());
  EXPECT_EQ(state.pairs, pair_orbits(grid_polygons(3, 3)).size());
  EXPECT_EQ(state.done, state.pairs);
  EXPECT_EQ(state.disagreed, 0U);
}

TEST(ExhaustiveRun, is_the_same_with_any_number_of_threads_and_in_shards) {
  const ExhaustiveState whole = run_exhaustively(begun(3, 3), right, 1, silent());
  EXPECT_EQ(run_exhaustively(begun(3, 3), right, 3, silent()).digest, whole.digest);
  SumDigest together;
  std::size_t pairs = 0;
  for (std::size_t shard = 1; shard <= 3; ++shard) {
    const ExhaustiveState part = run_exhaustively(begun(3, 3, shard, 3), right, 1, silent());
    together.add(part.digest);
    pairs += part.pairs;
  }
  EXPECT_EQ(together, whole.digest);
  EXPECT_EQ(pairs, whole.pairs);
}

TEST(ExhaustiveRun, goes_on_where_it_was_interrupted) {
  const ExhaustiveState whole = run_exhaustively(begun(2, 4), right, 1, silent());
  ExhaustiveReports once = silent();
  std::size_t asked = 0;
  once.is_enough = [&] { return asked++ > 0; };
  std::string kept;
  once.after_some = [&](const ExhaustiveState& now) { kept = to_json(now); };
  ExhaustiveState state = begun(3, 4);
  state = run_exhaustively(state, right, 1, once);
  EXPECT_LT(state.done, state.pairs);
  EXPECT_GT(state.done, 0U);
  const ExhaustiveState read = state_of_json(kept, "state.json");
  EXPECT_EQ(to_json(read), to_json(state));
  asked = 0;
  const ExhaustiveState further = run_exhaustively(read, right, 1, once);
  EXPECT_EQ(further.done, 2 * state.done);
  EXPECT_FALSE(further.digest == state.digest);
}

TEST(ExhaustiveRun, finds_what_is_wrong) {
  std::size_t told = 0;
  ExhaustiveReports reports = silent();
  reports.disagreement = [&](const std::string&, const Summands& pair, const Disagreement& found) {
    ++told;
    EXPECT_GT(vertex_count(pair.q), 3U);
    EXPECT_EQ(found.implementation, "wrong");
  };
  const ExhaustiveState state = run_exhaustively(begun(2, 4), wrong, 1, reports);
  EXPECT_GT(state.disagreed, 0U);
  EXPECT_EQ(told, state.disagreed);
}

TEST(ExhaustiveState, refuses_what_is_none) {
  const std::string sound = to_json(begun(3, 3));
  EXPECT_NO_THROW(state_of_json(sound, "state.json"));
  std::string odd_digest = sound, too_many = sound;
  odd_digest.replace(odd_digest.find("0000"), 4, "00x0");
  too_many.replace(too_many.find("\"done\": 0"), 9, "\"done\": 9");
  for (const std::string& text :
       {std::string(), std::string("{}"), sound.substr(0, 40), odd_digest, too_many})
    EXPECT_THROW(state_of_json(text, "state.json"), InvalidInput) << text;
}

TEST(SumDigest, tells_pairs_and_sums_apart_and_adds_up_in_any_order) {
  const MinkowskiSum triangle = canonical_sum(polygon({{0, 0}, {1, 0}, {0, 1}}));
  const MinkowskiSum square = canonical_sum(polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  const auto digest_of = [](std::uint64_t pair, const MinkowskiSum& closed,
                            const MinkowskiSum& open) {
    SumDigest digest;
    digest.add(pair, closed, open);
    return digest;
  };
  const SumDigest one = digest_of(1, triangle, triangle);
  EXPECT_FALSE(one == digest_of(2, triangle, triangle));
  EXPECT_FALSE(one == digest_of(1, square, triangle));
  EXPECT_FALSE(one == digest_of(1, triangle, square));
  EXPECT_EQ(SumDigest(one.to_string()), one);
  SumDigest ab = one, ba = digest_of(2, square, square);
  ab.add(ba);
  ba.add(one);
  EXPECT_EQ(ab, ba);
  SumDigest high("0000000000000000ffffffffffffffff");
  high.add(SumDigest("00000000000000000000000000000001"));
  EXPECT_EQ(high.to_string(), "00000000000000010000000000000000");
  EXPECT_THROW(SumDigest("12"), std::invalid_argument);
}

}  // namespace
}  // namespace oplus
