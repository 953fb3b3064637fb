// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/rows.hpp"

#include <utility>

#include "reference/families/fork.hpp"
#include "reference/families/pairs.hpp"
#include "reference/families/polygons.hpp"
#include "tests/bench/engine.hpp"
#include "tests/bench/published_pairs.hpp"

namespace oplus {

namespace {

constexpr std::size_t small_pairs = 2000;

using MakePolygon = Region (*)(Random& random, std::size_t n);

/// One kind of polygon: its name in a row's name, and in words.
struct Kind {
  std::string name;
  std::string words;
  MakePolygon make;
};

const Kind star{"star", "star", star_polygon};
const Kind simple{"simple", "simple polygon", simple_polygon};
const Kind convex{"convex", "convex polygon", convex_polygon};

/// So large that the other summand is a few hundredths of it: a coast is summed with what sails there.
Region large_coast(Random& random, std::size_t n) {
  Region coast = coast_polygon(random, n);
  for (Point& p : coast.components[0].outer) p = Rational(32) * p;
  return coast;
}

const Kind coast{"coast", "coastline", large_coast};

Row row_of(const std::string& name, const std::string& group, const std::string& what,
           std::function<std::vector<Summands>()> make, Subject subject = Subject::sums) {
  Row row;
  row.name = name;
  row.group = group;
  row.what = what;
  row.subject = subject;
  row.make = std::move(make);
  return row;
}

Row pair_of(const std::string& group, const Kind& p, std::size_t n, const Kind& q, std::size_t m,
            Subject subject = Subject::sums) {
  const std::string name =
      p.name + '_' + std::to_string(n) + "_" + q.name + '_' + std::to_string(m);
  const auto make = [p = p.make, n, q = q.make, m] {
    Random random(1);
    Region first = p(random, n);
    return std::vector<Summands>{{std::move(first), q(random, m)}};
  };
  return row_of((subject == Subject::sums ? "" : "growth_") + name, group,
                p.words + " of " + std::to_string(n) + " vertices and " + q.words + " of " +
                    std::to_string(m),
                make, subject);
}

void add_published(std::vector<Row>& all) {
  for (const PublishedPair& published : published_pairs()) {
    if (published.what.empty() || !published.is_there()) continue;
    const Summands pair = published.read();
    const std::string group = published.name == "holes" ? "with holes" : "published";
    all.push_back(row_of("published_" + published.name, group,
                         published.what + ", " + std::to_string(vertex_count(pair.p)) + " and " +
                             std::to_string(vertex_count(pair.q)) + " vertices",
                         [published] { return std::vector<Summands>{published.read()}; }));
  }
}

void add_forks_and_combs(std::vector<Row>& all) {
  for (const std::size_t teeth : {10, 20, 50, 100})
    all.push_back(row_of("fork_" + std::to_string(teeth), "fork and L",
                         "fork of " + std::to_string(teeth) + " teeth an arm, and L",
                         [teeth] { return std::vector<Summands>{fork_and_l(teeth)}; }));
  for (const std::size_t teeth : {20, 100, 500})
    all.push_back(row_of("comb_" + std::to_string(teeth), "combs",
                         "comb of " + std::to_string(teeth) + " teeth and a small convex polygon",
                         [teeth] {
                           Random random(1);
                           return std::vector<Summands>{comb_pair(random, teeth)};
                         }));
}

/// Of 4 to 8 vertices each.
std::vector<Summands> make_small_pairs() {
  std::vector<Summands> pairs;
  const Family& grid = *find_family("grid");
  for (std::uint64_t seed = 1; pairs.size() < small_pairs; ++seed) {
    Summands pair = generate(grid, 8, seed);
    if (vertex_count(pair.p) >= 4 && vertex_count(pair.q) >= 4) pairs.push_back(std::move(pair));
  }
  return pairs;
}

void add_convolutions(std::vector<Row>& all) {
  for (const Kind& kind : {convex, star}) {
    for (const std::size_t n : {50, 100, 200, 400}) {
      all.push_back(pair_of("convolution", kind, n, kind, n, Subject::convolution));
      all.back().name = "convolution_of_" + kind.name + '_' + std::to_string(n);
    }
  }
}

/// The engines for a row.
std::vector<std::string> engines_for(const Row& row) {
  if (row.subject == Subject::convolution) return {"traced", "without-points", "naive"};
  if (row.subject == Subject::growth) return {"slide", "slide2"};
  std::vector<std::string> names;
  for (const BenchEngine& engine : bench_engines()) {
    // Where one thread takes so short, starting the second is what would be measured.
    const bool is_for_row =
        engine.name != "slide2" || row.group == "stars" || row.group == "coastlines";
    if (engine.subject == Subject::sums && is_for_row) names.push_back(engine.name);
  }
  return names;
}

}  // namespace

const std::vector<Row>& benchmark_rows() {
  static const std::vector<Row> all = [] {
    std::vector<Row> made;
    add_published(made);
    for (const std::size_t n : {50, 100, 200, 300})
      made.push_back(pair_of("stars", star, n, star, 100));
    for (const std::size_t n : {50, 100, 150, 200})
      made.push_back(pair_of("simple polygons", simple, n, simple, 100));
    for (const std::size_t n : {50, 200, 500, 980})
      made.push_back(pair_of("convex and star", convex, n, star, 100));
    add_forks_and_combs(made);
    for (const std::size_t n : {1000, 5000}) {
      made.push_back(pair_of("coastlines", coast, n, convex, 20));
      made.push_back(pair_of("coastlines", coast, n, star, 100));
    }
    made.push_back(row_of("small_pairs", "small pairs",
                          std::to_string(small_pairs) + " pairs of polygons of 4 to 8 vertices",
                          make_small_pairs));
    made.back().pairs = small_pairs;
    for (const std::size_t n : {55, 95, 175, 300, 388})
      made.push_back(pair_of("growth", star, n, star, n, Subject::growth));
    add_convolutions(made);
    for (Row& row : made) row.engines = engines_for(row);
    return made;
  }();
  return all;
}

std::vector<std::string> missing_published_pairs() {
  std::vector<std::string> missing;
  for (const PublishedPair& pair : published_pairs())
    if (!pair.what.empty() && !pair.is_there()) missing.push_back(pair.name);
  return missing;
}

}  // namespace oplus
