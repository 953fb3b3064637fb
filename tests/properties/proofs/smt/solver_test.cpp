// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/solver.hpp"

#include <gtest/gtest.h>

#include <system_error>

#include "properties/runner/temporary_folder.hpp"
#include "reference/io/writing.hpp"

namespace oplus::smt {
namespace {

/// The answer to a text; no test takes 100 s.
Answer answer_to(const Solver& solver, const std::string& text, double seconds = 100) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "question.smt2").string();
  write_file(file, text);
  return ask(solver, file, seconds);
}

const std::string reals =
    "(set-option :produce-models true)\n(set-logic QF_NRA)\n(declare-const x Real)\n";

TEST(ModelIn, ReadsWhatBothSolversPrint) {
  const auto model = model_in(
      "((a 0.0) (b (- 1.5))\n (c (/ 1.0 3.0)) (d (/ (- 1) 2)) (e (- (/ 1 2))) "
      "(f true) (g false) (h 7))\n");
  ASSERT_TRUE(model);
  EXPECT_EQ(model->numbers, (std::map<std::string, Rational>{{"a", 0},
                                                             {"b", Rational(-3, 2)},
                                                             {"c", Rational(1, 3)},
                                                             {"d", Rational(-1, 2)},
                                                             {"e", Rational(-1, 2)},
                                                             {"h", 7}}));
  EXPECT_EQ(model->flags, (std::map<std::string, bool>{{"f", true}, {"g", false}}));
}

TEST(ModelIn, IsEmptyWithoutRationalValues) {
  EXPECT_FALSE(model_in("((x (root-obj (+ (^ x 2) (- 2)) 1)))"));
  EXPECT_FALSE(model_in("((x (/ 1.0 0.0)))"));
  EXPECT_THROW(model_in("((x 1.0)"), std::invalid_argument);
  EXPECT_THROW(model_in("((x))"), std::invalid_argument);
  EXPECT_THROW(model_in(""), std::invalid_argument);
}

TEST(Solvers, AgreeOnEasyQuestions) {
  for (const Solver& solver : solvers()) {
    const Answer none = answer_to(solver, reals + "(assert (< (* x x) 0.0))\n(check-sat)\n");
    EXPECT_EQ(none.kind, Answer::Kind::unsatisfiable) << solver.name;
    const Answer one =
        answer_to(solver, reals + "(assert (= (* 3.0 x) (- 2.0)))\n(check-sat)\n(get-value (x))\n");
    EXPECT_EQ(one.kind, Answer::Kind::satisfiable) << solver.name;
    ASSERT_TRUE(one.model) << solver.name;
    EXPECT_EQ(one.model->numbers.at("x"), Rational(-2, 3)) << solver.name;
  }
}

/// Z3 only: cvc5 would search forever.
TEST(Solvers, GiveNoModelWithIrrationalNumbers) {
  const Answer root = answer_to(solvers().front(),
                                reals + "(assert (= (* x x) 2.0))\n(check-sat)\n(get-value (x))\n");
  EXPECT_EQ(root.kind, Answer::Kind::satisfiable);
  EXPECT_FALSE(root.model);
}

TEST(Solvers, MayGiveNoAnswer) {
  for (const Solver& solver : solvers()) {
    const Answer broken = answer_to(solver, "(assert (oops))\n(check-sat)\n");
    EXPECT_EQ(broken.kind, Answer::Kind::none) << solver.name;
    EXPECT_NE(broken.why_none, "") << solver.name;
  }
  const Solver slow{"slow", {"tail", "-f"}};
  const Answer late = answer_to(slow, "", 0.1);
  EXPECT_EQ(late.kind, Answer::Kind::none);
  EXPECT_EQ(late.why_none, "no answer in time");
  const Solver unsure{"unsure", {"cat"}};
  EXPECT_EQ(answer_to(unsure, "unknown\n").why_none, "unknown");
  EXPECT_THROW(answer_to({"missing", {"no-such-solver"}}, ""), std::system_error);
}

}  // namespace
}  // namespace oplus::smt
