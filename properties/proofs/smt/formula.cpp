// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/proofs/smt/formula.hpp"

#include <algorithm>
#include <utility>

namespace oplus::smt {

struct Formula::Node {
  enum class Kind { known, sign, flag, join };
  Kind kind = Kind::known;
  bool known = false;
  Term term = {};
  Signs signs = {};
  std::string word = {};  ///< the flag, or the operator that joins the parts
  std::vector<Formula> parts = {};
};

namespace {

std::string compared(const std::string& relation, const Term& term) {
  return "(" + relation + " " + term.to_smt() + " 0.0)";
}

}  // namespace

Formula::Formula(std::shared_ptr<const Node> node) : node_(std::move(node)) {}

Formula::Formula(bool value)
    : node_(std::make_shared<const Node>(Node{.kind = Node::Kind::known, .known = value})) {}

Formula Formula::sign_of(const Term& term, const Signs& signs) {
  if (const auto value = term.value()) return signs.has(sign(*value));
  return Formula(
      std::make_shared<const Node>(Node{.kind = Node::Kind::sign, .term = term, .signs = signs}));
}

Formula Formula::flag(const std::string& name) {
  return Formula(std::make_shared<const Node>(Node{.kind = Node::Kind::flag, .word = name}));
}

Formula Formula::join(const std::string& word, const std::vector<Formula>& parts) {
  return Formula(
      std::make_shared<const Node>(Node{.kind = Node::Kind::join, .word = word, .parts = parts}));
}

std::optional<bool> Formula::value() const {
  if (node_->kind != Node::Kind::known) return std::nullopt;
  return node_->known;
}

bool Formula::holds_in(const Model& model) const {
  const std::vector<Formula>& parts = node_->parts;
  const auto holds = [&](const Formula& part) { return part.holds_in(model); };
  switch (node_->kind) {
    case Node::Kind::known:
      return node_->known;
    case Node::Kind::flag:
      return model.flags.at(node_->word);
    case Node::Kind::sign:
      return node_->signs.has(sign(node_->term.at(model.numbers)));
    case Node::Kind::join:
      break;
  }
  if (node_->word == "and") return std::all_of(parts.begin(), parts.end(), holds);
  if (node_->word == "or") return std::any_of(parts.begin(), parts.end(), holds);
  if (node_->word == "not") return !holds(parts[0]);
  return holds(parts[0]) ? holds(parts[1]) : holds(parts[2]);
}

void Formula::add_names_to(Names& names) const {
  if (node_->kind == Node::Kind::sign) node_->term.add_names_to(names.numbers);
  if (node_->kind == Node::Kind::flag) names.flags.insert(node_->word);
  for (const Formula& part : node_->parts) part.add_names_to(names);
}

std::size_t Formula::degree() const {
  std::size_t most = node_->term.degree();
  for (const Formula& part : node_->parts) most = std::max(most, part.degree());
  return most;
}

std::string Formula::to_smt() const {
  const Signs& s = node_->signs;
  switch (node_->kind) {
    case Node::Kind::known:
      return node_->known ? "true" : "false";
    case Node::Kind::flag:
      return node_->word;
    case Node::Kind::sign:
      if (s.negative && s.positive) return "(not " + compared("=", node_->term) + ")";
      if (s.negative) return compared(s.zero ? "<=" : "<", node_->term);
      if (s.positive) return compared(s.zero ? ">=" : ">", node_->term);
      return compared("=", node_->term);
    case Node::Kind::join:
      break;
  }
  std::string text = "(" + node_->word;
  for (const Formula& part : node_->parts) text += " " + part.to_smt();
  return text + ")";
}

namespace {

/// A known part decides the result or can be left out.
Formula joined(const std::string& word, bool settles, const std::vector<Formula>& parts) {
  std::vector<Formula> unknown;
  for (const Formula& part : parts) {
    if (part.value() == settles) return settles;
    if (!part.value()) unknown.push_back(part);
  }
  if (unknown.empty()) return !settles;
  return unknown.size() == 1 ? unknown.front() : Formula::join(word, unknown);
}

}  // namespace

Formula all_of(const std::vector<Formula>& parts) { return joined("and", false, parts); }
Formula any_of(const std::vector<Formula>& parts) { return joined("or", true, parts); }

Formula negation(const Formula& formula) {
  if (const auto value = formula.value()) return !*value;
  return Formula::join("not", {formula});
}

Formula if_then_else(const Formula& condition, const Formula& then, const Formula& otherwise) {
  if (const auto value = condition.value()) return *value ? then : otherwise;
  if (then.value() && otherwise.value() && *then.value() == *otherwise.value()) return then;
  if (then.value() == true) return any_of({condition, otherwise});
  if (then.value() == false) return all_of({negation(condition), otherwise});
  if (otherwise.value() == true) return any_of({negation(condition), then});
  if (otherwise.value() == false) return all_of({condition, then});
  return Formula::join("ite", {condition, then, otherwise});
}

Formula same(const Formula& a, const Formula& b) { return if_then_else(a, b, negation(b)); }

}  // namespace oplus::smt
