// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/solver.hpp"

#include <algorithm>
#include <stdexcept>

#include "properties/runner/child_process.hpp"

namespace oplus::smt {

namespace {

/// (a b ...), or a word.
struct Expression {
  std::string word;
  std::vector<Expression> parts;
};

/// Of SMT-LIB 2.6 what solvers print as values.
class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}

  Expression expression() {
    skip_space();
    if (at_ == text_.size()) throw std::invalid_argument("a value ends early");
    if (text_[at_] != '(') return {word(), {}};
    ++at_;
    Expression list;
    for (skip_space(); at_ < text_.size() && text_[at_] != ')'; skip_space())
      list.parts.push_back(expression());
    if (at_++ == text_.size()) throw std::invalid_argument("a list of values ends early");
    return list;
  }

 private:
  static constexpr const char* space = " \t\r\n";

  void skip_space() { at_ = std::min(text_.find_first_not_of(space, at_), text_.size()); }

  std::string word() {
    const std::size_t from = at_;
    at_ = std::min(text_.find_first_of(" \t\r\n()", at_), text_.size());
    if (at_ == from) throw std::invalid_argument("a value is missing");
    return text_.substr(from, at_ - from);
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

std::optional<Rational> rational(const Expression& e) {
  if (e.parts.empty()) {
    const std::size_t point = e.word.find('.');
    const std::string whole = e.word.substr(0, point);
    const std::string rest = point == std::string::npos ? "" : e.word.substr(point + 1);
    if ((whole + rest).find_first_not_of("0123456789") != std::string::npos || whole.empty())
      return std::nullopt;
    Rational value(mpz_class(whole + rest, 10), mpz_class("1" + std::string(rest.size(), '0'), 10));
    value.canonicalize();
    return value;
  }
  const std::string& what = e.parts.front().word;
  std::vector<Rational> values;
  for (std::size_t i = 1; i < e.parts.size(); ++i) {
    const auto value = rational(e.parts[i]);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  if (what == "-" && values.size() == 1) return Rational(-values[0]);
  if (what == "/" && values.size() == 2 && sign(values[1]) != 0)
    return Rational(values[0] / values[1]);
  return std::nullopt;
}

std::vector<std::string> with(const Solver& solver, const std::string& argument) {
  std::vector<std::string> command = solver.command;
  command.push_back(argument);
  return command;
}

constexpr std::size_t most_mb = 2000;  // of memory

}  // namespace

const std::vector<Solver>& solvers() {
  static const std::vector<Solver> all = {
      {"z3", {"z3"}},
      // Products are bounded by tangent planes: it has no decision procedure for them in Debian 12.
      {"cvc5", {"cvc5", "--nl-ext-tplanes"}},
  };
  return all;
}

std::string version_of(const Solver& solver) {
  const EndedProcess ended =
      run_program(with(solver, "--version"), {.seconds = 60, .is_quiet = true});
  return ended.output.substr(0, ended.output.find('\n'));
}

std::string to_string(Answer::Kind kind) {
  switch (kind) {
    case Answer::Kind::satisfiable:
      return "sat";
    case Answer::Kind::unsatisfiable:
      return "unsat";
    case Answer::Kind::none:
      break;
  }
  return "none";
}

Answer ask(const Solver& solver, const std::string& file, double seconds) {
  const EndedProcess ended = run_program(
      with(solver, file), {.seconds = seconds, .address_space_mb = most_mb, .is_quiet = true});
  Answer answer;
  if (ended.how == EndedProcess::How::over_time) {
    answer.why_none = "no answer in time";
    return answer;
  }
  const std::size_t line = ended.output.find('\n');
  const std::string said = ended.output.substr(0, line);
  if (said == "unsat") {
    answer.kind = Answer::Kind::unsatisfiable;
  } else if (said == "sat") {
    answer.kind = Answer::Kind::satisfiable;
    if (ended.output.size() > line + 1) answer.model = model_in(ended.output.substr(line + 1));
  } else {
    answer.why_none = said.empty() ? ended.errors : said;
  }
  return answer;
}

std::optional<Model> model_in(const std::string& text) {
  Model model;
  for (const Expression& pair : Reader(text).expression().parts) {
    if (pair.parts.size() != 2) throw std::invalid_argument("a value has no name");
    const std::string& name = pair.parts[0].word;
    const Expression& value = pair.parts[1];
    if (value.word == "true" || value.word == "false") {
      model.flags[name] = value.word == "true";
    } else {
      const auto number = rational(value);
      if (!number) return std::nullopt;
      model.numbers[name] = *number;
    }
  }
  return model;
}

}  // namespace oplus::smt
