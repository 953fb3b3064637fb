// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/conformance/run.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reference/definitions/difference.hpp"
#include "tests/properties/compare/conformance/faulty_implementations.hpp"

namespace oplus {
namespace {

using Kinds = std::map<std::string, std::size_t>;

/// How many sums of the plan an implementation gets wrong, counted without what is tested.
std::size_t wrong_sums(const Engine& implementation, const ConformancePlan& plan) {
  std::size_t count = 0;
  for (const Trial& trial : plan.trials) {
    const auto [p, q] = trial.make();
    for (const Boundary boundary : {Boundary::closed, Boundary::open}) {
      try {
        count += implementation.compute(p, q, boundary, {}).sum != slide_sum(p, q, boundary).sum;
      } catch (const std::exception&) {
        ++count;
      }
    }
  }
  return count;
}

/// The report has all failures there are, of this kind only, but for fewer of another kind where one is
/// named, and one pair of the kind that shows it again.
void expect_only(const std::string& kind, const std::string& part, const Engine& implementation,
                 const std::string& rarely = "") {
  ConformanceSettings settings = few({part});
  settings.cases = 2;
  settings.shrink_tries = 5;
  const ConformancePlan plan = conformance_plan(settings);
  const std::size_t expected = wrong_sums(implementation, plan);
  ASSERT_GT(expected, 0U) << kind;
  const ConformanceReport report = run_conformance(implementation, settings, plan, 2);
  Kinds kinds = report.all().kinds;
  ASSERT_TRUE(report.counterexamples.contains(kind)) << kind;
  EXPECT_EQ(report.counterexamples.size(), kinds.size());
  if (const std::size_t others = kinds[rarely]; others < kinds[kind]) kinds[kind] += others;
  kinds.erase(rarely);
  EXPECT_EQ(kinds, (Kinds{{kind, expected}}));
  EXPECT_FALSE(report.conforms());
  const ShrunkFailure& shrunk = report.counterexamples.at(kind);
  EXPECT_EQ(shrunk.seen.failure.kind, kind);
  EXPECT_TRUE(shrunk.is_repeatable) << kind;
}

Summands shrunk_pair(const ConformanceReport& report, const std::string& kind) {
  return report.counterexamples.at(kind).seen.summands;
}

/// The largest absolute value of a coordinate of a sum's boundary.
Rational size_of_sum(const MinkowskiSum& sum) {
  Rational size = 1;
  for (const Chain& chain : sum.outer)
    for (const Point& p : chain) size = std::max({size, Rational(abs(p.x)), Rational(abs(p.y))});
  return size;
}

/// A triangle that has nothing in common with a sum.
Chain apart_from(const MinkowskiSum& sum) {
  const Rational x = 2 * size_of_sum(sum);
  return {{x, x}, {x + 1, x}, {x, x + 1}};
}

TEST(Conformance, slide_conforms_in_every_part) {
  ConformanceSettings settings;
  settings.cases = 3;
  const ConformanceReport report = conformance_of(
      named_engine("slide", [](const Region& p, const Region& q,
                               Boundary boundary) { return slide_sum(p, q, boundary).sum; }),
      settings);
  EXPECT_TRUE(report.conforms());
  std::set<std::string> parts;
  for (std::size_t i = 0; i < report.groups.size(); ++i) {
    parts.insert(report.groups[i].part);
    EXPECT_GT(report.tallies[i].count(Ruling::passed), 0U) << report.groups[i].name;
    EXPECT_EQ(report.tallies[i].pairs, report.groups[i].pairs);
  }
  EXPECT_EQ(parts.size(), conformance_parts().size());
}

TEST(Conformance, tells_what_is_lost_apart_and_counts_them) {
  // Where a component is in the hole, it and the one around become one.
  expect_only("hole lost", "families", changed([](MinkowskiSum& sum) { sum.holes.clear(); }),
              "components joined");
  expect_only("dangling edge lost", "families",
              changed([](MinkowskiSum& sum) { sum.dangling_edges.clear(); }));
  expect_only("isolated vertex lost", "families",
              changed([](MinkowskiSum& sum) { sum.isolated_vertices.clear(); }));
}

TEST(Conformance, tells_kinds_of_wrong_boundaries_apart_and_counts_them) {
  expect_only("isolated vertex invented", "grids", changed([](MinkowskiSum& sum) {
                sum.isolated_vertices.push_back(apart_from(sum)[0]);
              }));
  expect_only("orientation", "grids", changed([](MinkowskiSum& sum) {
                std::reverse(sum.outer[0].begin(), sum.outer[0].end());
              }));
  expect_only("component lost", "grids", changed([](MinkowskiSum& sum) {
                sum = {{apart_from(sum)}, {}, {}, {}};
              }));
  expect_only("component invented", "grids",
              changed([](MinkowskiSum& sum) { sum.outer.push_back(apart_from(sum)); }));
}

TEST(Conformance, shrinks_one_pair_of_a_kind) {
  ConformanceSettings settings = few({"families"});
  settings.cases = 2;
  settings.shrink_tries = 100;
  const ConformanceReport report =
      conformance_of(changed([](MinkowskiSum& sum) { sum.holes.clear(); }), settings);
  const Summands pair = shrunk_pair(report, "hole lost");
  EXPECT_LE(size_of(pair).vertices, 9U);
  EXPECT_FALSE(slide_sum(pair.p, pair.q, Boundary::closed).sum.holes.empty());
}

TEST(Conformance, sees_one_vertex_too_far_out_and_all_of_them_rounded) {
  expect_only("area larger", "grids", changed([](MinkowskiSum& sum) {
                MinkowskiSum moved = sum;
                moved.outer[0][0].x -= size_of_sum(sum) / 1000;
                if (!malformed(moved)) sum = moved;
              }));
  const auto rounded = [](Rational& v, const Rational& grid) {
    const Rational steps = v / grid;
    v = Rational(steps.get_num() / steps.get_den()) * grid;
  };
  expect_only("rounded", "grids", changed([&](MinkowskiSum& sum) {
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

TEST(Conformance, what_is_no_sum_is_a_kind_with_its_site) {
  const auto always = [](const Summands&) { return true; };
  expect_only(
      "crashed: exception: bad luck,  times", "grids",
      failing(always, []() -> MinkowskiSum { throw std::runtime_error("bad luck, 13 times"); }));
  const auto no_sum = [](NoSum::Kind kind) {
    return [kind]() -> MinkowskiSum { throw NoSum(kind, "f.cpp", "a line"); };
  };
  const auto large = [](const Summands& s) { return vertex_count(s.p) > 3; };
  expect_only("crashed: f.cpp", "grids", failing(large, no_sum(NoSum::Kind::crashed)));
  expect_only("unreadable: f.cpp", "grids", failing(large, no_sum(NoSum::Kind::unreadable)));
  expect_only("out of memory", "grids", failing(large, no_sum(NoSum::Kind::out_of_memory)));
  const Engine hangs = failing(large, no_sum(NoSum::Kind::hung));
  const ConformanceReport report = conformance_of(hangs, few({"grids"}));
  EXPECT_EQ(report.all().kinds,
            (Kinds{{"hung", wrong_sums(hangs, conformance_plan(few({"grids"})))}}));
  EXPECT_LE(report.counterexamples.at("hung").tries, report.settings.shrink_tries / 20 + 1);
}

TEST(Conformance, crashes_at_different_sites_are_different_kinds) {
  const Engine two = named_engine(
      "two sites", [](const Region& p, const Region& q, Boundary boundary) -> MinkowskiSum {
        if (vertex_count(p) > 3) throw NoSum(NoSum::Kind::crashed, "a.hpp", "one");
        if (vertex_count(q) > 3) throw NoSum(NoSum::Kind::crashed, "b.hpp", "two");
        return slide_sum(p, q, boundary).sum;
      });
  const ConformanceReport report = conformance_of(two, few({"grids"}));
  EXPECT_EQ(vertex_count(shrunk_pair(report, "crashed: a.hpp").p), 4U);
  EXPECT_EQ(vertex_count(shrunk_pair(report, "crashed: b.hpp").p), 3U);
  EXPECT_EQ(vertex_count(shrunk_pair(report, "crashed: b.hpp").q), 4U);
}

TEST(Conformance, what_is_not_taken_is_counted_and_no_fault) {
  const Engine closed_only = named_engine(
      "closed only", [](const Region& p, const Region& q, Boundary boundary) -> MinkowskiSum {
        if (boundary == Boundary::open) throw NoSum(NoSum::Kind::not_taken, "", "no open sums");
        return slide_sum(p, q, boundary).sum;
      });
  ConformanceSettings settings;
  settings.cases = 2;
  const ConformanceReport report = conformance_of(closed_only, settings);
  const ConformanceTally all = report.all();
  EXPECT_TRUE(report.conforms());
  EXPECT_EQ(all.count(Ruling::passed) + all.count(Ruling::not_taken) + all.count(Ruling::skipped),
            2 * all.pairs);
  EXPECT_GT(all.count(Ruling::passed), 0U);
  EXPECT_GE(all.count(Ruling::not_taken), all.pairs - all.count(Ruling::skipped));
}

TEST(Conformance, laws_find_what_pairs_do_not_and_blame_the_sum_that_is_wrong) {
  const Rational far(mpz_class(1) << 300);
  const Engine careless =
      named_engine("careless", [&](const Region& p, const Region& q, Boundary boundary) {
        MinkowskiSum sum = slide_sum(p, q, boundary).sum;
        if (abs(p.components[0].outer[0].x) > far) sum.holes.clear();
        return sum;
      });
  EXPECT_TRUE(conformance_of(careless).conforms());
  ConformanceSettings settings;
  settings.cases = 12;
  settings.parts = {"laws"};
  settings.shrink_tries = 60;
  const ConformanceReport report = conformance_of(careless, settings);
  for (const auto& [kind, count] : report.all().kinds)
    EXPECT_TRUE(kind == "hole lost" || kind == "components joined") << kind;
  ASSERT_TRUE(report.counterexamples.contains("hole lost"));
  const ShrunkFailure& shrunk = report.counterexamples.at("hole lost");
  EXPECT_GT(abs(shrunk.seen.summands.p.components[0].outer[0].x), far);
  EXPECT_LE(size_of(shrunk.seen.summands).vertices, 20U);
}

TEST(Conformance, statements_judge_where_the_oracle_is_not_asked) {
  ConformanceSettings settings;
  settings.cases = 4;
  settings.largest = 0;
  settings.parts = {"families", "statements", "laws"};  // rows of the corpus have their sums
  const ConformanceReport report = conformance_of(changed([](MinkowskiSum& sum) {
                                                    if (!sum.outer.empty()) sum.outer[0][0].x -= 1;
                                                  }),
                                                  settings);
  for (const auto& [kind, count] : report.all().kinds)
    EXPECT_TRUE(kind.starts_with("breaks ")) << kind;
  EXPECT_TRUE(report.counterexamples.contains("breaks theorem-4.2.1"));
  EXPECT_TRUE(report.counterexamples.contains("breaks theorem-2.2.10"));
  EXPECT_TRUE(report.counterexamples.contains("breaks law-convex"));
  EXPECT_LE(size_of(shrunk_pair(report, "breaks theorem-2.2.10")).vertices, 6U);
}

TEST(Conformance, an_answer_that_is_not_repeated_is_reported_and_not_shrunk) {
  std::size_t asked = 0;
  const Engine once =
      named_engine("once", [&](const Region& p, const Region& q, Boundary boundary) {
        if (++asked == 5) throw NoSum(NoSum::Kind::crashed, "once", "only once");
        return slide_sum(p, q, boundary).sum;
      });
  const ConformanceReport report =
      run_conformance(once, few({"grids"}), conformance_plan(few({"grids"})), 1);
  EXPECT_EQ(report.all().kinds, (Kinds{{"crashed: once", 1}}));
  EXPECT_FALSE(report.counterexamples.at("crashed: once").is_repeatable);
}

TEST(Conformance, same_report_however_many_threads) {
  const Engine loses = changed([](MinkowskiSum& sum) { sum.holes.clear(); });
  ConformanceSettings settings = few();
  settings.cases = 1;
  settings.shrink_tries = 20;
  const ConformancePlan plan = conformance_plan(settings);
  const ConformanceReport one = run_conformance(loses, settings, plan, 1);
  const ConformanceReport four = run_conformance(loses, settings, plan, 4);
  EXPECT_FALSE(one.conforms());
  EXPECT_EQ(to_json(one).dump(), to_json(four).dump());
  EXPECT_EQ(to_markdown(one), to_markdown(four));
  EXPECT_EQ(to_junit(one), to_junit(four));
}

TEST(Conformance, given_pairs_are_asked_of_the_oracle_and_of_every_statement) {
  const Summands pair{polygon({{0, 0}, {1, 0}, {0, 1}}), polygon({{0, 0}, {1, 0}, {0, 1}})};
  const ConformancePlan plan = plan_of_pairs({{"a b", pair}});
  EXPECT_EQ(plan.groups[0].name, "a b, by the oracle");
  EXPECT_EQ(plan.groups.size(), plan.trials.size());
  EXPECT_GT(plan.groups.size(), 15U);
  EXPECT_TRUE(run_conformance(changed([](MinkowskiSum&) {}), few(), plan, 1).conforms());
}

}  // namespace
}  // namespace oplus
