// SPDX-License-Identifier: GPL-3.0-or-later
// That oplus-certified certifies sums and places with the certificates that are made for them, and no damaged one:
// neither with the certificate of the right set, nor with one that is made for what it was damaged to.
#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "checked/certificates/certificate.hpp"
#include "checked/certificates/layout_certificate.hpp"
#include "checked/operations/operations.hpp"
#include "checked/slide/by_slide.hpp"
#include "properties/compare/certified_engine.hpp"
#include "properties/compare/corpus.hpp"
#include "properties/runner/temporary_folder.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/validity.hpp"
#include "reference/families/family.hpp"
#include "reference/io/writing.hpp"
#include "tests/checked/verify/damage.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

const ProcessLimits limits{.is_quiet = true};

/// What the program answers of a set that should be what the claim says.
std::string answer(const std::string& claim, const Region& p, const Region& q, const ClaimedSum& s,
                   const std::string& certificate) {
  const EndedProcess ended = checked_certificate(claim, p, q, s, certificate, limits);
  EXPECT_EQ(ended.how, EndedProcess::How::exited);
  EXPECT_EQ(ended.code == 0, says_certified(ended)) << ended.output;
  EXPECT_LE(ended.code, 2);
  return ended.code == 2 ? "invalid: " + ended.errors : ended.output;
}

bool is_certified(const std::string& answer) { return answer.starts_with("certified: "); }

std::string answer(const Region& p, const Region& q, const Region& s,
                   const std::string& certificate) {
  return answer("sum", p, q, {s, {}, {}}, certificate);
}

/// Whether a certificate made for it can be asked about: others than those would be found invalid before.
bool can_have_certificate(const Region& s) { return !find_defect(s).has_value(); }

/// A set that is certified, and how its certificate is made.
struct Claimed {
  std::string claim;
  PlanarSet set;
  std::function<certificates::Certificate(const ClaimedSum& set)> certificate;
};

class DamagedSets : public testing::Test {
 protected:
  void expect_refused(const Region& p, const Region& q, const Claimed& claimed) {
    const auto& [claim, set, certificate] = claimed;
    SCOPED_TRACE(claim);
    const ClaimedSum whole = parts_of(set);
    const std::string right = written(certificate(whole));
    const std::string said = answer(claim, p, q, whole, right);
    ASSERT_TRUE(is_certified(said)) << said;
    for (const Damage& damage : damages_of(claimed)) {
      ClaimedSum given = whole;
      damage.apply(given, set);
      // Chains are turned when they are read.
      const bool is_same = claim == "sum" ? given.region == whole.region : given == whole;
      if (is_same || damage.right_reasons.contains(ReasonKind::wrong_orientation)) continue;
      SCOPED_TRACE(damage.name);
      ++damaged;
      ++times[damage.name];
      EXPECT_FALSE(is_certified(answer(claim, p, q, given, right)));
      if (!can_have_certificate(given.region)) continue;
      try {
        const std::string own = written(certificate(given));
        EXPECT_EQ(answer(claim, p, q, given, own).substr(0, 13), "not certified");
        ++with_own_certificate;
      } catch (const certificates::PointOutsideSum&) {
      }
    }
  }

  std::map<std::string, std::size_t> times;
  std::size_t damaged = 0, with_own_certificate = 0;

 private:
  static std::vector<Damage> damages_of(const Claimed& claimed) {
    std::vector<Damage> all;
    for (const Damage& damage : damages())
      // The others look for places beside chains.
      if (!claimed.set.outer.empty() || damage.name.ends_with("lost")) all.push_back(damage);
    // What is invented inside a closed set changes nothing.
    std::erase_if(all, [&](const Damage& damage) {
      return claimed.set.outer.empty()
                 ? damage.name == "a component lost"
                 : claimed.claim == "ifp" && damage.name.ends_with("invented");
    });
    const auto damage = [&](std::string name, auto apply) {
      all.push_back({std::move(name), {}, apply});
    };
    damage("a dangling edge moved", [](ClaimedSum& given, const PlanarSet&) {
      if (given.dangling_edges.empty()) return;
      for (Point* end : {&given.dangling_edges[0].source, &given.dangling_edges[0].target})
        end->x += Rational(1, 1000);
    });
    const Location beyond = claimed.claim == "ifp" ? Location::outside : Location::inside;
    damage("a dangling edge longer", [beyond](ClaimedSum& given, const PlanarSet&) {
      if (given.dangling_edges.empty()) return;
      auto& [source, target] = given.dangling_edges[0];
      const Point longer = target + Rational(1, 1000) * (target - source);
      // Elsewhere there is nothing that it could be wrong of.
      if (locate(longer, given.region) == beyond) target = longer;
    });
    damage("an isolated vertex beside an edge or another one",
           [beyond](ClaimedSum& given, const PlanarSet&) {
             if (given.dangling_edges.empty() && given.isolated_vertices.empty()) return;
             const Point& near = given.dangling_edges.empty() ? given.isolated_vertices.at(0)
                                                              : given.dangling_edges[0].source;
             const Point beside = near + Vector{Rational(1, 1000), Rational(1, 777)};
             if (locate(beside, given.region) == beyond) given.isolated_vertices.push_back(beside);
           });
    damage("an isolated vertex moved", [](ClaimedSum& given, const PlanarSet&) {
      if (!given.isolated_vertices.empty()) given.isolated_vertices[0].y += Rational(1, 1000000);
    });
    return all;
  }
};

bool has_edges_or_vertices(const PlanarSet& set) {
  return !set.dangling_edges.empty() || !set.isolated_vertices.empty();
}

TEST_F(DamagedSets, are_refused) {
  for (const Family& family : families()) {
    for (const std::uint64_t seed : {1U, 2U}) {
      SCOPED_TRACE(family.name + ", seed " + std::to_string(seed));
      const auto [p, q] = generate(family, std::min(family.typical, family.smallest + 3), seed);
      expect_refused(p, q, {"sum", by_slide(p, q, Boundary::closed), [&](const ClaimedSum& s) {
                              return certificates::certificate(p, q, s.region);
                            }});
      const PlanarSet open = by_slide(p, q, Boundary::open);
      if (has_edges_or_vertices(open) || seed == 1)
        expect_refused(p, q, {"open-sum", open, [&](const ClaimedSum& s) {
                                return certificates::open_certificate(p, q, s);
                              }});
    }
  }
  EXPECT_GT(damaged, 600U);
  EXPECT_GT(with_own_certificate, 100U);
  EXPECT_GE(times.size(), 15U);
  RecordProperty("damaged", static_cast<int>(damaged));
  RecordProperty("with_own_certificate", static_cast<int>(with_own_certificate));
}

/// Whose open sums and places have edges and vertices of their own.
TEST_F(DamagedSets, with_edges_and_vertices_are_refused) {
  for (const CorpusPair& row : corpus()) {
    const Region &p = row.p, &q = row.q;
    if (vertex_count(p) * vertex_count(q) > 150) continue;
    SCOPED_TRACE(row.name);
    if (has_edges_or_vertices(row.open))
      expect_refused(p, q, {"open-sum", row.open, [&](const ClaimedSum& s) {
                              return certificates::open_certificate(p, q, s);
                            }});
    if (const PlanarSet set = no_fit(p, q, by_slide); has_edges_or_vertices(set))
      expect_refused(p, q, {"nfp", set, [&](const ClaimedSum& s) {
                              return certificates::no_fit_certificate(p, q, s);
                            }});
    if (const PlanarSet set = inner_fit(p, q, by_slide); has_edges_or_vertices(set))
      expect_refused(p, q, {"ifp", set, [&](const ClaimedSum& s) {
                              return certificates::inner_fit_certificate(p, q, s, by_slide);
                            }});
  }
  for (const char* name :
       {"a dangling edge lost", "half of a dangling edge lost", "a dangling edge invented",
        "a dangling edge moved", "a dangling edge longer", "an isolated vertex lost",
        "an isolated vertex invented", "an isolated vertex moved",
        "an isolated vertex beside an edge or another one", "the other kind of boundary"})
    EXPECT_GT(times[name], 3U) << name;
}

/// What the program answers of a layout, with the certificate of this or another one.
std::string answer(const Region& container, const std::vector<Region>& parts,
                   const std::string& certificate) {
  const TemporaryFolder folder("layout");
  const auto file = [&](const char* name, const std::string& text) {
    const std::string path = folder.path() / name;
    write_file(path, text);
    return path;
  };
  std::string lines;
  for (const Region& part : parts) lines += wkt(part) + "\n";
  const EndedProcess ended =
      run_program({program_beside("oplus-certified"), "layout", file("container", wkt(container)),
                   file("parts", lines), file("certificate", certificate)},
                  limits);
  EXPECT_EQ(ended.code == 0, says_certified(ended)) << ended.output << ended.errors;
  return ended.code == 2 ? "invalid: " + ended.errors : ended.output;
}

/// Parts of all families, each beside the one before and touching its box, in a container that just holds them.
TEST(CertifiedLayouts, are_certified_and_wrong_ones_refused) {
  std::vector<Region> parts;
  Rational right = 0, height = 0;
  for (const Family& family : families()) {
    if (family.name == "scales" || family.name == "outlier") continue;  // much larger than others
    const Region part = generate(family, std::min(family.typical, family.smallest + 3), 1).p;
    std::optional<Point> low, high;
    for (const Chain& chain : chains(part))
      for (const Point& v : chain) {
        low = low ? Point{std::min(low->x, v.x), std::min(low->y, v.y)} : v;
        high = high ? Point{std::max(high->x, v.x), std::max(high->y, v.y)} : v;
      }
    parts.push_back(translated(part, {right - low->x, -low->y}));
    right += high->x - low->x;
    height = std::max<Rational>(height, high->y - low->y);
  }
  const Region container = polygon(box(0, 0, right, height));
  const auto certificate = [](const Region& in, const std::vector<Region>& all) {
    return certificates::layout_certificate(
        in.components.empty() ? std::nullopt : std::optional(in), all);
  };
  const std::string whole = certificate(container, parts);
  EXPECT_TRUE(is_certified(answer(container, parts, whole))) << answer(container, parts, whole);
  const std::string alone = certificate({}, parts);
  EXPECT_TRUE(is_certified(answer({}, parts, alone))) << answer({}, parts, alone);
  EXPECT_FALSE(is_certified(answer(container, parts, alone)));

  const Region lower = polygon(box(0, 0, right, height - Rational(1, 1000000)));
  EXPECT_FALSE(is_certified(answer(lower, parts, whole)));
  EXPECT_FALSE(is_certified(answer(lower, parts, certificate(lower, parts))));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::vector<Region> twice = parts;
    twice.push_back(parts[i]);
    EXPECT_FALSE(is_certified(answer(container, twice, certificate(container, twice)))) << i;
  }
  std::vector<Region> moved = parts;
  moved[0] = translated(moved[0], {-Rational(1, 1000000), 0});
  EXPECT_FALSE(is_certified(answer(container, moved, whole)));
  EXPECT_FALSE(is_certified(answer(container, moved, certificate(container, moved))));
  EXPECT_TRUE(is_certified(answer({}, moved, certificate({}, moved))));
}

/// Sizes that differ by more than all doubles do, and shapes that far from the origin.
TEST(CertifiedSums, of_sizes_beyond_doubles_are_certified) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, 330);
  const Rational large(power), small = 1 / large;
  struct Placed {
    Rational scale, shift;
  };
  const Placed all[] = {{1, 0}, {large, 0}, {small, 0}, {1, large}, {small, 1}};
  const std::vector<Region> few = {polygon({{0, 0}, {1, 0}, {0, 1}}),
                                   polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}),
                                   polygon({{-3, -2}, {-1, -2}, {-1, 0}, {-2, -1}, {-3, 1}}),
                                   holed(box(0, 0, 4, 4), {box(1, 1, 3, 3)})};
  const auto at = [](const Region& region, const Placed& to) {
    return mapped(region, [&](const Point& v) {
      return Point{to.scale * v.x + to.shift, to.scale * v.y};
    });
  };
  for (const Placed& place_of_p : all) {
    for (const Placed& place_of_q : all) {
      for (std::size_t i = 0; i < few.size(); ++i) {
        for (std::size_t j = 0; j < few.size(); ++j) {
          const Region p = at(few[i], place_of_p), q = at(few[j], place_of_q);
          const Region s = region_of(by_slide(p, q, Boundary::closed));
          EXPECT_TRUE(is_certified(answer(p, q, s, written(certificates::certificate(p, q, s)))))
              << i << ", placed " << &place_of_p - all << "; " << j << ", placed "
              << &place_of_q - all;
        }
      }
    }
  }
}

}  // namespace
}  // namespace oplus
