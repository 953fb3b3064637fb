// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/pages/strength.hpp"

#include <algorithm>

#include "reference/io/counted.hpp"
#include "reference/pictures/picture.hpp"

namespace oplus {

namespace {

struct Look {
  Strength strength;
  const char* name;
  const char* colour;  ///< for Graphviz
  const char* colour_name;
};

/// From the strongest to the weakest.
constexpr Look looks[] = {
    {Strength::machine_checked, "machine-checked", "#7cc26a", "green"},
    {Strength::enumerated, "proved by enumeration", "#bfe3b4", "light green"},
    {Strength::machine_checked_in_part, "machine-checked in part", "#fff2a8", "yellow"},
    {Strength::solved, "proved by SMT in local form", "#fbd9b0", "orange"},
    {Strength::sampled, "sampled", "#e8eef7", "blue"},
};

const Look& look_of(Strength strength) {
  return *std::ranges::find(looks, strength, &Look::strength);
}

constexpr const char* border_of_whole = "#1d6b2f";
constexpr const char* border_of_part = "#c98a00";
constexpr const char* border_without_coq = "#8898aa";

/// Returns ", 2 theorems"; empty for zero.
std::string amount_of(std::ptrdiff_t number, const std::string& one, const std::string& many) {
  return number == 0 ? "" : ", " + counted(static_cast<std::size_t>(number), one, many);
}

std::ptrdiff_t theorems_of(const Registry& registry, const std::string& id, bool is_whole) {
  return std::ranges::count_if(registry.theorems, [&](const ProvedTheorem& t) {
    return t.statement == id && t.is_whole == is_whole;
  });
}

/// The number of theorems, cases, queries or pairs, in words; empty if there is none.
std::string amount(Strength strength, const Registry& registry, const std::string& id) {
  const auto run = registry.runs.find(id);
  const bool has_run = run != registry.runs.end();
  switch (strength) {
    case Strength::machine_checked:
    case Strength::machine_checked_in_part:
      return amount_of(theorems_of(registry, id, strength == Strength::machine_checked), "theorem",
                       "theorems");
    case Strength::enumerated:
      return has_run && run->second.enumeration
                 ? ", " + std::to_string(run->second.enumeration->cases) + " cases"
                 : "";
    case Strength::solved:
      return amount_of(std::ranges::count(registry.queries, id, &AnsweredQuery::statement), "query",
                       "queries");
    case Strength::sampled:
      break;
  }
  return has_run && run->second.run > 0 ? ", " + std::to_string(run->second.run) + " pairs" : "";
}

}  // namespace

Strength strength(const Registry& registry, const Statement& s) {
  for (const Look& look : looks)
    if (!amount(look.strength, registry, s.id).empty()) return look.strength;
  return Strength::sampled;
}

std::string to_string(Strength strength) { return look_of(strength).name; }

std::string backing(const Registry& registry, const Statement& s) {
  std::string text;
  for (const Look& look : looks)
    if (const std::string much = amount(look.strength, registry, s.id); !much.empty())
      text += (text.empty() ? "" : "; ") + (look.name + much);
  return text;
}

std::string colour(Strength strength) { return look_of(strength).colour; }

std::string border_colour(const Registry& registry, const Statement& s) {
  if (theorems_of(registry, s.id, true) > 0) return border_of_whole;
  return theorems_of(registry, s.id, false) > 0 ? border_of_part : border_without_coq;
}

std::string legend() {
  std::string text =
      "The colour of a node is the strongest way in which the statement is backed:\n\n";
  for (const Look& look : looks)
    text += "- " + (std::string(look.colour_name) + ": " + look.name) + '\n';
  return text +
         "\nAll are stated in C++. The border shows what is stated in Coq, too:\n\n"
         "- dark green: all of it\n- brown: a part of it, or of its proof\n- grey: nothing\n";
}

}  // namespace oplus
