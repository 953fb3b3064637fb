// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/term.hpp"

#include <gtest/gtest.h>

namespace oplus::smt {
namespace {

const Term x = Term::unknown("x"), y = Term::unknown("y");

TEST(Term, IsAPolynomialInOneForm) {
  EXPECT_EQ(((x + y) * (x - y)).to_smt(), (x * x - y * y).to_smt());
  EXPECT_EQ((x * y).to_smt(), (y * x).to_smt());
  EXPECT_EQ((x - x).to_smt(), "0.0");
  EXPECT_EQ((x * y * y + 1).degree(), 3U);
}

TEST(Term, KnowsItsValueOnlyWithoutUnknowns) {
  EXPECT_EQ((x - x + Rational(2, 3)).value(), Rational(2, 3));
  EXPECT_EQ(Term(0).value(), Rational(0));
  EXPECT_FALSE((x + 1).value());
}

TEST(Term, IsWrittenInSmtLib) {
  EXPECT_EQ(Term(Rational(-2, 3)).to_smt(), "(- (/ 2.0 3.0))");
  EXPECT_EQ((Term(Rational(1, 2)) * x * y - 3).to_smt(), "(+ (- 3.0) (* (/ 1.0 2.0) x y))");
}

TEST(Term, IsEvaluatedExactly) {
  EXPECT_EQ((x * x * y - Rational(1, 3)).at({{"x", Rational(1, 2)}, {"y", -4}}), Rational(-4, 3));
  EXPECT_THROW((x + y).at({{"x", 1}}), std::out_of_range);
}

TEST(Term, TheFactorToNormalFormMakesMultiplesEqual) {
  const Term a = Term(Rational(-2, 3)) * x + Rational(4, 9), b = Term(6) * x - 4;
  EXPECT_EQ((Term(a.factor_to_normal_form()) * a).to_smt(),
            (Term(b.factor_to_normal_form()) * b).to_smt());
  EXPECT_LT(sign(a.factor_to_normal_form()) * sign(b.factor_to_normal_form()), 0);
}

}  // namespace
}  // namespace oplus::smt
