// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/definitions/contract.hpp"

#include <gtest/gtest.h>

#include "reference/chains/region_of.hpp"
#include "reference/definitions/direction.hpp"
#include "reference/definitions/planar_set.hpp"

namespace oplus {
namespace {

#ifdef OPLUS_CONTRACTS

TEST(Contract, broken_names_its_statement_and_condition) {
  try {
    OPLUS_REQUIRES(1 + 1 == 3, "Lemma 0.0");
    FAIL() << "not thrown";
  } catch (const ContractViolation& violation) {
    EXPECT_NE(std::string(violation.what()).find("precondition (Lemma 0.0) broken: 1 + 1 == 3"),
              std::string::npos)
        << violation.what();
  }
  EXPECT_THROW(OPLUS_ENSURES(false, "Lemma 0.0"), ContractViolation);
}

TEST(Contract, kept_does_nothing) {
  EXPECT_NO_THROW(OPLUS_REQUIRES(true, "Lemma 0.0"));
  EXPECT_NO_THROW(OPLUS_ENSURES(true, "Lemma 0.0"));
}

TEST(Contract, a_direction_is_not_zero) {
  EXPECT_THROW(compare_angle({0, 0}, {1, 0}), ContractViolation);
  EXPECT_THROW(compare_angle({1, 0}, {0, 0}), ContractViolation);
}

TEST(Contract, a_boundary_is_closed) {
  EXPECT_THROW(canonical_sum(BoundaryFeatures{{{{0, 0}, {1, 0}}}, {}, {}}), ContractViolation);
  // Edges leave the end, but they lead back to another start.
  EXPECT_THROW(canonical_sum(BoundaryFeatures{
                   {{{0, 0}, {1, 0}}, {{1, 0}, {1, 1}}, {{1, 1}, {1, 0}}}, {}, {}}),
               ContractViolation);
}

TEST(Contract, a_hole_has_an_outer_chain_around_it) {
  const PlanarSet hole_alone{{}, {{{0, 0}, {0, 1}, {1, 0}}}, {}, {}};
  EXPECT_THROW(region_of(hole_alone), ContractViolation);
}

#else

TEST(Contract, is_not_evaluated_without_contracts) {
  bool evaluated = false;
  OPLUS_REQUIRES((evaluated = true), "Lemma 0.0");
  OPLUS_ENSURES((evaluated = true), "Lemma 0.0");
  EXPECT_FALSE(evaluated);
}

#endif

}  // namespace
}  // namespace oplus
