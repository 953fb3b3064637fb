// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/pages/strength.hpp"

#include <algorithm>

namespace oplus {

namespace {

constexpr Strength all_strengths[] = {Strength::machine_checked, Strength::enumerated,
                                      Strength::machine_checked_in_part, Strength::solved,
                                      Strength::sampled};

std::string counted(std::ptrdiff_t number, const std::string& singular, const std::string& plural) {
  return ", " + std::to_string(number) + " " + (number == 1 ? singular : plural);
}

std::ptrdiff_t theorems_of(const Registry& registry, const std::string& id, bool is_whole) {
  return std::count_if(
      registry.theorems.begin(), registry.theorems.end(),
      [&](const ProvedTheorem& t) { return t.statement == id && t.is_whole == is_whole; });
}

std::ptrdiff_t queries_of(const Registry& registry, const std::string& id) {
  return std::count_if(registry.queries.begin(), registry.queries.end(),
                       [&](const AnsweredQuery& query) { return query.statement == id; });
}

/// How much there is of it; empty where there is nothing.
std::string amount(Strength strength, const Registry& registry, const std::string& id) {
  const auto run = registry.runs.find(id);
  const bool has_run = run != registry.runs.end();
  switch (strength) {
    case Strength::machine_checked:
    case Strength::machine_checked_in_part: {
      const auto number = theorems_of(registry, id, strength == Strength::machine_checked);
      return number == 0 ? "" : counted(number, "theorem", "theorems");
    }
    case Strength::enumerated:
      return has_run && run->second.enumerated
                 ? ", " + std::to_string(*run->second.enumerated) + " cases"
                 : "";
    case Strength::solved: {
      const auto number = queries_of(registry, id);
      return number == 0 ? "" : counted(number, "query", "queries");
    }
    case Strength::sampled:
      break;
  }
  return has_run && run->second.run > 0 ? ", " + std::to_string(run->second.run) + " pairs" : "";
}

}  // namespace

Strength strength(const Registry& registry, const Statement& s) {
  for (const Strength each : all_strengths)
    if (!amount(each, registry, s.id).empty()) return each;
  return Strength::sampled;
}

std::string to_string(Strength strength) {
  switch (strength) {
    case Strength::machine_checked:
      return "machine-checked";
    case Strength::enumerated:
      return "proved by enumeration";
    case Strength::machine_checked_in_part:
      return "machine-checked in part";
    case Strength::solved:
      return "proved by SMT in local form";
    case Strength::sampled:
      break;
  }
  return "sampled";
}

std::string backing(const Registry& registry, const Statement& s) {
  std::string text;
  for (const Strength each : all_strengths)
    if (const std::string much = amount(each, registry, s.id); !much.empty())
      text += (text.empty() ? "" : "; ") + to_string(each) + much;
  return text;
}

std::string colour(Strength strength) {
  switch (strength) {
    case Strength::machine_checked:
      return "#7cc26a";
    case Strength::enumerated:
      return "#bfe3b4";
    case Strength::machine_checked_in_part:
      return "#fff2a8";
    case Strength::solved:
      return "#fbd9b0";
    case Strength::sampled:
      break;
  }
  return "#e8eef7";
}

std::string legend() {
  return "Green: machine-checked; light green: proved by enumeration; yellow: machine-checked in part; "
         "orange: proved by SMT\nin local form; blue: sampled on generated pairs only. Of several, "
         "the first.";
}

}  // namespace oplus
