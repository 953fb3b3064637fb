// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/smt/paths.hpp"

#include <stdexcept>
#include <variant>

namespace oplus::smt {

namespace {

/// The question that comes after those with an answer.
struct Unanswered {
  Formula question;
};

/// One way through the code.
class Path {
 public:
  explicit Path(const std::vector<bool>& answers) : answers_(answers) {}

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
  bool next(const Formula& question) {
    if (at_ == answers_.size()) throw Unanswered{question};
    return answers_[at_++];
  }

  const std::vector<bool>& answers_;
  std::size_t at_ = 0;
  std::map<Term, Signs, Term::InOrder> signs_;
  std::map<std::string, bool> flags_;
};

thread_local Path* walked = nullptr;

std::variant<bool, Unanswered> walk(const std::function<bool()>& code,
                                    const std::vector<bool>& answers) {
  Path path(answers);
  walked = &path;
  try {
    const bool answer = code();
    walked = nullptr;
    return answer;
  } catch (const Unanswered& question) {
    walked = nullptr;
    return question;
  } catch (...) {
    walked = nullptr;
    throw;
  }
}

Formula explored(const std::function<bool()>& code, std::vector<bool>& answers) {
  const std::variant<bool, Unanswered> end = walk(code, answers);
  if (const bool* answer = std::get_if<bool>(&end)) return *answer;
  answers.push_back(true);
  const Formula then = explored(code, answers);
  answers.back() = false;
  const Formula otherwise = explored(code, answers);
  answers.pop_back();
  return if_then_else(std::get<Unanswered>(end).question, then, otherwise);
}

Path& path() {
  if (walked == nullptr) throw std::logic_error("unknowns are compared outside of executed()");
  return *walked;
}

}  // namespace

Formula executed(const std::function<bool()>& code) {
  if (walked != nullptr) throw std::logic_error("executed() inside executed()");
  std::vector<bool> answers;
  return explored(code, answers);
}

bool is_among(const Term& term, const Signs& signs) {
  if (const auto value = term.value()) return signs.has(oplus::sign(*value));
  return path().ask(term, signs);
}

bool is_set(const std::string& flag) { return path().ask(flag); }

}  // namespace oplus::smt
