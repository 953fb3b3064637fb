// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/pair_of_bytes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>

#include "reference/chains/validity.hpp"

namespace oplus {

namespace {

/// Around the limits of slide's stages of numbers.
constexpr std::array magnitudes{0U,  8U,  28U, 29U, 30U,  31U,  32U,  53U,  61U,  62U,
                                63U, 64U, 65U, 92U, 123U, 124U, 125U, 126U, 128U, 256U};
/// 1/4 and 1/9 make a summand large beside the other one, the last so large that doubles see that as a point.
constexpr std::array denominators{
    "1",
    "2",
    "3",
    "1/4",
    "1/9",
    "7",
    "10",
    "1000003",
    "2147483647",
    "2305843009213693951",
    "3298534883328",
    "1/1000000000000000000000000000000000000000000000000000000000000000000000000000000000000"};
constexpr std::array offsets{"0",
                             "1048577",
                             "-268435456",
                             "536870912",
                             "1152921504606846977",
                             "-10633823966279326983230456482242756608",
                             "21267647932558653966460912964485513216",
                             "1/3",
                             "1267650600228229401496703205376/7"};

/// The n of few pairs: most have few vertices, which is fast and shows most faults.
constexpr std::size_t large = 24;
constexpr std::size_t most_pairs_of_edges = 2500;

constexpr unsigned spelled_out = 255, of_a_hole = 128;

/// Bytes one after another, zeros after the last.
class Bytes {
 public:
  explicit Bytes(std::string_view rest) : rest_(rest) {}

  unsigned take() {
    if (rest_.empty()) return 0;
    const auto byte = static_cast<std::uint8_t>(rest_.front());
    rest_.remove_prefix(1);
    return byte;
  }

  /// One of a table, half of the time the first: few pairs need all extremes at once.
  template <typename Table>
  auto one_of(const Table& table) {
    const std::size_t place = take() % (2 * table.size());
    return table.at(place < table.size() ? place : 0);
  }

 private:
  std::string_view rest_;
};

/// What is done with the coordinates of a summand.
struct Numbers {
  explicit Numbers(Bytes& bytes)
      : denominator(bytes.one_of(denominators)),
        offset(bytes.one_of(offsets)),
        jitter(bytes.take()) {}

  Rational denominator, offset;
  unsigned jitter;  ///< the seed of what places are moved by; none in half of the cases
};

/// Outer chains counterclockwise, holes clockwise.
void orient(Region& region) {
  const auto turn = [](Chain& chain, int wanted) {
    if (sign(twice_area(chain)) == -wanted) std::reverse(chain.begin(), chain.end());
  };
  for (Component& component : region.components) {
    turn(component.outer, 1);
    for (Chain& hole : component.holes) turn(hole, -1);
  }
}

Region spelled(Bytes& bytes) {
  Region region;
  for (unsigned head = bytes.take(); head != 0; head = bytes.take()) {
    Chain chain;
    for (unsigned n = head % of_a_hole; n > 0; --n) {
      const auto x = static_cast<std::int8_t>(bytes.take());
      chain.push_back({int{x}, int{static_cast<std::int8_t>(bytes.take())}});
    }
    if (head < of_a_hole)
      region.components.push_back({std::move(chain), {}});
    else if (!region.components.empty())
      region.components.back().holes.push_back(std::move(chain));
  }
  orient(region);
  return region;
}

/// The second is empty where the first is spelled out.
Summands drawn(Bytes& bytes) {
  const unsigned which = bytes.take();
  if (which == spelled_out) return {spelled(bytes), {}};
  const Family& family = families().at(which % families().size());
  const unsigned size = bytes.take();
  const std::size_t n =
      size >= 224 ? large : family.smallest + size % (family.typical - family.smallest + 1);
  const unsigned high = bytes.take();
  Summands pair = generate(family, n, 256 * high + bytes.take());
  if (which >= 128) std::swap(pair.p, pair.q);
  return pair;
}

mpz_class scale_for(const Summands& pair, unsigned bits) {
  mpz_class largest = 1;
  for (const Region* region : {&pair.p, &pair.q})
    for (const Chain& chain : chains(*region))
      for (const Point& v : chain)
        for (const Rational* x : {&v.x, &v.y}) largest = std::max(largest, mpz_class(abs(*x)));
  const std::size_t has = mpz_sizeinbase(largest.get_mpz_t(), 2);
  return mpz_class(1) << (bits > has ? bits - has : 0);
}

Region moved_a_little(const Region& region, unsigned seed) {
  Random random(seed);
  std::map<Point, Vector> by;
  return mapped(region, [&](const Point& p) {
    const auto [known, is_new] = by.try_emplace(p, Vector{0, 0});
    if (is_new && one_in(random, 3)) {
      const int x = uniform(random, -8, 7);
      known->second = {x, uniform(random, -8, 7)};
    }
    return p + known->second;
  });
}

Region in_numbers(Region region, const Numbers& numbers, const mpz_class& scale, bool is_sheared) {
  region = mapped(std::move(region), [&](const Point& p) {
    return Point{scale * p.x, scale * p.y};
  });
  if (numbers.jitter >= 128) {
    Region moved = moved_a_little(region, numbers.jitter);
    orient(moved);
    if (!find_defect(moved)) region = std::move(moved);
  }
  return mapped(std::move(region), [&](const Point& p) {
    // Of determinant one: as bijective as the identity.
    const Point q = is_sheared ? Point{p.x + 3 * p.y, 5 * p.x + 16 * p.y} : p;
    return Point{q.x / numbers.denominator + numbers.offset,
                 q.y / numbers.denominator - numbers.offset};
  });
}

void append(std::string& bytes, unsigned byte) { bytes += static_cast<char>(byte); }

bool append(std::string& bytes, const Region& region) {
  append(bytes, spelled_out);
  for (const Chain& chain : chains(region)) {
    if (chain.size() >= of_a_hole) return false;
    append(bytes,
           static_cast<unsigned>(chain.size()) + (sign(twice_area(chain)) < 0 ? of_a_hole : 0));
    for (const Point& v : chain)
      for (const Rational* x : {&v.x, &v.y}) {
        using Limits = std::numeric_limits<std::int8_t>;
        if (x->get_den() != 1 || *x < Limits::min() || *x > Limits::max()) return false;
        append(bytes, static_cast<std::uint8_t>(x->get_num().get_si()));
      }
  }
  append(bytes, 0);
  return true;
}

}  // namespace

std::optional<Summands> pair_of_bytes(std::string_view text) {
  Bytes bytes(text);
  const bool is_sheared = bytes.take() % 8 == 7;
  const unsigned bits = bytes.one_of(magnitudes);
  const Numbers of_p(bytes), of_q(bytes);
  Summands pair = drawn(bytes);
  if (const unsigned how = bytes.take() % 8; how == 1)
    pair.q = pair.p;
  else if (how == 2)
    pair.q = reflected(pair.p);
  else if (how == 3 || how == 4 || pair.q.components.empty())
    pair.q = drawn(bytes).p;
  for (const Region* region : {&pair.p, &pair.q})
    if (region->components.empty() || find_defect(*region)) return std::nullopt;
  if (vertex_count(pair.p) * vertex_count(pair.q) > most_pairs_of_edges) return std::nullopt;
  const mpz_class scale = scale_for(pair, bits);
  return Summands{in_numbers(std::move(pair.p), of_p, scale, is_sheared),
                  in_numbers(std::move(pair.q), of_q, scale, is_sheared)};
}

std::optional<std::string> bytes_of_pair(const Summands& summands) {
  if (summands.p.components.empty() || summands.q.components.empty()) return std::nullopt;
  std::string bytes(8, '\0');
  if (!append(bytes, summands.p)) return std::nullopt;
  append(bytes, 0);
  if (!append(bytes, summands.q)) return std::nullopt;
  return bytes;
}

}  // namespace oplus
