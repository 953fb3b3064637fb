// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/rows.hpp"

#include <algorithm>
#include <filesystem>

#include "reference/families/coast.hpp"
#include "reference/families/fork.hpp"
#include "reference/families/pairs.hpp"
#include "reference/families/polygons.hpp"
#include "reference/io/reading.hpp"

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

BenchRow pair_of(const std::string& group, const Kind& p, std::size_t n, const Kind& q,
                 std::size_t m, Subject subject = Subject::sums) {
  const std::string name =
      p.name + '_' + std::to_string(n) + "_" + q.name + '_' + std::to_string(m);
  const std::string what = p.words + " of " + std::to_string(n) + " vertices and " + q.words +
                           " of " + std::to_string(m);
  return {(subject == Subject::sums ? "" : "growth_") + name,
          group,
          what,
          subject,
          1,
          [p = p.make, n, q = q.make, m] {
            Random random(1);
            Region first = p(random, n);
            return std::vector<Summands>{{std::move(first), q(random, m)}};
          }};
}

/// Files of the folder of published polygons, without their ending.
struct PublishedFiles {
  std::string name;
  std::string what;
  std::string p;
  std::string q;
};

const std::vector<PublishedFiles>& published() {
  static const std::vector<PublishedFiles> all{
      {"fork", "published fork", "fork_part1", "fork_part2"},
      {"comb", "published comb", "comb_part1", "comb_part2"},
      {"stars", "published stars", "stars_part1", "stars_part2"},
      {"isolated_vertex", "published pair with an isolated vertex", "isolated_vertex_part1",
       "isolated_vertex_part2"},
      {"e_and_g", "published E and G", "E", "G"},
      {"l_and_square", "published L and square", "l_shape", "deg_square"},
      {"holes", "published pair with holes", "pwh1", "pwh2"},
  };
  return all;
}

std::string path_of(const std::string& file) {
  return std::string(OPLUS_DATA_DIR) + '/' + file + ".dat";
}

bool is_there(const PublishedFiles& files) {
  return std::filesystem::exists(path_of(files.p)) && std::filesystem::exists(path_of(files.q));
}

Summands read(const PublishedFiles& files) {
  Region p = read_region_file(path_of(files.p)).region;
  return {std::move(p), read_region_file(path_of(files.q)).region};
}

void add_published(std::vector<BenchRow>& all) {
  for (const PublishedFiles& files : published()) {
    if (!is_there(files)) continue;
    const Summands pair = read(files);
    const std::string group = files.name == "holes" ? "with holes" : "published";
    all.push_back({"published_" + files.name, group,
                   files.what + ", " + std::to_string(vertex_count(pair.p)) + " and " +
                       std::to_string(vertex_count(pair.q)) + " vertices",
                   Subject::sums, 1, [files] { return std::vector<Summands>{read(files)}; }});
  }
}

void add_forks_and_combs(std::vector<BenchRow>& all) {
  for (const std::size_t teeth : {10, 20, 50, 100})
    all.push_back({"fork_" + std::to_string(teeth), "fork and L",
                   "fork of " + std::to_string(teeth) + " teeth an arm, and L", Subject::sums, 1,
                   [teeth] { return std::vector<Summands>{fork_and_l(teeth)}; }});
  for (const std::size_t teeth : {20, 100, 500})
    all.push_back({"comb_" + std::to_string(teeth), "combs",
                   "comb of " + std::to_string(teeth) + " teeth and a small convex polygon",
                   Subject::sums, 1, [teeth] {
                     Random random(1);
                     return std::vector<Summands>{comb_pair(random, teeth)};
                   }});
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

void add_convolutions(std::vector<BenchRow>& all) {
  for (const Kind& kind : {convex, star}) {
    for (const std::size_t n : {50, 100, 200, 400}) {
      all.push_back(pair_of("convolution", kind, n, kind, n, Subject::convolution));
      all.back().name = "convolution_of_" + kind.name + '_' + std::to_string(n);
    }
  }
}

}  // namespace

const std::vector<BenchRow>& rows() {
  static const std::vector<BenchRow> all = [] {
    std::vector<BenchRow> made;
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
    made.push_back({"small_pairs", "small pairs",
                    std::to_string(small_pairs) + " pairs of polygons of 4 to 8 vertices",
                    Subject::sums, small_pairs, make_small_pairs});
    for (const std::size_t n : {55, 95, 175, 300, 388})
      made.push_back(pair_of("growth", star, n, star, n, Subject::growth));
    add_convolutions(made);
    return made;
  }();
  return all;
}

const BenchRow* find_row(const std::string& name) {
  const std::vector<BenchRow>& all = rows();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const BenchRow& row) { return row.name == name; });
  return found == all.end() ? nullptr : &*found;
}

bool is_for(const std::string& engine, const BenchRow& row) {
  if (engine == "traced" || engine == "naive") return row.subject == Subject::convolution;
  if (engine == "slide") return row.subject != Subject::convolution;
  // Where one thread takes so short, starting the second is what would be measured.
  if (engine == "slide2")
    return row.subject == Subject::growth || row.group == "stars" || row.group == "coastlines";
  return row.subject == Subject::sums;
}

std::vector<std::string> missing_published_pairs() {
  std::vector<std::string> missing;
  for (const PublishedFiles& files : published())
    if (!is_there(files)) missing.push_back(files.name);
  return missing;
}

}  // namespace oplus
