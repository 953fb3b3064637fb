// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "checked/oplus/oplus.hpp"

namespace oplus {
namespace {

using nlohmann::json;

/// A case of tests/corpus/cases.json, by the functions of the public header.
class Case {
 public:
  explicit Case(const json& members) : case_(members) {}

  /// What an operation gives, in the members by which the case says what to expect.
  json found(const std::string& operation) const {
    try {
      const auto both = [&](const auto& compute) { return of(compute(region("p"), region("q"))); };
      if (operation == "read") return of(region("p"));
      if (operation == "read a set") return of(set("p"));
      if (operation == "sum") return of(minkowski_sum(region("p"), region("q"), options()));
      if (operation == "sum of sets") return of(minkowski_sum(set("p"), set("q"), options()));
      if (operation == "nfp") return both([](auto p, auto q) { return nfp(p, q); });
      if (operation == "ifp") return both([](auto p, auto q) { return ifp(p, q); });
      if (operation == "erode") return both([](auto p, auto q) { return erosion(p, q); });
      if (operation == "open") return both([](auto p, auto q) { return opening(p, q); });
      if (operation == "close") return both([](auto p, auto q) { return closing(p, q); });
      if (operation == "complement") return of(complement(region("p")));
      if (operation == "reflect") return of(-region("p"));
      if (operation == "reflect a set") return of(-set("p"));
      if (operation == "transform") return of(transformed(ValidSet(region("p")), map()));
      if (operation == "disc") {
        const bool is_inside = text("disc") == "inside";
        return of(
            disc(text("radius"), is_inside ? DiscSide::inside : DiscSide::outside, text("error")));
      }
      if (operation == "verify") return of_verdict();
      if (operation == "repair") return of_repair();
      if (operation == "distance") {
        const auto [squared, on_p, on_q] = distance(region("p"), region("q"));
        return of_answer(squared, {on_p, on_q});
      }
      if (operation == "depth") {
        const std::optional<Overlap> overlap = depth(region("p"), region("q"));
        if (!overlap) return {{"answer", json::array()}};
        return of_answer(overlap->squared_depth, {overlap->move, overlap->contact});
      }
    } catch (const InvalidInput& error) {
      return {{"refused", std::regex_replace(error.what(), std::regex("^text:"), "file:")}};
    }
    return {{"unknown", operation}};
  }

 private:
  std::string text(const char* name) const { return case_.value(name, ""); }

  ValidRegion region(const char* name) const {
    return read_text(text(name), case_.contains("union") ? Overlaps::allowed : Overlaps::refused);
  }

  ValidSet set(const char* name) const { return read_set(text(name)); }

  SumOptions options() const {
    return {.boundary = case_.contains("open") ? Boundary::open : Boundary::closed};
  }

  AffineMap map() const {
    AffineMap all;
    for (const json& one : case_.at("maps")) {
      const std::string name = one.at(0), values = one.at(1);
      const std::size_t comma = std::min(values.find(','), values.size());
      const std::string x = values.substr(0, comma);
      const bool has_two = comma < values.size();
      const std::string y = has_two ? values.substr(comma + 1) : x;
      all = (name == "translate" ? translation({x, y})
             : name == "scale"   ? scaling(x, y)
             : has_two           ? rotation_to({x, y})
                                 : rotation(x)) *
            all;
    }
    return all;
  }

  template <typename Set>
  json of(const Set& set) const {
    if (case_.contains("grid")) {
      const Side side = text("side") == "contain"     ? Side::contain
                        : text("side") == "contained" ? Side::contained
                                                      : Side::nearest;
      return {{"is", to_wkt(rounded(set, text("grid"), side).sum)}};
    }
    if (case_.contains("complement is")) return {{"complement is", to_wkt(complement(set))}};
    std::optional<int> digits;
    if (case_.contains("digits")) digits = std::stoi(text("digits"));
    return {{"is", text("format") == "geojson" ? to_geojson(set, digits)
                   : text("format") == "wkb"   ? to_wkb(set)
                                               : to_wkt(set, digits)}};
  }

  json of_verdict() const {
    const ClaimedSum given = read_claimed_sum(case_.at("s").dump());
    json reasons = json::array();
    for (const Reason& reason : verify(region("p"), region("q"), given, options().boundary).reasons)
      reasons.push_back(describe(reason.kind) + ": " + reason.detail);
    return {{"reasons", reasons}};
  }

  json of_repair() const {
    std::optional<FillRule> fill;
    if (case_.contains("fill"))
      fill = text("fill") == "even-odd" ? FillRule::even_odd : FillRule::nonzero;
    const Repaired result = repaired_text(text("p"), fill);
    json mends = json::array();
    for (const auto& [kind, where, what] : result.mends)
      mends.push_back(std::to_string(where.line) + ':' + std::to_string(where.column) + ": " +
                      what);
    return {{"is", to_wkt(result.region)}, {"mends", mends}};
  }

  /// As many numbers as the case has.
  json of_answer(const Rational& squared, const std::vector<Point>& points) const {
    json numbers = {squared.get_str()};
    for (const Point& p : points)
      for (const Rational* coordinate : {&p.x, &p.y}) numbers.push_back(coordinate->get_str());
    while (numbers.size() > case_.at("answer").size()) numbers.erase(numbers.size() - 1);
    return {{"answer", numbers}};
  }

  const json& case_;
};

TEST(Cases, give_what_is_expected) {
  std::ifstream file(OPLUS_CASES);
  const json all = json::parse(file);
  int count = 0;
  for (const json& one : all.at("cases")) {
    json expected;
    for (const char* name : {"is", "complement is", "refused", "reasons", "mends", "answer"})
      if (one.contains(name)) expected[name] = one[name];
    for (const std::string operation : one.at("run")) {
      const json& layers = one.value("layers", all.at("layers").at(operation));
      if (std::find(layers.begin(), layers.end(), "library") == layers.end()) continue;
      ++count;
      EXPECT_EQ(Case(one).found(operation), expected) << one.at("name") << ", " << operation;
    }
  }
  EXPECT_GT(count, 400);
}

}  // namespace
}  // namespace oplus
