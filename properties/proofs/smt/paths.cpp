// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/paths.hpp"

#include <stdexcept>

namespace oplus::smt {

namespace {

/// One path through the code.
class Path {
 public:
  /// Gives these answers first, and records its own after them.
  explicit Path(std::vector<bool>& answers) : answers_(answers) {}

  const std::vector<Formula>& questions() const { return questions_; }

  bool ask(const Term& term, const Signs& signs) {
    const Rational factor = term.factor_to_normal_form();
    const Term normal = Term(factor) * term;
    const Signs asked = oplus::sign(factor) < 0 ? signs.mirrored() : signs;
    Signs& possible = signs_.try_emplace(normal, Signs{true, true, true}).first->second;
    const Signs yes = possible & asked, no = without(possible, asked);
    if (yes.none()) return false;
    if (no.none()) return true;
    const bool answer = next(Formula::sign_of(normal, yes));
    possible = answer ? yes : no;
    return answer;
  }

  bool ask(const std::string& flag) {
    const auto known = flags_.find(flag);
    if (known != flags_.end()) return known->second;
    return flags_[flag] = next(Formula::flag(flag));
  }

 private:
  /// After the given answers, "yes".
  bool next(const Formula& question) {
    const bool answer = questions_.size() == answers_.size() || answers_[questions_.size()];
    if (questions_.size() == answers_.size()) answers_.push_back(true);
    questions_.push_back(question);
    return answer;
  }

  std::vector<bool>& answers_;
  std::vector<Formula> questions_;
  std::map<Term, Signs, Term::InOrder> signs_;
  std::map<std::string, bool> flags_;
};

thread_local Path* walked = nullptr;

/// Sets the current path during its lifetime.
class Walk {
 public:
  explicit Walk(Path& path) { walked = &path; }
  Walk(const Walk&) = delete;
  Walk& operator=(const Walk&) = delete;
  ~Walk() { walked = nullptr; }
};

/// All paths that start with the given answers: one path, and for each of its questions the paths
/// with the other answer.
Formula explored(const std::function<bool()>& code, const std::vector<bool>& given) {
  std::vector<bool> answers = given;
  Path path(answers);
  Formula result = [&] {
    const Walk walk(path);
    return Formula(code());
  }();
  for (std::size_t i = answers.size(); i > given.size(); --i) {
    std::vector<bool> others(answers.begin(), answers.begin() + static_cast<std::ptrdiff_t>(i));
    others.back() = false;
    result = if_then_else(path.questions()[i - 1], result, explored(code, others));
  }
  return result;
}

Path& path() {
  if (walked == nullptr) throw std::logic_error("unknowns are compared outside of executed()");
  return *walked;
}

}  // namespace

Formula executed(const std::function<bool()>& code) {
  if (walked != nullptr) throw std::logic_error("executed() inside executed()");
  return explored(code, {});
}

bool is_among(const Term& term, const Signs& signs) {
  if (const auto value = term.value()) return signs.has(oplus::sign(*value));
  return path().ask(term, signs);
}

bool is_set(const std::string& flag) { return path().ask(flag); }

}  // namespace oplus::smt
