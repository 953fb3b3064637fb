// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/formula.hpp"

#include <gtest/gtest.h>

namespace oplus::smt {
namespace {

const Formula positive = Formula::sign_of(Term::unknown("x"), {.positive = true});
const Formula flag = Formula::flag("f");

TEST(Formula, IsSimplifiedWhereAPartIsKnown) {
  EXPECT_EQ(all_of({true, positive}).to_smt(), positive.to_smt());
  EXPECT_EQ(all_of({false, positive}).value(), false);
  EXPECT_EQ(any_of({true, positive}).value(), true);
  EXPECT_EQ(all_of({}).value(), true);
  EXPECT_EQ(any_of({}).value(), false);
  EXPECT_EQ(negation(false).value(), true);
  EXPECT_EQ(if_then_else(true, flag, positive).to_smt(), "f");
  EXPECT_EQ(if_then_else(flag, true, true).value(), true);
  EXPECT_EQ(Formula::sign_of(3, {.positive = true}).value(), true);
}

TEST(Formula, IsWrittenInSmtLib) {
  const Term x = Term::unknown("x");
  EXPECT_EQ(Formula::sign_of(x, {.negative = true}).to_smt(), "(< x 0.0)");
  EXPECT_EQ(Formula::sign_of(x, {.negative = true, .zero = true}).to_smt(), "(<= x 0.0)");
  EXPECT_EQ(Formula::sign_of(x, {.zero = true}).to_smt(), "(= x 0.0)");
  EXPECT_EQ(Formula::sign_of(x, {.zero = true, .positive = true}).to_smt(), "(>= x 0.0)");
  EXPECT_EQ(Formula::sign_of(x, {.negative = true, .positive = true}).to_smt(), "(not (= x 0.0))");
  EXPECT_EQ(if_then_else(flag, positive, negation(positive)).to_smt(),
            "(ite f (> x 0.0) (not (> x 0.0)))");
}

TEST(Formula, SimplifiedOrNotItHoldsInTheSameModels) {
  for (const int x : {-1, 0, 1}) {
    for (const bool f : {false, true}) {
      const Model model{{{"x", x}}, {{"f", f}}};
      EXPECT_EQ(all_of({flag, positive}).holds_in(model), f && x > 0);
      EXPECT_EQ(any_of({flag, positive}).holds_in(model), f || x > 0);
      EXPECT_EQ(same(flag, positive).holds_in(model), f == (x > 0));
      EXPECT_EQ(if_then_else(flag, true, positive).holds_in(model), f || x > 0);
      EXPECT_EQ(if_then_else(flag, false, positive).holds_in(model), !f && x > 0);
      EXPECT_EQ(if_then_else(flag, positive, true).holds_in(model), !f || x > 0);
      EXPECT_EQ(if_then_else(flag, positive, false).holds_in(model), f && x > 0);
    }
  }
}

}  // namespace
}  // namespace oplus::smt
