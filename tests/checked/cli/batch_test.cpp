// SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>

#include "checked/operations/operations.hpp"
#include "checked/slide/slide.hpp"
#include "reference/arithmetic/rational_rotation.hpp"
#include "reference/families/family.hpp"
#include "reference/io/writing.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

using Json = nlohmann::json;

const std::string square = "POLYGON((0 0,1 0,1 1,0 1,0 0))";

class Batch : public Shell {
 protected:
  /// The answers of a command that succeeds, a line each.
  std::vector<Json> answers(const std::string& command, int exit_code = 0) const {
    const Ran ran = run(command, exit_code);
    std::vector<Json> result;
    std::istringstream lines(ran.out);
    for (std::string line; std::getline(lines, line);) result.push_back(Json::parse(line));
    return result;
  }
};

/// Each operation as its own command computes it.
TEST_F(Batch, computes_every_operation) {
  put("p.wkt", "POLYGON((0 0,4 0,4 4,0 4,0 0),(1 1,1 3,3 3,3 1,1 1))");
  put("q.wkt", "POLYGON((0 0,2 0,2 2,0 2,0 0))");
  put("pair.tsv", content("p.wkt") + "\t" + content("q.wkt"));
  std::vector<std::pair<std::string, std::string>> commands = {{"sum", "sum"},
                                                               {"sum --open", "sum --open"}};
  for (const Operation& operation : operations())
    commands.emplace_back(operation.name, operation.name);
  EXPECT_GE(commands.size(), 7U);
  for (const auto& [operation, command] : commands) {
    std::string alone = run("oplus --quiet " + command + " p.wkt q.wkt").out;
    alone.pop_back();
    EXPECT_EQ(answers("oplus batch pair.tsv --operation " + operation).at(0).at("result"), alone)
        << operation;
    // And of parts, which are prepared.
    EXPECT_EQ(answers("oplus batch --parts p.wkt --with q.wkt --operation " + operation)
                  .at(0)
                  .at("result"),
              alone)
        << operation;
  }
}

/// Line strings and points, as each command takes them.
TEST_F(Batch, takes_other_sets) {
  const std::string path = "LINESTRING(0 0,1 0,1 2)";
  put("bin.wkt", "POLYGON((0 0,3 0,3 3,0 3,0 0))");
  put("path.wkt", path);
  put("turned.wkt", "LINESTRING(0 0,0 1,-2 1)");
  for (const std::string operation :
       {"sum", "sum --open", "nfp", "ifp", "erode", "open", "close"}) {
    std::string alone = run("oplus --quiet " + operation + " bin.wkt path.wkt").out;
    alone.pop_back();
    put("pair.tsv", content("bin.wkt") + "\t" + path);
    EXPECT_EQ(answers("oplus batch pair.tsv --operation " + operation).at(0).at("result"), alone)
        << operation;
    std::string turned = run("oplus --quiet " + operation + " bin.wkt turned.wkt").out;
    turned.pop_back();
    const std::vector<Json> parts = answers(
        "oplus batch --parts bin.wkt --with path.wkt --rotations 0,90 --operation " + operation);
    EXPECT_EQ(parts.at(0).at("result"), alone) << operation;
    EXPECT_EQ(parts.at(1).at("result"), turned) << operation;
  }
}

TEST_F(Batch, of_many_pairs_is_each_sum_in_order) {
  std::string pairs, expected, open;
  std::uint64_t seed = 0;
  for (const Family& family : families())
    for (int i = 0; i < 25; ++i) {
      const auto [p, q] = generate(family, std::max<std::size_t>(family.smallest, 4), ++seed);
      pairs += wkt(p) + "\t" + wkt(q) + "\n";
      const std::string line = "{\"line\": " + std::to_string(seed) + ", \"result\": \"";
      expected += line + wkt(slide_sum(p, q, Boundary::closed).sum) + "\"}\n";
      open += line + wkt(slide_sum(p, q, Boundary::open).sum) + "\"}\n";
    }
  put("pairs.tsv", pairs);
  for (const std::string threads : {"0", "1", "2", "7"}) {
    EXPECT_EQ(run("oplus batch pairs.tsv --threads " + threads).out, expected);
    EXPECT_EQ(run("oplus batch pairs.tsv --open --threads " + threads).out, open);
  }
}

TEST_F(Batch, turns_parts_exactly) {
  put("p.wkt", square);
  put("q.wkt", "POLYGON((0 0,5 0,0 7/3,0 0))");
  const std::vector<Json> turned =
      answers("oplus batch --parts p.wkt --with q.wkt --rotation-step 22.5 --operation nfp");
  ASSERT_EQ(turned.size(), 16U);
  for (std::size_t i = 0; i < turned.size(); ++i) {
    const Rational degrees = Rational(45, 2) * static_cast<int>(i);
    const auto [cos, sin] = rational_rotation(degrees, Rational(1, 1000));
    EXPECT_EQ(turned[i].at("degrees"), to_string(degrees));
    EXPECT_EQ(turned[i].at("cos"), to_string(cos));
    EXPECT_EQ(turned[i].at("sin"), to_string(sin));
    const Region p = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    const Region q =
        polygon({{0, 0}, {5 * cos, 5 * sin}, {-Rational(7, 3) * sin, Rational(7, 3) * cos}});
    EXPECT_EQ(turned[i].at("result"), wkt(slide_sum(p, reflected(q), Boundary::open).sum));
  }
  const std::vector<Json> precise =
      answers("oplus batch --parts p.wkt --rotations 30 --angle-error 1e-12 --format area");
  EXPECT_GT(precise.at(0).at("cos").get<std::string>().size(), 8U);
}

TEST_F(Batch, turns_q_of_pairs_too) {
  const std::string l = "POLYGON((0 0,3 0,3 1,1 1,1 2,0 2,0 0))";
  put("l.tsv", l + "\t" + l + "\n" + square + "\n" + R"({"p": ")" + l + R"(", "q": ")" + l +
                   R"(", "id": 7})" + "\n");
  put("l.wkt", l);
  const std::vector<Json> pairs =
      answers("oplus batch l.tsv --rotations 0,90,-180,30 --operation nfp", 2);
  const std::vector<Json> parts =
      answers("oplus batch --parts l.wkt --rotations 0,90,-180,30 --operation nfp");
  ASSERT_EQ(pairs.size(), 12U);
  for (std::size_t i = 0; i < 12; ++i) {
    for (const std::string member : {"degrees", "cos", "sin"})
      EXPECT_EQ(pairs[i].at(member), parts.at(i % 4).at(member)) << i;
    EXPECT_EQ(pairs[i].at("line"), i / 4 + 1);
    if (i / 4 == 1)
      EXPECT_TRUE(has(pairs[i].at("error"), "l.tsv:2: one field")) << i;
    else
      EXPECT_EQ(pairs[i].at("result"), parts.at(i % 4).at("result")) << i;
    EXPECT_EQ(pairs[i].contains("id"), i >= 8) << i;
  }
}

TEST_F(Batch, takes_lines_of_any_length) {
  std::string teeth;
  for (int i = 50000; i > 0; --i)
    teeth += std::to_string(2 * i) + " 5," + std::to_string(2 * i - 1) + " 1,";
  put("long", square + "\t" + square + "\n" + square + "\tPOLYGON((0 0,100000 0," + teeth +
                  "0 0))\n" + square + "\t" + square + "\n");
  const std::vector<Json> out = answers("oplus batch long --format area");
  ASSERT_EQ(out.size(), 3U);
  EXPECT_EQ(out[0].at("area"), "4");
  EXPECT_TRUE(out[1].contains("area")) << out[1];
  EXPECT_EQ(out[2], Json({{"line", 3}, {"area", "4"}}));
}

TEST_F(Batch, is_interrupted_without_leaving_anything) {
  put("square.tsv", square + "\t" + square + "\n");
  for (const auto& [name, number] :
       {std::pair("INT", SIGINT), std::pair("TERM", SIGTERM), std::pair("HUP", SIGHUP),
        std::pair("QUIT", SIGQUIT), std::pair("XCPU", SIGXCPU)})
    // Its exit code is that of a program that does nothing about the signal.
    expect_output(
        "ulimit -c 0; rm -f pipe; mkfifo pipe\n"
        "env --default-signal oplus batch pipe -o out 2>err & exec 3>pipe\n"
        "cat square.tsv >&3\n"
        "for i in {1..600}; do compgen -G 'out.*' >/dev/null && break; sleep 0.05; done\n"
        "kill -" +
            std::string(name) + " $!; wait $! 2>/dev/null; echo $?; cat err; ls",
        std::to_string(128 + number) + "\nerr\npipe\nsquare.tsv\n");
}

}  // namespace
}  // namespace oplus
