// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/row.hpp"

#include <algorithm>
#include <filesystem>
#include <tuple>
#include <utility>

#include "properties/runner/source_tree.hpp"
#include "reference/families/pairs.hpp"
#include "reference/families/polygons.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/region_lines.hpp"
#include "tests/bench/engine.hpp"

namespace oplus {

namespace {

constexpr std::size_t small_pairs = 2000;
constexpr std::size_t distance_pairs = 200;

/// A kind of polygon: its part of a row's name, and its description.
struct Kind {
  std::string name;
  std::string words;
  Region (*make)(Random& random, std::size_t n);
};

const Kind star{"star", "star", star_polygon};
const Kind simple{"simple", "simple polygon", simple_polygon};
const Kind convex{"convex", "convex polygon", convex_polygon};

/// Much larger than the other summand, as a coast is larger than a ship.
Region large_coast(Random& random, std::size_t n) {
  return mapped(coast_polygon(random, n), [](const Point& p) { return 32 * p; });
}

const Kind coast{"coast", "coastline", large_coast};

Region maze(Random& random, std::size_t n) { return maze_pair(random, n / 4).p; }

const Kind maze_kind{"maze", "maze", maze};

Region unit_square(Random&, std::size_t) { return polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}); }

const Kind square{"square", "unit square", unit_square};

Row pair_of(const std::string& group, const Kind& p, std::size_t n, const Kind& q, std::size_t m) {
  const std::string of_n = std::to_string(n);
  const std::string of_m = std::to_string(m);
  return {.name = p.name + '_' + of_n + "_" + q.name + '_' + of_m,
          .group = group,
          .what = p.words + " of " + of_n + " vertices and " + q.words + " of " + of_m,
          .make = [p = p.make, n, q = q.make, m] {
            Random random(1);
            return std::vector<Summands>{{p(random, n), q(random, m)}};  // in this order
          }};
}

Rows published_rows() {
  Rows rows;
  for (const auto& [name, what, p, q] :
       std::initializer_list<std::tuple<std::string, std::string, std::string, std::string>>{
           {"comb", "comb", "comb_part1", "comb_part2"},
           {"fork", "fork", "fork_part1", "fork_part2"},
           {"stars", "stars", "stars_part1", "stars_part2"},
           {"isolated_vertex", "pair with an isolated vertex", "isolated_vertex_part1",
            "isolated_vertex_part2"},
           {"e_and_g", "E and G", "E", "G"},
           {"l_and_square", "L and square", "l_shape", "deg_square"},
           {"holes", "pair with holes", "pwh1", "pwh2"}}) {
    const Summands pair = published_pair(p, q)[0];
    rows.push_back({.name = "published_" + name,
                    .group = name == "holes" ? "with holes" : "published",
                    .what = "published " + what + ", " + std::to_string(vertex_count(pair.p)) +
                            " and " + std::to_string(vertex_count(pair.q)) + " vertices",
                    .make = [=, p = p, q = q] { return published_pair(p, q); }});
  }
  return rows;
}

Row fork_and_l_row(std::size_t teeth) {
  const std::string count = std::to_string(teeth);
  return {.name = "fork_" + count,
          .group = "fork and L",
          .what = "fork of " + count + " teeth per arm, and L",
          .make = [teeth] { return std::vector<Summands>{fork_and_l(teeth)}; }};
}

Row comb_row(std::size_t teeth) {
  const std::string count = std::to_string(teeth);
  return {.name = "comb_" + count,
          .group = "combs",
          .what = "comb of " + count + " teeth and a small convex polygon",
          .make = [teeth] {
            Random random(1);
            return std::vector<Summands>{comb_pair(random, teeth)};
          }};
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

Row small_pairs_row() {
  return {.name = "small_pairs",
          .group = "small pairs",
          .what = std::to_string(small_pairs) + " pairs of polygons of 4 to 8 vertices",
          .pairs = small_pairs,
          .make = make_small_pairs};
}

/// The row in another section of the page.
Row in_section(const std::string& subject, const std::string& prefix, Row row) {
  row.name = prefix + '_' + row.name;
  row.group = row.subject = subject;
  return row;
}

/// A pair of a family on which an earlier slide took long, by what makes it hard.
Row hard_row(const std::string& family, std::size_t n) {
  return {.name = family + '_' + std::to_string(n),
          .group = "hard",
          .what = family + " of " + std::to_string(n),
          .make = [=] { return std::vector<Summands>{generate(*find_family(family), n, 1)}; }};
}

/// Tall teeth side by side, and a convex polygon as wide as hundreds of them.
Row tall_comb_row(long teeth) {
  const std::string count = std::to_string(teeth);
  return {.name = "tall_" + count,
          .group = "hard",
          .what = "comb of " + count + " tall teeth and a wide convex polygon",
          .make = [teeth] {
            constexpr long width = 1000;
            constexpr long height = 1'000'000;
            Chain comb = {{0, -width}, {2 * width * teeth, -width}};
            for (long x = 2 * width * (teeth - 1); x >= 0; x -= 2 * width)
              for (const auto& [dx, y] : std::initializer_list<std::pair<long, long>>{
                       {width, 0}, {width, height}, {0, height}, {0, 0}})
                if (x + dx > 0 || y > 0) comb.push_back({x + dx, y});
            Random random(1);
            return std::vector<Summands>{{polygon(std::move(comb)), convex_polygon(random, 20)}};
          }};
}

/// The worst that we know for a segment: beside the large square, all that doubles see of the star is a point, so that
/// leading digits tell what does not block.
Row far_scales_row(std::size_t n) {
  return {.name = "far_scales_" + std::to_string(n),
          .group = "hard",
          .what = "star of " + std::to_string(n) + " and a square of side 10^100",
          .make = [n] {
            Random random(1);
            mpz_class side;
            mpz_ui_pow_ui(side.get_mpz_t(), 10, 100);
            return std::vector<Summands>{
                {star_polygon(random, n), polygon({{0, 0}, {side, 0}, {side, side}, {0, side}})}};
          }};
}

/// Many pairs: Q as it is made, or moved away.
Row distance_row(const std::string& name, const std::string& what, const Rational& away,
                 const std::function<Summands(std::uint64_t seed)>& make) {
  const std::string place = sgn(away) > 0 ? "apart" : "overlapping";
  return {.name = "distances_" + name + "_" + place,
          .what = what + ", " + place,
          .subject = "distances",
          .pairs = distance_pairs,
          .kind = "distances",
          .engines = {"distance", "depth"},
          .make = [=] {
            std::vector<Summands> pairs;
            for (std::uint64_t seed = 1; seed <= distance_pairs; ++seed) {
              auto [p, q] = make(seed);
              const Rational by = away * (100 + seed % 50) / 100;
              pairs.push_back({std::move(p), translated(std::move(q), {by, by / 3})});
            }
            return pairs;
          }};
}

/// Of a nesting instance.
std::filesystem::path parts_file(const std::string& instance) {
  return data_folder() / "esicup" / (instance + ".wkt");
}

Summands two_parts(const std::string& instance, std::uint64_t seed) {
  const std::vector<Region> parts = read_region_lines(parts_file(instance));
  const std::size_t n = parts.size();
  return {parts[seed % n], parts[seed / n % n]};
}

/// All no-fit polygons of an instance: the sums of P and -Q.
Row nesting_row(const std::string& instance) {
  const std::vector<Region> parts = read_region_lines(parts_file(instance));
  std::size_t vertices = 0;
  for (const Region& part : parts) vertices += vertex_count(part);
  return {.name = "nesting_" + instance,
          .group = "nesting",
          .what = instance + ": " + std::to_string(parts.size()) + " parts, " +
                  std::to_string(vertices) + " vertices",
          .subject = "nesting",
          .pairs = parts.size() * parts.size(),
          .engines = {"slide", "oplus-nfp", "cgal-nfp", "cgal-nfp-newest", "clipper-nfp",
                      "clipper2-nfp"},
          .make =
              [parts] {
                std::vector<Summands> pairs;
                for (const Region& p : parts)
                  for (const Region& q : parts) pairs.push_back({p, reflected(q)});
                return pairs;
              },
          .parts = parts_file(instance)};
}

Rows distance_rows() {
  Rows rows;
  const auto add = [&](const std::string& name, const std::string& what, const Rational& away,
                       const auto& make) {
    rows.push_back(distance_row(name, what, away, make));
    rows.push_back(distance_row(name, what, 0, make));
  };
  for (const Kind& kind : {convex, simple, star})
    add(kind.name + "_50", "two " + kind.words + "s of 50 vertices", 3'000'000,
        [make = kind.make](std::uint64_t seed) {
          Random random(seed);
          Region p = make(random, 50);
          return Summands{std::move(p), make(random, 50)};
        });
  add("swim", "parts of swim, 11 to 53 vertices", 8000,
      [](std::uint64_t seed) { return two_parts("swim", seed); });
  for (Row row : {pair_of("", convex, 250, convex, 250), pair_of("", star, 300, star, 100),
                  pair_of("", coast, 1000, convex, 20)}) {
    row.name = "places_" + row.name;
    row.subject = row.kind = "places";
    row.engines = {"placements", "scan"};
    rows.push_back(std::move(row));
  }
  return rows;
}

/// The engines for a row.
std::vector<std::string> engines_for(const Row& row) {
  if (row.subject == "growth") return {"slide", "slide2"};
  if (row.pairs > 1 && row.subject == "commands") return {"slide", "oplus-batch", "cgal-reduced"};
  if (row.subject == "commands") return {"slide", "oplus-sum", "cgal-sum", "clipper-sum"};
  if (row.subject == "proved") return {"slide", "cgal-reduced", "cgal-full", "oplus-proved"};
  if (row.subject == "certificates")
    return {"slide", "oplus-sum", "sum-certificate", "oplus-certified", "cgal-sum"};
  std::vector<std::string> names;
  for (const BenchEngine& engine : bench_engines())
    if (engine.kind == "sums" && engine.is_of_all_rows) names.push_back(engine.name);
  return names;
}

}  // namespace

std::vector<Summands> published_pair(const std::string& p, const std::string& q) {
  Region first = read_region_file(data_folder() / (p + ".dat")).region;
  return {{std::move(first), read_region_file(data_folder() / (q + ".dat")).region}};
}

Rows benchmark_rows() {
  Rows made = published_rows();
  const auto add = [&](std::initializer_list<std::size_t> sizes, auto row_of) {
    for (const std::size_t n : sizes) made.push_back(row_of(n));
  };
  const auto add_pairs = [&](const std::string& group, std::initializer_list<std::size_t> sizes,
                             const Kind& p, const Kind& q) {
    add(sizes, [&](std::size_t n) { return pair_of(group, p, n, q, 100); });
  };
  add_pairs("stars", {10, 50, 100, 200, 300, 1000, 3000}, star, star);
  add_pairs("simple polygons", {10, 50, 100, 200, 500, 1000}, simple, simple);
  add_pairs("convex and star", {50, 200, 500, 980}, convex, star);
  add({10, 20, 50, 100}, fork_and_l_row);
  add({20, 100, 500, 2000, 10000}, comb_row);
  for (const std::size_t n : {1000, 5000}) {
    made.push_back(pair_of("coastlines", coast, n, convex, 20));
    made.push_back(pair_of("coastlines", coast, n, star, 100));
  }
  made.push_back(small_pairs_row());
  for (const auto& [family, n] :
       std::initializer_list<std::pair<const char*, std::size_t>>{{"outlier", 2000},
                                                                  {"scales", 100},
                                                                  {"fractions", 640},
                                                                  {"dots", 100},
                                                                  {"sieve", 2500},
                                                                  {"spiral", 20000},
                                                                  {"thin", 1000},
                                                                  {"pockets", 800},
                                                                  {"touching", 100}})
    made.push_back(hard_row(family, n));
  made.push_back(tall_comb_row(500));
  made.push_back(far_scales_row(200));
  for (const std::size_t n : {10'000, 100'000, 1'000'000})
    for (const Kind* const p : {&coast, &maze_kind})
      for (const std::size_t m : {4, 100}) {
        if (n * m > 10'000'000) continue;
        Row row = pair_of("growth of " + p->words, *p, n, convex, m);
        row.subject = "growth";
        made.push_back(std::move(row));
      }
  for (Row& row : std::vector<Row>{pair_of("", convex, 5000, square, 4), fork_and_l_row(100),
                                   pair_of("", coast, 5000, star, 100), small_pairs_row()})
    made.push_back(in_section("commands", "command", std::move(row)));
  for (Row& row :
       std::vector<Row>{pair_of("", star, 50, star, 50), pair_of("", star, 100, star, 100),
                        pair_of("", star, 200, star, 200), pair_of("", star, 300, star, 100),
                        pair_of("", star, 400, star, 400), pair_of("", simple, 200, simple, 100),
                        fork_and_l_row(10), fork_and_l_row(20), fork_and_l_row(50),
                        fork_and_l_row(100), pair_of("", coast, 1000, convex, 20),
                        pair_of("", coast, 5000, convex, 20), hard_row("spiral", 4000)})
    made.push_back(in_section("certificates", "certificate", std::move(row)));
  for (const std::size_t n : {30, 60, 100})
    made.push_back(in_section("proved", "proved", pair_of("", star, n, star, n)));
  for (Row& row : made) row.engines = engines_for(row);
  for (Row& row : distance_rows()) made.push_back(std::move(row));
  for (const char* const instance : {"albano", "blaz1", "dagli", "fu", "jakobs1", "mao", "marques",
                                     "shapes0", "shirts", "swim", "trousers"})
    made.push_back(nesting_row(instance));
  for (Row& row : made)
    std::erase_if(row.engines, [](const std::string& name) {
      return std::ranges::none_of(bench_engines(),
                                  [&](const BenchEngine& one) { return one.name == name; });
    });
  return made;
}

}  // namespace oplus
