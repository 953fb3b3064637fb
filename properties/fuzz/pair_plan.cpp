// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/pair_plan.hpp"

#include <algorithm>
#include <limits>

namespace oplus {

namespace {

constexpr int lowest_jitter = -8;

/// Bytes one after another, zeros after the last.
class Bytes {
 public:
  explicit Bytes(std::string_view rest) : rest_(rest) {}

  bool is_at_end() const { return rest_.empty(); }

  std::uint8_t take() {
    if (rest_.empty()) return 0;
    const auto byte = static_cast<std::uint8_t>(rest_.front());
    rest_.remove_prefix(1);
    return byte;
  }

 private:
  std::string_view rest_;
};

std::uint8_t below(std::size_t bound, std::uint8_t byte) {
  return static_cast<std::uint8_t>(byte % bound);
}

PlannedVertex vertex(Bytes& bytes) {
  PlannedVertex v;
  v.x = static_cast<std::int8_t>(bytes.take());
  v.y = static_cast<std::int8_t>(bytes.take());
  // So that no jitter at all is the byte 0.
  const std::uint8_t jitters = bytes.take() ^ 0x88;
  v.jitter_x = static_cast<std::int8_t>((jitters >> 4) + lowest_jitter);
  v.jitter_y = static_cast<std::int8_t>((jitters & 15) + lowest_jitter);
  return v;
}

PlannedSummand summand(Bytes& bytes) {
  PlannedSummand result;
  result.denominator = below(denominators().size(), bytes.take());
  result.offset = below(offsets().size(), bytes.take());
  std::size_t room = most_vertices_in_all;
  for (std::size_t wanted = bytes.take() % (most_chains + 1); wanted > 0 && room >= 3; --wanted) {
    const std::uint8_t head = bytes.take();
    PlannedChain chain;
    chain.is_hole = head >= 128;
    for (std::size_t n = head % (most_vertices + 1); n > 0 && !bytes.is_at_end(); --n) {
      const PlannedVertex v = vertex(bytes);
      if (chain.vertices.size() < room) chain.vertices.push_back(v);
    }
    if (chain.vertices.size() < 3) continue;
    room -= chain.vertices.size();
    result.chains.push_back(std::move(chain));
  }
  return result;
}

void append(std::string& bytes, unsigned byte) { bytes += static_cast<char>(byte); }

void append(std::string& bytes, const PlannedSummand& summand) {
  append(bytes, summand.denominator);
  append(bytes, summand.offset);
  append(bytes, static_cast<unsigned>(summand.chains.size()));
  for (const PlannedChain& chain : summand.chains) {
    // The smallest multiple from 128 on of what the length is taken modulo of.
    constexpr std::size_t hole = (128 / (most_vertices + 1) + 1) * (most_vertices + 1);
    append(bytes, static_cast<unsigned>(chain.vertices.size() + (chain.is_hole ? hole : 0)));
    for (const PlannedVertex& v : chain.vertices) {
      append(bytes, static_cast<std::uint8_t>(v.x));
      append(bytes, static_cast<std::uint8_t>(v.y));
      const auto jitters =
          static_cast<unsigned>((v.jitter_x - lowest_jitter) << 4 | (v.jitter_y - lowest_jitter));
      append(bytes, jitters ^ 0x88);
    }
  }
}

std::optional<std::int8_t> small(const Rational& value) {
  using Limits = std::numeric_limits<std::int8_t>;
  if (value.get_den() != 1 || value < Limits::min() || value > Limits::max()) return std::nullopt;
  return static_cast<std::int8_t>(value.get_num().get_si());
}

std::optional<PlannedSummand> plan_of(const Region& region) {
  const std::vector<Chain> all = chains(region);
  if (all.empty() || all.size() > most_chains || vertex_count(region) > most_vertices_in_all)
    return std::nullopt;
  PlannedSummand result;
  for (const Chain& chain : all) {
    if (chain.size() > most_vertices) return std::nullopt;
    PlannedChain planned{sign(twice_area(chain)) < 0, {}};
    for (const Point& v : chain) {
      const auto x = small(v.x), y = small(v.y);
      if (!x || !y) return std::nullopt;
      planned.vertices.push_back({*x, *y});
    }
    result.chains.push_back(std::move(planned));
  }
  return result;
}

}  // namespace

const std::vector<Rational>& denominators() {
  static const std::vector<Rational> all{1,
                                         2,
                                         3,
                                         7,
                                         10,
                                         1000003,
                                         Rational("2147483647"),
                                         Rational("2305843009213693951"),
                                         Rational("3298534883328")};
  return all;
}

const std::vector<Rational>& offsets() {
  static const std::vector<Rational> all{0,
                                         1048577,
                                         Rational("-268435456"),
                                         Rational("536870912"),
                                         Rational("1152921504606846977"),
                                         Rational("-10633823966279326983230456482242756608"),
                                         Rational("21267647932558653966460912964485513216"),
                                         Rational(1, 3),
                                         Rational("1267650600228229401496703205376/7")};
  return all;
}

PairPlan decoded(std::string_view bytes) {
  Bytes rest(bytes);
  PairPlan plan;
  const std::uint8_t head = rest.take();
  plan.magnitude = below(magnitudes.size(), head & 127);
  plan.is_sheared = head >= 128;
  plan.p = summand(rest);
  plan.q = summand(rest);
  return plan;
}

std::string encoded(const PairPlan& plan) {
  std::string bytes;
  append(bytes, plan.magnitude + (plan.is_sheared ? 128U : 0U));
  append(bytes, plan.p);
  append(bytes, plan.q);
  return bytes;
}

std::optional<PairPlan> plan_of(const Summands& summands) {
  auto p = plan_of(summands.p), q = plan_of(summands.q);
  if (!p || !q) return std::nullopt;
  PairPlan plan;
  plan.p = std::move(*p);
  plan.q = std::move(*q);
  return plan;
}

}  // namespace oplus
