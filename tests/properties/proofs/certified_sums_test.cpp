// SPDX-License-Identifier: GPL-3.0-or-later
// That oplus-certified certifies sums with the certificates that are made for them, and no damaged one: neither
// with the certificate of the right sum, nor with one that is made for what it was damaged to.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "checked/certificates/certificate.hpp"
#include "checked/slide/slide.hpp"
#include "properties/runner/child_process.hpp"
#include "properties/runner/temporary_folder.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/chains/validity.hpp"
#include "reference/families/family.hpp"
#include "reference/io/writing.hpp"
#include "tests/checked/verify/damage.hpp"
#include "tests/reference/definitions/shapes.hpp"

namespace oplus {
namespace {

class CertifiedSums : public testing::Test {
 protected:
  void put(const std::string& file, const std::string& text) const {
    std::ofstream(place_ / file, std::ios::binary) << text;
  }

  void put_summands(const Region& p, const Region& q) const {
    put("p.wkt", wkt(p));
    put("q.wkt", wkt(q));
  }

  /// What the program answers.
  std::string answer(const Region& s, const std::string& certificate) const {
    put("s.wkt", wkt(s));
    put("certificate", certificate);
    std::vector<std::string> command = {program_beside("oplus-certified")};
    for (const char* file : {"p.wkt", "q.wkt", "s.wkt", "certificate"})
      command.push_back((place_ / file).string());
    ProcessLimits limits;
    limits.is_quiet = true;
    const EndedProcess ended = run_program(command, limits);
    EXPECT_EQ(ended.how, EndedProcess::How::exited);
    EXPECT_EQ(ended.code == 0, ended.output == "certified\n") << ended.output;
    EXPECT_LE(ended.code, 2);
    return ended.code == 2 ? "invalid: " + ended.errors : ended.output;
  }

 private:
  const TemporaryFolder temporary_;
  const std::filesystem::path place_ = temporary_.path();
};

/// Whether a certificate made for it can be asked about: others than those would be found invalid before.
bool can_have_certificate(const Region& s) { return !find_defect(s).has_value(); }

TEST_F(CertifiedSums, damaged_ones_are_refused) {
  std::map<std::string, std::size_t> times;
  std::size_t damaged = 0, with_own_certificate = 0;
  for (const Family& family : families()) {
    for (const std::uint64_t seed : {1U, 2U}) {
      const auto [p, q] = generate(family, std::min(family.typical, family.smallest + 3), seed);
      put_summands(p, q);
      const PlanarSet sum = slide_sum(p, q, Boundary::closed).sum;
      const ClaimedSum whole{region_of(sum), {}, {}};
      const std::string certificate = written(certificates::certificate(p, q, whole.region));
      ASSERT_EQ(answer(whole.region, certificate), "certified\n") << family.name << ' ' << seed;
      for (const Damage& damage : damages()) {
        ClaimedSum given = whole;
        damage.apply(given, sum);
        // Chains are turned when they are read.
        if (given.region == whole.region ||
            damage.right_reasons.contains(ReasonKind::wrong_orientation))
          continue;
        SCOPED_TRACE(damage.name + ", " + family.name + ", seed " + std::to_string(seed));
        ++damaged;
        ++times[damage.name];
        EXPECT_NE(answer(given.region, certificate), "certified\n");
        if (!can_have_certificate(given.region)) continue;
        try {
          const std::string own = written(certificates::certificate(p, q, given.region));
          EXPECT_EQ(answer(given.region, own).substr(0, 13), "not certified");
          ++with_own_certificate;
        } catch (const certificates::PointOutsideSum&) {
        }
      }
    }
  }
  EXPECT_GT(damaged, 300U);
  EXPECT_GT(with_own_certificate, 50U);
  EXPECT_GE(times.size(), 15U);
  RecordProperty("damaged", static_cast<int>(damaged));
  RecordProperty("with_own_certificate", static_cast<int>(with_own_certificate));
}

/// Sizes that differ by more than all doubles do, and shapes that far from the origin.
TEST_F(CertifiedSums, of_sizes_beyond_doubles_are_certified) {
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
          put_summands(p, q);
          const Region s = region_of(slide_sum(p, q, Boundary::closed).sum);
          EXPECT_EQ(answer(s, written(certificates::certificate(p, q, s))), "certified\n")
              << i << ", placed " << &place_of_p - all << "; " << j << ", placed "
              << &place_of_q - all;
        }
      }
    }
  }
}

}  // namespace
}  // namespace oplus
