// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/run_campaign.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <system_error>

#include "properties/compare/report_json.hpp"
#include "properties/compare/report_text.hpp"
#include "properties/compare/sources.hpp"
#include "reference/oracle/oracle.hpp"
#include "tests/properties/compare/faulty_engines.hpp"

namespace oplus {
namespace {

using Kinds = std::map<std::string, std::size_t>;

/// How many sums of a run an engine gets wrong, counted without what is tested.
std::size_t wrong_sums(const Engine& engine, const SmallRun& run) {
  std::size_t count = 0;
  for (const TaskSource& source : run.sources()) {
    for (std::size_t i = 0; i < source.tasks; ++i) {
      const auto [p, q] = source.task(i).pair;
      for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
        try {
          count += engine.compute(p, q, boundary, {}).sum != slide_sum(p, q, boundary).sum;
        } catch (const std::exception&) {
          ++count;
        }
      }
    }
  }
  return count;
}

/// The report has all failures there are, of this kind only, but for fewer of another kind where one is
/// named, and one pair of the kind that shows it again.
void expect_only(const std::string& kind, const std::string& part, const Engine& engine,
                 const std::string& rarely = "") {
  const SmallRun run{.parts = {part}, .cases = 2, .shrink_tries = 5};
  const std::size_t expected = wrong_sums(engine, run);
  ASSERT_GT(expected, 0U) << kind;
  const CampaignReport report = run.of(engine);
  Kinds kinds = report.all().kinds;
  ASSERT_TRUE(report.counterexamples.contains(kind)) << kind;
  EXPECT_EQ(report.counterexamples.size(), kinds.size());
  if (const std::size_t others = kinds[rarely]; others < kinds[kind]) kinds[kind] += others;
  kinds.erase(rarely);
  EXPECT_EQ(kinds, (Kinds{{kind, expected}}));
  EXPECT_FALSE(report.conforms());
  const ShrunkFailure& shrunk = report.counterexamples.at(kind);
  EXPECT_EQ(shrunk.sum.failure.kind, kind);
  EXPECT_TRUE(shrunk.is_repeatable) << kind;
}

Summands shrunk_pair(const CampaignReport& report, const std::string& kind) {
  return report.counterexamples.at(kind).sum.pair;
}

/// The largest absolute value of a coordinate of a sum's boundary.
Rational size_of_sum(const PlanarSet& sum) {
  Rational size = 1;
  for (const Chain& chain : sum.outer)
    for (const Point& p : chain) size = std::max({size, Rational(abs(p.x)), Rational(abs(p.y))});
  return size;
}

/// A triangle that has nothing in common with a sum.
Chain apart_from(const PlanarSet& sum) {
  const Rational x = 2 * size_of_sum(sum);
  return {{x, x}, {x + 1, x}, {x, x + 1}};
}

TEST(Conformance, slide_conforms_in_every_part) {
  const SmallRun run{.parts = {}, .cases = 3};
  const CampaignReport report = run.of(changed([](PlanarSet&) {}));
  EXPECT_TRUE(report.conforms());
  EXPECT_EQ(parts_of(report).size(), conformance_parts().size());
  for (const CountedSource& source : report.sources)
    EXPECT_GT(source.counts.count("passed"), 0U) << source.name;
  EXPECT_EQ(report.all().pairs, report.pairs);
  EXPECT_EQ(report.done, report.pairs);
}

TEST(Conformance, distinguishes_what_is_lost_and_counts) {
  // Where a component is in the hole, it and the one around become one.
  expect_only("hole lost", "families", changed([](PlanarSet& sum) { sum.holes.clear(); }),
              "components joined");
  expect_only("dangling edge lost", "families",
              changed([](PlanarSet& sum) { sum.dangling_edges.clear(); }));
  expect_only("isolated vertex lost", "families",
              changed([](PlanarSet& sum) { sum.isolated_vertices.clear(); }));
}

TEST(Conformance, distinguishes_wrong_boundaries_and_counts) {
  expect_only("isolated vertex invented", "grids",
              changed([](PlanarSet& sum) { sum.isolated_vertices.push_back(apart_from(sum)[0]); }));
  expect_only("orientation", "grids", changed([](PlanarSet& sum) {
                std::reverse(sum.outer[0].begin(), sum.outer[0].end());
              }));
  expect_only("component lost", "grids", changed([](PlanarSet& sum) {
                sum = {{apart_from(sum)}, {}, {}, {}};
              }));
  expect_only("component invented", "grids",
              changed([](PlanarSet& sum) { sum.outer.push_back(apart_from(sum)); }));
}

TEST(Conformance, shrinks_one_pair_of_a_kind) {
  const SmallRun run{.parts = {"families"}, .cases = 2, .shrink_tries = 100};
  const CampaignReport report = run.of(changed([](PlanarSet& sum) { sum.holes.clear(); }));
  const Summands pair = shrunk_pair(report, "hole lost");
  EXPECT_LE(size_of(pair).vertices, 9U);
  EXPECT_FALSE(slide_sum(pair.p, pair.q, Boundary::closed).sum.holes.empty());
}

TEST(Conformance, sees_one_vertex_too_far_out_and_all_of_them_rounded) {
  expect_only("area larger", "grids", changed([](PlanarSet& sum) {
                PlanarSet moved = sum;
                moved.outer[0][0].x -= size_of_sum(sum) / 1000;
                if (!malformed(moved)) sum = moved;
              }));
  const auto rounded = [](Rational& v, const Rational& grid) {
    const Rational steps = v / grid;
    v = Rational(steps.get_num() / steps.get_den()) * grid;
  };
  expect_only("rounded", "grids", changed([&](PlanarSet& sum) {
                const Rational grid = size_of_sum(sum) / (1 << 24);
                for (auto* chains : {&sum.outer, &sum.holes}) {
                  for (Chain& chain : *chains) {
                    for (Point& p : chain) {
                      rounded(p.x, grid);
                      rounded(p.y, grid);
                    }
                  }
                }
              }));
}

TEST(Conformance, a_missing_sum_is_a_kind_with_its_site) {
  expect_only("crashed: exception: bad luck,  times", "grids",
              changed([](PlanarSet&) { throw std::runtime_error("bad luck, 13 times"); }));
  const auto failing = [](EngineFailure::Kind kind) {
    return faulty("failing", [kind](PlanarSet&, const Summands& pair, Boundary) {
      if (vertex_count(pair.p) > 3) throw EngineFailure(kind, "f.cpp", "a line");
    });
  };
  expect_only("crashed: f.cpp", "grids", failing(EngineFailure::Kind::crashed));
  expect_only("unreadable: f.cpp", "grids", failing(EngineFailure::Kind::unreadable));
  expect_only("out of memory", "grids", failing(EngineFailure::Kind::out_of_memory));
  const Engine hangs = failing(EngineFailure::Kind::hung);
  const SmallRun grids{.parts = {"grids"}};
  const CampaignReport report = grids.of(hangs);
  EXPECT_EQ(report.all().kinds, (Kinds{{"hung", wrong_sums(hangs, grids)}}));
  EXPECT_LE(report.counterexamples.at("hung").tries, grids.shrink_tries / 20 + 1);
}

TEST(Conformance, crashes_at_different_sites_are_different_kinds) {
  const Engine two = faulty("two sites", [](PlanarSet&, const Summands& pair, Boundary) {
    if (vertex_count(pair.p) > 3) throw EngineFailure(EngineFailure::Kind::crashed, "a.hpp", "one");
    if (vertex_count(pair.q) > 3) throw EngineFailure(EngineFailure::Kind::crashed, "b.hpp", "two");
  });
  const CampaignReport report = SmallRun{.parts = {"grids"}}.of(two);
  EXPECT_EQ(vertex_count(shrunk_pair(report, "crashed: a.hpp").p), 4U);
  EXPECT_EQ(vertex_count(shrunk_pair(report, "crashed: b.hpp").p), 3U);
  EXPECT_EQ(vertex_count(shrunk_pair(report, "crashed: b.hpp").q), 4U);
}

TEST(Conformance, unsupported_open_sums_and_refusals_are_counted_apart_and_no_faults) {
  const Engine closed_only =
      faulty("closed only", [](PlanarSet&, const Summands& pair, Boundary boundary) {
        if (boundary == Boundary::open)
          throw EngineFailure(EngineFailure::Kind::open_unsupported, "", "no open sums");
        if (vertex_count(pair.p) == 4)
          throw EngineFailure(EngineFailure::Kind::refused, "", "no squares");
      });
  const CampaignReport report = SmallRun{.parts = {}, .cases = 2}.of(closed_only);
  const Tally all = report.all();
  EXPECT_TRUE(report.conforms());
  EXPECT_EQ(all.count("passed") + all.count("open unsupported") + all.count("refused") +
                all.count("skipped"),
            2 * all.pairs);
  EXPECT_GT(all.count("passed"), 0U);
  EXPECT_GT(all.count("refused"), 0U);
  EXPECT_GE(all.count("open unsupported"), all.pairs - all.count("skipped"));
  EXPECT_EQ(all.open_unsupported,
            (std::map<std::string, std::size_t>{{"closed only", all.count("open unsupported")}}));
  EXPECT_EQ(all.refused, (std::map<std::string, std::size_t>{
                             {"closed only, closed: no squares", all.count("refused")}}));
}

TEST(Conformance, laws_find_more_and_blame_the_sum_that_is_wrong) {
  const Rational far(mpz_class(1) << 300);
  const Engine careless = faulty("careless", [&](PlanarSet& sum, const Summands& pair, Boundary) {
    if (abs(pair.p.components[0].outer[0].x) > far) sum.holes.clear();
  });
  EXPECT_TRUE(SmallRun{}.of(careless).conforms());
  const SmallRun laws{.parts = {"laws"}, .cases = 12, .shrink_tries = 60};
  const CampaignReport report = laws.of(careless);
  for (const auto& [kind, count] : report.all().kinds)
    EXPECT_TRUE(kind == "hole lost" || kind == "components joined") << kind;
  ASSERT_TRUE(report.counterexamples.contains("hole lost"));
  const ShrunkFailure& shrunk = report.counterexamples.at("hole lost");
  EXPECT_GT(abs(shrunk.sum.pair.p.components[0].outer[0].x), far);
  EXPECT_LE(size_of(shrunk.sum.pair).vertices, 20U);
}

TEST(Conformance, statements_judge_where_the_oracle_is_not_asked) {
  // Pairs of the corpus have their sums.
  const SmallRun run{.parts = {"families", "statements", "laws"}, .largest = 0};
  const CampaignReport report = run.of(changed([](PlanarSet& sum) {
    if (!sum.outer.empty()) sum.outer[0][0].x -= 1;
  }));
  for (const auto& [kind, count] : report.all().kinds)
    EXPECT_TRUE(kind.starts_with("breaks ")) << kind;
  EXPECT_TRUE(report.counterexamples.contains("breaks theorem-4.2.1"));
  EXPECT_TRUE(report.counterexamples.contains("breaks theorem-2.2.10"));
  EXPECT_TRUE(report.counterexamples.contains("breaks law-convex"));
  EXPECT_LE(size_of(shrunk_pair(report, "breaks theorem-2.2.10")).vertices, 6U);
}

TEST(Conformance, an_answer_that_is_not_repeated_is_reported_and_not_shrunk) {
  std::size_t asked = 0;
  const Engine once = changed([&](PlanarSet&) {
    if (++asked == 5) throw EngineFailure(EngineFailure::Kind::crashed, "once", "only once");
  });
  const CampaignReport report = SmallRun{.parts = {"grids"}, .threads = 1}.of(once);
  EXPECT_EQ(report.all().kinds, (Kinds{{"crashed: once", 1}}));
  EXPECT_FALSE(report.counterexamples.at("crashed: once").is_repeatable);
}

/// Rulings, kinds, shrunk pairs, the digest: all but the name.
TEST(RunCampaign, same_report_whoever_judges) {
  for (const Engine& faulty :
       {of_many_kinds("faulty"), changed([](PlanarSet& sum) { sum.holes.clear(); }),
        changed([](PlanarSet& sum) { sum.dangling_edges.clear(); }),
        changed([](PlanarSet& sum) { sum.isolated_vertices.clear(); })}) {
    SmallRun run{.parts = {"families", "laws"}, .cases = 2, .shrink_tries = 20};
    const CampaignReport expected = run.of(faulty);
    run.judge = "convex-parts";
    CampaignReport found = run.of(faulty);
    EXPECT_FALSE(found.conforms());
    EXPECT_EQ(other_campaign(expected, found), R"(judge is "convex-parts", not "oracle")");
    found.campaign.judge = "oracle";
    EXPECT_EQ(sealed(found), sealed(expected));
  }
}

TEST(RunCampaign, same_report_however_many_threads) {
  const Engine loses = changed([](PlanarSet& sum) { sum.holes.clear(); });
  const CampaignReport one = SmallRun{.cases = 1, .shrink_tries = 20, .threads = 1}.of(loses);
  const CampaignReport four = SmallRun{.cases = 1, .shrink_tries = 20, .threads = 4}.of(loses);
  EXPECT_FALSE(one.conforms());
  EXPECT_EQ(sealed(one), sealed(four));
}

/// The oracle itself, for speed, on a grid.
const Rules right{.engines = {named_engine("right", oracle_sum)}};

CampaignReport begun(const TaskSource& source) {
  Campaign campaign;
  campaign.engines = {"right"};
  return begun_report("exhaustive", campaign, {}, {source});
}

TEST(RunCampaign, goes_on_where_it_was_interrupted) {
  const TaskSource grid = grid_source(3, 4, 200);
  const CampaignReport whole = run_campaign(begun(grid), {grid}, right, 2);
  EXPECT_EQ(whole.all().ran, 200U);
  std::string kept;
  std::size_t judged_pairs = 0;
  RunWatch watch;
  watch.keep = [&](const CampaignReport& now) { kept = sealed(now); };
  watch.after_pair = [&] { ++judged_pairs; };
  watch.is_interrupted = [&] { return judged_pairs >= 100; };
  const CampaignReport some = run_campaign(begun(grid), {grid}, right, 1, watch);
  EXPECT_EQ(some.done, 100U);
  EXPECT_EQ(some.all().pairs, 100U);
  EXPECT_TRUE(some.is_interrupted());
  EXPECT_EQ(some.verdict(), "conforms, interrupted after 100 of 200 pairs");
  EXPECT_FALSE(some.digest == whole.digest);
  const CampaignReport read = opened(kept, "state.json");
  EXPECT_EQ(sealed(read), sealed(some));
  EXPECT_EQ(sealed(run_campaign(read, {grid}, right, 1)), sealed(whole));
}

TEST(RunCampaign, interrupted_with_threads_has_the_first_pairs) {
  const TaskSource grid = grid_source(3, 4, 100);
  std::atomic<bool> is_interrupted = false;
  std::atomic<std::size_t> asked = 0;
  // The fifth sum is interrupted, and no other.
  const Engine engine = named_engine("right", [&](const Region& p, const Region& q, Boundary b) {
    if (++asked == 5) {
      is_interrupted = true;
      throw std::system_error(std::make_error_code(std::errc::interrupted));
    }
    return oracle_sum(p, q, b);
  });
  RunWatch watch;
  watch.is_interrupted = [&] { return is_interrupted.load(); };
  const CampaignReport some = run_campaign(begun(grid), {grid}, {.engines = {engine}}, 4, watch);
  EXPECT_LE(some.done, 5U);
  EXPECT_TRUE(some.is_interrupted());
  const CampaignReport read = opened(sealed(some), "state.json");
  EXPECT_EQ(sealed(run_campaign(read, {grid}, right, 2)),
            sealed(run_campaign(begun(grid), {grid}, right, 2)));
}

TEST(RunCampaign, interrupted_while_shrinking_keeps_the_smallest_pair_so_far) {
  const TaskSource stars = family_source(*find_family("star"), 2, 1, 8);
  const Rules faulty{.engines = {changed([](PlanarSet& sum) { sum.outer.clear(); })}};
  std::vector<std::size_t> tries;
  RunWatch watch;
  watch.while_shrinking = [&](const ShrunkFailure& found) { tries.push_back(found.tries); };
  watch.is_interrupted = [&] { return tries.size() >= 8; };
  const CampaignReport report = run_campaign(begun(stars), {stars}, faulty, 2, watch);
  EXPECT_EQ(report.done, report.pairs);
  EXPECT_TRUE(report.is_interrupted());
  EXPECT_EQ(report.verdict(), "does not conform, interrupted while shrinking");
  const ShrunkFailure& found = report.counterexamples.begin()->second;
  EXPECT_FALSE(found.is_shrunk);
  EXPECT_TRUE(found.is_repeatable);
  EXPECT_EQ(found.tries, 8U);
  // Before each try, and at the end.
  EXPECT_EQ(tries, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(RunCampaign, keeps_the_smallest_of_as_many_kinds_as_are_wanted) {
  const TaskSource grid = grid_source(3, 4, 200);
  const Rules faulty{.engines = {of_many_kinds("faulty")}};
  const CampaignReport all = run_campaign(begun(grid), {grid}, faulty, 2);
  CampaignReport first = begun(grid);
  first.campaign.shrink = 1;
  first = run_campaign(first, {grid}, faulty, 2);
  ASSERT_EQ(first.counterexamples.size(), 1U);
  EXPECT_EQ(first.all().kinds, all.all().kinds);
  for (const auto& [kind, found] : all.counterexamples)
    EXPECT_FALSE(found.found_size < first.counterexamples.begin()->second.found_size);
}

TEST(RunCampaign, passes_on_what_a_source_throws) {
  const TaskSource bad{"test", "bad", 1,
                       [](std::size_t) -> Task { throw std::out_of_range("no"); }};
  EXPECT_THROW(run_campaign(begun(bad), {bad}, right, 2), std::out_of_range);
}

}  // namespace
}  // namespace oplus
