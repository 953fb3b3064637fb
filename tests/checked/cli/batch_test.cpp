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
const std::string triangle = "POLYGON((0 0,1 0,0 1/3,0 0))";
const std::string bow_tie = "POLYGON((0 0,1 1,1 0,0 1,0 0))";
const std::string square_in_geojson =
    R"({"type": "Polygon", "coordinates": [[[0,0],[1,0],[1,1],[0,1],[0,0]]]})";
const std::string two_by_two = "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))";

class Batch : public Shell {
 protected:
  Batch() {
    put("square.tsv", square + "\t" + square + "\n");
    put("parts.txt", "# parts\nunit\t" + square + "\n\n" + triangle + "\n");
  }

  /// The answers of a command that succeeds, a line each.
  std::vector<Json> answers(const std::string& command, int exit_code = 0) const {
    const Ran ran = run(command, exit_code);
    std::vector<Json> result;
    std::istringstream lines(ran.out);
    for (std::string line; std::getline(lines, line);) result.push_back(Json::parse(line));
    return result;
  }
};

TEST_F(Batch, writes_a_line_for_each_pair) {
  put("pairs", "\xEF\xBB\xBF# two squares, a blank line, and others\r\n" + square + "\t" + square +
                   "\r\n \t \r\n  # more\n" + square_in_geojson + "\t" + square + "\n" +
                   R"({"p": )" + square_in_geojson + R"(, "id": {"a": ["}"]}, "q": ")" + square +
                   "\"}\n" + square + "\tPOLYGON EMPTY");
  const std::string result = ", \"result\": \"" + two_by_two + "\"}\n";
  expect_output("oplus batch pairs", "{\"line\": 2" + result + "{\"line\": 5" + result +
                                         "{\"line\": 6, \"id\": {\"a\": [\"}\"]}" + result +
                                         "{\"line\": 7, \"result\": \"POLYGON EMPTY\"}\n");
  expect_output("cat pairs | oplus batch -", run("oplus batch pairs").out);
  expect_output("oplus batch pairs -o out && cat out", run("oplus batch pairs").out);
}

TEST_F(Batch, of_nothing_is_nothing) {
  put("empty", "");
  put("comments", "# nothing\n\n\t\n");
  for (const std::string file : {"empty", "comments"}) {
    expect_output("oplus batch " + file, "");
    expect_output("oplus batch --parts " + file, "");
    expect_output("oplus batch " + file + " -o out && wc -c <out", "0\n");
  }
}

TEST_F(Batch, writes_what_is_asked_for) {
  put("one.tsv", "POLYGON((0 0,1 0,0 1,0 0))\tPOLYGON((0 0,1/3 0,0 1/3,0 0))\n");
  const std::string line = "{\"line\": 1, ";
  expect_output("oplus batch one.tsv",
                line + "\"result\": \"POLYGON ((0 0, 4/3 0, 0 4/3, 0 0))\"}\n");
  expect_output("oplus batch one.tsv --digits 2",
                line + "\"result\": \"POLYGON ((0 0, 1.33 0, 0 1.33, 0 0))\"}\n");
  put("thin.tsv", "POLYGON ((0 0, 1 0, 0.4 0.3, 0 0))\tPOLYGON ((0 0, 0.01 0, 0 0.01, 0 0))\n");
  expect_output("oplus batch thin.tsv --digits 0", line + "\"result\": \"POLYGON EMPTY\"}\n");
  // As each sum alone.
  put("p.wkt", "POLYGON((0 0,1 0,0.4 0.3,0 1,0 0))");
  put("q.wkt", "POLYGON((0 0,1/3 0,0 1/3,0 0))");
  put("pair.tsv", content("p.wkt") + "\t" + content("q.wkt"));
  for (const std::string options : {"--grid 0.25", "--grid 1/7 --side contain --open",
                                    "--digits 1 --side contained", "--grid 0.3 --side nearest"}) {
    std::string alone = run("oplus --quiet sum p.wkt q.wkt " + options).out;
    alone.pop_back();
    EXPECT_EQ(answers("oplus batch pair.tsv " + options).at(0).at("result"), alone) << options;
  }
  expect_output("oplus batch one.tsv --format area --digits 3", line + "\"area\": \"0.889\"}\n");
  expect_output("oplus batch one.tsv --format area", line + "\"area\": \"8/9\"}\n");
  expect_output("oplus batch one.tsv --format geojson",
                line + R"("result": {"type": "Polygon", "coordinates": )" +
                    R"([[[0, 0], ["4/3", 0], [0, "4/3"], [0, 0]]]}})" + "\n");
}

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
  put("point.json", R"json({"p": {"type": "Point", "coordinates": [1, 2]}, )json"
                    R"json("q": "LINESTRING(0 0,1 0)"})json");
  expect_output("oplus batch point.json",
                "{\"line\": 1, \"result\": \"GEOMETRYCOLLECTION (LINESTRING (1 2, 2 2))\"}\n");
  put("pair.tsv", path + "\t" + square + "\n0 1 3 0 0 1 0 0 1\t" + square + "\n");
  const std::vector<Json> wrong = answers("oplus batch pair.tsv --operation ifp", 2);
  EXPECT_EQ(wrong.at(0).at("error"),
            "P has line strings or points; expected polygons, as P of ifp");
  EXPECT_EQ(wrong.at(1).at("error"),
            "pair.tsv:2:1: P: the region is unbounded; expected a bounded region");
}

TEST_F(Batch, takes_unions_where_asked) {
  const std::string walls = "MULTIPOLYGON(((0 0,2 0,2 1,0 1,0 0)),((1 0,3 0,3 1,1 1,1 0)))";
  put("walls.tsv", square + "\t" + walls + "\n");
  const std::string right = "POLYGON ((0 0, 4 0, 4 2, 0 2, 0 0))";
  EXPECT_EQ(answers("oplus batch walls.tsv --union").at(0).at("result"), right);
  EXPECT_TRUE(has(answers("oplus batch walls.tsv", 2).at(0).at("error"),
                  "expected chains that at most touch in points; add --union to take their union"));
  put("unit.txt", square);
  put("walls.txt", walls);
  EXPECT_EQ(answers("oplus batch --parts unit.txt --with walls.txt --union").at(0).at("result"),
            right);
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

TEST_F(Batch, an_error_is_a_line) {
  put("pairs", square + "\t" + bow_tie + "\n" + square + "\t" + square + "\n" + square + "\n" +
                   square + "\t" + square + "\t" + square + "\n" + square + "\tPOLYGON((0 0,1 0,x" +
                   " 1,0 0))\n{\"p\": \"" + square + "\"}\n{\"p\": 1, \"q\": 2}\n{\"p\": ]\n" +
                   R"({"id": 7, "p": {"type": "Curve"}, "q": ")" + square + "\"}\n" + square +
                   "\t" + square + "\n");
  const Ran ran = run("oplus batch pairs -o out", 2);
  EXPECT_EQ(ran.lines_of_err(), 1) << ran.err;
  EXPECT_TRUE(has(ran.err, "oplus: 8 of 10 lines are errors, the first: pairs:1:"));
  std::istringstream lines(content("out"));
  std::vector<Json> out;
  for (std::string line; std::getline(lines, line);) out.push_back(Json::parse(line));
  ASSERT_EQ(out.size(), 10U);
  const std::vector<std::string> expected = {
      "pairs:1:",
      "",
      "pairs:3: one field; expected two geometries with a tab between them",
      "pairs:4: 3 fields; expected",
      "pairs:5:49: Q: x of vertex 3 of outer chain of component 1: 'x' is not a number",
      "pairs:6:1: an object without 'q'; expected",
      "pairs:7:7: P: ",
      "pairs:8:7: ']' in JSON; expected a value",
      "pairs:9:25: P: ",
      ""};
  for (std::size_t i = 0; i < out.size(); ++i) {
    EXPECT_EQ(out[i].at("line"), i + 1);
    EXPECT_EQ(out[i].contains("result"), expected[i].empty()) << out[i];
    EXPECT_TRUE(has(out[i].value("error", ""), expected[i])) << i;
  }
  EXPECT_TRUE(has(out[0].at("error"), "Q: "));
  // One of them alone.
  put("one", "{\"p\": \"" + bow_tie + "\", \"q\": \"" + square + "\"}");
  EXPECT_TRUE(has(run("oplus batch one --quiet").err, "oplus: 1 of 1 line is an error: one:1:"));
}

TEST_F(Batch, says_what_was_turned_once) {
  const std::string clockwise = "POLYGON((0 0,0 1,1 1,1 0,0 0))";
  put("pairs", square + "\t" + clockwise + "\n" + clockwise + "\t" + square + "\n");
  const Ran ran = run("oplus batch pairs", 0);
  EXPECT_EQ(ran.lines_of_err(), 1);
  EXPECT_TRUE(has(ran.err,
                  "oplus: pairs:1: Q: outer chain of component 1 was clockwise; turned; "
                  "likewise 1 other line\n"));
  EXPECT_EQ(run("oplus batch pairs --quiet").err, "");
}

TEST_F(Batch, of_parts_is_of_all_pairs) {
  const std::vector<Json> all = answers("oplus batch --parts parts.txt --format area");
  EXPECT_EQ(all, (std::vector<Json>{{{"p", "unit"}, {"q", "unit"}, {"area", "4"}},
                                    {{"p", "unit"}, {"q", 2}, {"area", "2.5"}},
                                    {{"p", 2}, {"q", "unit"}, {"area", "2.5"}},
                                    {{"p", 2}, {"q", 2}, {"area", "2/3"}}}));
  const std::vector<Json> once = answers("oplus batch --parts parts.txt --format area --unordered");
  EXPECT_EQ(once, (std::vector<Json>{all[0], all[1], all[3]}));
  put("other.txt", triangle);
  EXPECT_EQ(answers("oplus batch --parts parts.txt --with other.txt --format area"),
            (std::vector<Json>{{{"p", "unit"}, {"q", 1}, {"area", "2.5"}},
                               {{"p", 2}, {"q", 1}, {"area", "2/3"}}}));
  put("parts_with_errors.txt", square + "\nwrong\t" + bow_tie + "\n" + triangle + "\n");
  const std::vector<Json> others =
      answers("oplus batch --parts parts_with_errors.txt --format area", 2);
  ASSERT_EQ(others.size(), 5U);
  EXPECT_EQ(others[0].at("part"), 2);
  EXPECT_TRUE(has(others[0].at("error"), "parts_with_errors.txt:2:24: "));
  EXPECT_EQ(others[4], Json({{"p", 3}, {"q", 3}, {"area", "2/3"}}));
}

TEST_F(Batch, turns_parts_exactly) {
  put("l.wkt", "POLYGON((0 0,3 0,3 1,1 1,1 2,0 2,0 0))");
  expect_output("oplus batch --parts l.wkt --with l.wkt --rotations 0,90,-180 --format area",
                "{\"p\": 1, \"q\": 1, \"degrees\": \"0\", \"cos\": \"1\", \"sin\": \"0\", "
                "\"area\": \"18\"}\n"
                "{\"p\": 1, \"q\": 1, \"degrees\": \"90\", \"cos\": \"0\", \"sin\": \"1\", "
                "\"area\": \"21\"}\n"
                "{\"p\": 1, \"q\": 1, \"degrees\": \"-180\", \"cos\": \"-1\", \"sin\": \"0\", "
                "\"area\": \"20\"}\n");
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

TEST_F(Batch, answers_while_the_input_goes_on) {
  expect_output(
      "mkfifo pipe; oplus batch pipe >out 2>err & exec 3>pipe; cat square.tsv >&3\n"
      "for i in {1..600}; do [ -s out ] && break; sleep 0.05; done\n"
      "cat out; echo and >&3; exec 3>&-; wait $!; echo $?; wc -l <out",
      "{\"line\": 1, \"result\": \"" + two_by_two + "\"}\n2\n2\n");
}

TEST_F(Batch, a_closed_pipe_ends_it_quietly) {
  const std::string pipe = "rm -f ../pipe; mkfifo ../pipe; exec 3<>../pipe 4>../pipe 3>&-; ";
  expect_output(pipe + "oplus batch square.tsv >&4", "", 128 + SIGPIPE);
  expect_output("yes \"$(cat square.tsv)\" | oplus batch - | head -2 | tail -1",
                "{\"line\": 2, \"result\": \"" + two_by_two + "\"}\n");
}

TEST_F(Batch, is_interrupted_without_leaving_anything) {
  for (const auto& [name, number] :
       {std::pair("INT", SIGINT), std::pair("TERM", SIGTERM), std::pair("HUP", SIGHUP),
        std::pair("QUIT", SIGQUIT), std::pair("XCPU", SIGXCPU)})
    // Its exit code is that of a program that does nothing about the signal.
    expect_output(
        "ulimit -c 0; set -m; rm -f pipe; mkfifo pipe; oplus batch pipe -o out 2>err & exec 3>pipe\n"
        "cat square.tsv >&3\n"
        "for i in {1..600}; do compgen -G 'out.*' >/dev/null && break; sleep 0.05; done\n"
        "kill -" +
            std::string(name) + " $!; wait $! 2>/dev/null; echo $?; cat err; ls",
        std::to_string(128 + number) + "\nerr\nparts.txt\npipe\nsquare.tsv\n");
}

TEST_F(Batch, is_refused_where_it_cannot_be_done) {
  expect_refusal("oplus batch", "expected either a file of pairs or --parts FILE");
  expect_refusal("oplus batch square.tsv --parts parts.txt", "expected either");
  expect_refusal("oplus batch square.tsv --unordered", "are for --parts");
  expect_refusal("oplus batch --parts parts.txt --with parts.txt --unordered", "--unordered");
  expect_refusal("oplus batch --parts parts.txt --rotations 90 --rotation-step 90", "either");
  expect_refusal("oplus batch --parts parts.txt --rotations 90,x", "'x' is not a number");
  expect_refusal("oplus batch --parts parts.txt --rotation-step 0", "at least");
  expect_refusal("oplus batch --parts parts.txt --rotation-step -90", "at least");
  expect_refusal("oplus batch --parts parts.txt --rotations 30 --angle-error 0",
                 "--angle-error takes degrees above 0, not '0'");
  expect_refusal("oplus batch --parts - --with -", "standard input");
  expect_refusal("oplus batch square.tsv --operation plus", "plus");
  expect_refusal("oplus batch square.tsv --operation nfp --open", "--open");
  expect_refusal("oplus batch square.tsv --format dat", "dat");
  expect_refusal("oplus batch square.tsv --side contain", "--side is for rounded output");
  expect_refusal("oplus batch square.tsv --grid 1 --digits 1", "give one of the two");
  expect_refusal("oplus batch square.tsv --grid 0", "--grid takes a step above 0");
  expect_refusal("oplus batch square.tsv --grid 1 --format area", "areas are rounded by --digits");
  expect_refusal("oplus batch missing", "missing: cannot be opened");
  expect_refusal("oplus batch --parts missing", "missing: cannot be opened");
  expect_refusal("oplus batch .", "cannot be read");
  expect_refusal("oplus batch . -o out", "cannot be read");
  expect_refusal("oplus batch square.tsv -o missing/out", "missing/out");
  expect_refusal("oplus batch square.tsv >/dev/full", "cannot write standard output");
  expect_refusal("oplus batch square.tsv >&-", "cannot write standard output");
  expect_refusal("oplus batch - <&-", "standard input");
}

}  // namespace
}  // namespace oplus
