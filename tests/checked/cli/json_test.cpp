// SPDX-License-Identifier: GPL-3.0-or-later
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "checked/cli/json_values.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

/// docs/json.md: the fields, and that they agree with the text output.
class JsonAnswers : public ShellWithRegions {
 protected:
  JsonAnswers() { put("third.wkt", "POLYGON ((0 0, 1/3 0, 0 1/3, 0 0))"); }

  /// Lines "name: value", names as keys are written.
  static std::map<std::string, std::string> values(const std::string& text) {
    std::map<std::string, std::string> result;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      const std::size_t colon = line.find(": ");
      std::string key = line.substr(0, colon);
      for (char& c : key)
        c = std::isalnum(static_cast<unsigned char>(c)) ? static_cast<char>(std::tolower(c)) : '_';
      result[key] = line.substr(colon + 2);
    }
    return result;
  }

  /// The program's standard output, which is JSON.
  Json answer(const std::string& command) const { return Json::parse(run(command, 0).out); }
};

TEST_F(JsonAnswers, gen_list) {
  const Json families = answer("oplus gen --list --json").at("families");
  const std::string text = run("oplus gen --list").out;
  EXPECT_EQ(static_cast<long>(families.size()), std::count(text.begin(), text.end(), '\n'));
  for (const Json& family : families) {
    EXPECT_TRUE(has(text, family.at("name").get<std::string>() + " "));
    EXPECT_TRUE(has(text, " " + family.at("what").get<std::string>() + "\n"));
    EXPECT_GE(family.at("typical"), family.at("smallest"));
  }
}

TEST_F(JsonAnswers, statistics_of_sum_are_those_of_the_text) {
  for (const std::string engine : {"slide", "rca", "oracle"}) {
    const Ran ran = run(
        "oplus sum frame.wkt third.wkt --quiet --stats --stats-json stats.json --engine " + engine,
        0);
    const Json all = Json::parse(content("stats.json"));
    EXPECT_EQ(all.at("engine"), engine);
    EXPECT_EQ(all.at("boundary"), "closed");
    double stages = 0;
    for (const std::string stage :
         {"seconds_for_reading", "seconds_for_validation", "seconds_for_counting_the_convolution",
          "seconds_for_the_sum", "seconds_for_the_region", "seconds_for_the_picture",
          "seconds_for_writing"}) {
      EXPECT_TRUE(all.at(stage).is_number_float()) << stage;
      stages += all.at(stage).get<double>();
    }
    EXPECT_GT(all.at("seconds_for_reading"), 0);
    EXPECT_GT(all.at("seconds_for_validation"), 0);
    EXPECT_LE(stages, all.at("seconds").get<double>() + 1e-5);  // each is rounded
    EXPECT_GT(all.at("peak_memory_in_kilobytes"), 1000);
    std::map<std::string, std::string> said = values(ran.err);
    EXPECT_EQ(static_cast<long>(said.size()), ran.lines_of_err()) << ran.err;
    for (const std::string part : {"summands", "run", "sum", ""}) {
      for (const auto& [key, value] : (part.empty() ? all : all.at(part)).items()) {
        if (!value.is_number() && part.empty()) continue;
        ASSERT_TRUE(said.contains(key)) << key;
        if (value.is_number_float())
          EXPECT_EQ(std::stod(said.at(key)), value) << key;
        else
          EXPECT_EQ(said.at(key), value.is_string() ? value.get<std::string>() : value.dump())
              << key;
        said.erase(key);
      }
    }
    EXPECT_TRUE(said.empty()) << said.begin()->first;
  }
}

TEST(JsonValues, seconds_between_two_texts) {
  // The double is below 0.0068705, its product with 1e6 is not.
  const Quantity seconds = Seconds(0.0068705);
  EXPECT_EQ(std::stod(in_text(seconds)), json(seconds));
}

TEST_F(JsonAnswers, numbers_are_exact) {
  std::string decimals(70, '3');
  put("long.wkt", "POLYGON ((0 0, 1." + decimals + "7 0, 0 1." + decimals + "1, 0 0))");
  const Json long_area =
      answer("oplus sum long.wkt long.wkt -o sum.wkt --stats-json -").at("sum").at("area");
  EXPECT_GT(long_area.get<std::string>().size(), 140U);  // --stats rounds such a one
  EXPECT_EQ(answer("oplus compare third.wkt third.wkt --json").at("first").at("area"), "1/18");
}

TEST_F(JsonAnswers, of_oplus_check_properties) {
  const std::string command = "oplus-check properties --theorem lemma-4.1.4 --cases 20";
  const Json all = answer(command + " --json");
  EXPECT_EQ(
      run("oplus-maintain" + command.substr(command.find(' ')) + " --record r.json").exit_code, 0);
  EXPECT_EQ(all, Json::parse(content("r.json")));
  EXPECT_EQ(all.at("passed"), 1);
  EXPECT_EQ(all.at("failed"), 0);
  const Json& one = all.at("statements").at(0);
  EXPECT_EQ(one.at("statement"), "lemma-4.1.4");
  EXPECT_EQ(one.at("passed"), true);
  EXPECT_EQ(one.at("complaints"), Json::array());
  const std::string text = run(command).out;
  EXPECT_TRUE(has(text, "  " + one.at("run").dump() + " cases run, " + one.at("discarded").dump() +
                            " discarded\n"));
  for (const auto& [family, cases] : one.at("families").items())
    EXPECT_TRUE(has(text, family + " " + cases.dump()));

  const Json pair =
      answer("oplus-check properties --theorem lemma-4.1.4 --pair full.wkt frame.wkt --json");
  EXPECT_EQ(pair.at("statements").at(0).at("outcome"), "holds");
  EXPECT_EQ(pair.at("not_applicable"), 0);
}

TEST_F(JsonAnswers, of_oplus_check_theorems) {
  const Json all = answer("oplus-check theorems --json");
  const std::string text = run("oplus-check theorems").out;
  EXPECT_TRUE(has(text, "\n" + std::to_string(all.at("statements").size()) + " statements, " +
                            std::to_string(all.at("mutants").size()) + " mutants\n"));
  const std::string entry = run("oplus-check theorems lemma-4.1.4").out;
  const Json one = answer("oplus-check theorems lemma-4.1.4 --json");
  EXPECT_NE(std::find(all.at("statements").begin(), all.at("statements").end(), one),
            all.at("statements").end());
  for (const std::string key : {"statement", "title", "says", "why", "file"})
    EXPECT_TRUE(has(entry, one.at(key).get<std::string>())) << key;
}

}  // namespace
}  // namespace oplus
