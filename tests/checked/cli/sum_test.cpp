// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <nlohmann/json.hpp>

#include "properties/runner/source_tree.hpp"
#include "tests/checked/cli/shell.hpp"
#include "tests/reference/pictures/parsed_picture.hpp"

namespace oplus {
namespace {

const std::string doubled_square = "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))\n";

class Sum : public ShellWithRegions {
 protected:
  Sum() {
    // A square of side 2 fits into the frame's hole in one place, and a bar of side 1 along a segment.
    put("plug.wkt", "POLYGON ((-1 -1, 1 -1, 1 1, -1 1, -1 -1))");
    put("slider.wkt", "POLYGON ((-1 0, 1 0, 1 1, -1 1, -1 0))");
  }
};

TEST_F(Sum, with_fractions_says_that_others_do_not_read_them) {
  for (const std::string format : {"wkt", "geojson"}) {
    const Ran ran = run("oplus sum square.wkt triangle.dat --format " + format, 0);
    EXPECT_EQ(
        ran.err,
        "oplus: coordinates such as '4/3' are written as fractions p/q, which other programs do "
        "not read; --digits 15 writes decimals\n");
    EXPECT_EQ(run("oplus sum square.wkt triangle.dat --digits 15 --format " + format).out.find('/'),
              std::string::npos);
  }
  expect_output("oplus --quiet sum square.wkt triangle.dat -o s.geojson", "");
  // Decimals that end are no fractions, and .dat is the format of programs that read fractions.
  put("half.dat", "3\n0 0\n0.5 0\n0 1/8\n");
  for (const std::string command : {"sum half.dat square.wkt -o s.wkt", "sum square.wkt square.wkt",
                                    "sum square.wkt triangle.dat -o s.dat"})
    EXPECT_EQ(run("oplus " + command).err, "") << command;
}

TEST_F(Sum, is_rounded_to_a_grid_and_says_so) {
  for (const std::string option :
       {"--digits 2", "--grid 0.01", "--grid 1/100", "--grid 1e-2 --side nearest"}) {
    const Ran ran = run("oplus sum square.wkt triangle.dat " + option, 0);
    EXPECT_EQ(ran.out, "POLYGON ((0 0, 2 0, 2 1, 1 1.33, 0 1.33, 0 0))\n");
    EXPECT_EQ(ran.err,
              "oplus: rounded to multiples of 0.01, its boundary moved by at most 0.00707107\n");
  }
  const Ran contain = run("oplus sum square.wkt triangle.dat --grid 0.5 --side contain");
  EXPECT_EQ(contain.out, "POLYGON ((0 0, 2.5 0, 2.5 1.5, 0 1.5, 0 0))\n");
  EXPECT_EQ(contain.err,
            "oplus: rounded to multiples of 0.5, it contains the exact one, and differs from it "
            "within 0.707107 of its boundary\n");
  const Ran contained = run("oplus sum square.wkt triangle.dat --grid 0.5 --side contained");
  EXPECT_TRUE(has(contained.err, "it is contained in the exact one")) << contained.out;
  // Nothing had to be rounded.
  expect_output("oplus sum square.wkt square.wkt --grid 0.5 --side contain", doubled_square);
}

TEST_F(Sum, that_is_rounded_is_valid_and_says_what_changed) {
  put("thin.wkt", "POLYGON ((0 0, 0.25 0, 9 5, 0 0))");
  put("notch.wkt", "POLYGON ((0 0, 4 0, 4 4, 2 0.25, 0 4, 0 0))");
  put("point.wkt", "POLYGON ((0 0, 0.25 0, 0.25 0.25, 0 0))");
  for (const auto& [command, expected] : std::map<std::string, std::string>{
           {"reflect thin.wkt", "; 1 component vanished\n"},
           {"reflect notch.wkt", "; 1 component came apart\n"},
           {"sum square.wkt notch.wkt", "moved by at most 0.707107\n"},
           {"sum frame.wkt point.wkt --open -o s.geojson", "moved by at most 0.707107\n"}}) {
    const Ran ran = run("oplus " + command + " --digits 0", 0);
    EXPECT_EQ(ran.lines_of_err(), 1) << ran.err;
    EXPECT_TRUE(has(ran.err, expected)) << command << content("s.geojson");
    EXPECT_EQ(run("oplus --quiet " + command + " --digits 0").err, "");
    run("oplus " + command + " --digits 0 >t.wkt && oplus reflect " +
            (command.ends_with("json") ? "s.geojson" : "t.wkt"),
        0);
  }
}

TEST_F(Sum, refuses_grids_that_are_none) {
  const std::string command = "oplus sum square.wkt triangle.dat -o s.wkt ";
  expect_refusal(command + "--grid 0", "--grid takes a step above 0, not '0'");
  expect_refusal(command + "--grid -1", "--grid takes a step above 0");
  expect_refusal(command + "--grid abc", "--grid: 'abc' is not a number");
  expect_refusal(command + "--grid 1/0", "denominator 0");
  expect_refusal(command + "--side contain", "--side is for rounded output");
  expect_refusal(command + "--grid 1 --side left", "--side");
  expect_refusal(command + "--grid 1 --digits 2", "give one of the two");
  expect_refusal(command + "--grid 1 --certificate c", "--certificate is for exact results");
  expect_refusal(command + "--digits 1 --certificate c", "--certificate is for exact results");
  EXPECT_EQ(files().count("s.wkt") + files().count("c"), 0U);
}

TEST_F(Sum, in_wkb_is_read_again) {
  expect_output("oplus sum frame.wkt slider.wkt --open -o s.wkb", "");
  EXPECT_TRUE(content("s.wkb").starts_with("0107000000"));
  expect_output("oplus sum frame.wkt slider.wkt --open -o s.wkt && oplus compare s.wkb s.wkt",
                "equal\n");
  // In bytes, as other programs write it.
  put("bytes.py", "import sys; sys.stdout.buffer.write(bytes.fromhex(sys.stdin.read()))");
  expect_output(
      "oplus sum square.wkt square.wkt --format wkb | python3 bytes.py >b.wkb; "
      "oplus reflect b.wkb | oplus reflect -",
      doubled_square);
  expect_refusal("oplus sum square.wkt triangle.dat --format wkb",
                 "WKB holds doubles, and the coordinate 4/3 is not exactly one; --grid 1/1048576");
  run("oplus sum square.wkt triangle.dat --format wkb --grid 1/1024", 0);
}

TEST_F(Sum, takes_the_format_from_the_ending) {
  for (const std::string file : {"s.dat", "s.wkt", "s.geojson"})
    expect_output("oplus sum square.wkt square.wkt -o " + file, "");
  EXPECT_EQ(content("s.dat"), "4\n0 0\n2 0\n2 2\n0 2\n");
  EXPECT_EQ(content("s.wkt"), doubled_square);
  const auto json = nlohmann::json::parse(content("s.geojson"));
  EXPECT_EQ(json.at("type"), "Polygon");
  EXPECT_EQ(json.at("coordinates").at(0).size(), 5U);
}

TEST_F(Sum, takes_the_format_that_is_asked_for) {
  expect_output("oplus sum square.wkt square.wkt --format dat", "4\n0 0\n2 0\n2 2\n0 2\n");
  expect_output("oplus sum square.wkt square.wkt --format dat -o any.name", "");
  EXPECT_EQ(content("any.name"), "4\n0 0\n2 0\n2 2\n0 2\n");
}

TEST_F(Sum, reads_standard_input) {
  const std::string expected = run("oplus sum square.wkt triangle.dat").out;
  expect_output("oplus --quiet sum - triangle.dat <square.wkt", expected);
  expect_output("oplus --quiet sum square.wkt - <triangle.dat", expected);
  expect_refusal("oplus sum - - <square.wkt", "standard input");
}

TEST_F(Sum, dat_cannot_hold_low_dimensional_features) {
  expect_refusal("oplus sum frame.wkt plug.wkt --open -o s.dat", ".wkt");
  expect_refusal("oplus sum frame.wkt slider.wkt --open --format dat --svg s.svg --origins o.json",
                 ".wkt");
  run("oplus sum frame.wkt plug.wkt -o s.dat", 0);
}

TEST_F(Sum, every_engine_finds_the_same) {
  for (const std::string other : {"plug.wkt", "slider.wkt", "triangle.dat", "frame.wkt"}) {
    for (const std::string open : {"", " --open"}) {
      const std::string command = "oplus sum frame.wkt " + other + open;
      const Ran ran = run(command + " --origins default.json", 0);
      for (const std::string how :
           {"--engine slide", "--engine rca", "--engine loops", "--engine winding",
            "--engine oracle", "--threads 0", "--threads 1", "--threads 2", "--threads 7"}) {
        EXPECT_EQ(run(command + " --origins o.json " + how).out, ran.out) << command << how;
        EXPECT_EQ(content("default.json"), content("o.json")) << command << how;
      }
      for (const std::string hole_test : {"bvh", "sweep", "naive", "ray"})
        EXPECT_EQ(run(command + " --engine rca --collision-test " + hole_test).out, ran.out)
            << command << hole_test;
    }
  }
  expect_refusal("oplus sum square.wkt square.wkt --engine none", "--engine");
  expect_refusal("oplus sum square.wkt square.wkt --collision-test none", "--collision-test");
  // Its name of before.
  expect_output("oplus sum square.wkt square.wkt --engine rca --hole-test ray",
                run("oplus sum square.wkt square.wkt").out);
  expect_refusal("oplus sum square.wkt square.wkt --engine oracle --collision-test ray",
                 "--collision-test is unsupported by the engine oracle");
  expect_refusal("oplus sum square.wkt square.wkt --collision-test ray",
                 "--collision-test is unsupported by the engine slide");
  expect_refusal("oplus sum square.wkt square.wkt --engine rca --threads 2",
                 "--threads is unsupported by the engine rca");
  expect_refusal("oplus sum square.wkt square.wkt --threads -1", "--threads");
  expect_refusal("oplus sum square.wkt square.wkt --threads 1025", "--threads");
}

TEST_F(Sum, origins_are_sums_along_the_edge) {
  run("oplus sum square.wkt triangle.dat --origins o.json");
  const auto list = nlohmann::json::parse(content("o.json"));
  ASSERT_EQ(list.size(), 5U);
  // Along the bottom run the bottom of each summand, from the corner of the other.
  const auto& bottom = list.at(0);
  EXPECT_EQ(bottom.at("kind"), "outer");
  EXPECT_EQ(bottom.at("from"), nlohmann::json({"0", "0"}));
  EXPECT_EQ(bottom.at("to"), nlohmann::json({"2", "0"}));
  ASSERT_EQ(bottom.at("origins").size(), 2U);
  // The slanted edge is the triangle's, at the square's corner (1, 1).
  const auto& slanted = list.at(2);
  EXPECT_EQ(slanted.at("from"), nlohmann::json({"2", "1"}));
  ASSERT_EQ(slanted.at("origins").size(), 1U);
  const auto& origin = slanted.at("origins").at(0);
  EXPECT_EQ(
      origin.at("edge"),
      nlohmann::json(
          {{"of", "Q"}, {"chain", 0}, {"leaves", 1}, {"from", {"1", "0"}}, {"to", {"0", "1/3"}}}));
  EXPECT_EQ(origin.at("vertex"),
            nlohmann::json({{"of", "P"}, {"chain", 0}, {"index", 2}, {"at", {"1", "1"}}}));
}

TEST_F(Sum, stats_are_lines_of_name_and_value) {
  const Ran ran = run("oplus sum frame.wkt plug.wkt --open --engine rca --stats", 0);
  for (const std::string line : {"vertices of P: 8\n",
                                 "vertices of Q: 4\n",
                                 "segments of the convolution: 24\n",
                                 "segments of the reduced convolution: 12\n",
                                 "convolution cycles: ",
                                 "steps to trace them: ",
                                 "arrangement edges: ",
                                 "arrangement faces: ",
                                 "hole tests: ",
                                 "tests of low-dimensional features: ",
                                 "seconds for cycles: ",
                                 "outer chains: 1\n",
                                 "holes: 0\n",
                                 "dangling edges: 0\n",
                                 "isolated vertices: 1\n",
                                 "area: 36\n",
                                 "seconds for reading: ",
                                 "seconds for validation: ",
                                 "seconds for counting the convolution: ",
                                 "seconds for the sum: ",
                                 "seconds for the region: ",
                                 "seconds for the certificate: ",
                                 "seconds for the picture: ",
                                 "seconds for writing: ",
                                 "seconds: ",
                                 "peak memory in kilobytes: "})
    EXPECT_TRUE(has("\n" + ran.err, "\n" + line));

  const Ran by_default = run("oplus sum frame.wkt plug.wkt --open --stats");
  for (const std::string line :
       {"bits of a coordinate: 3\n", "free pieces of segments: ", "probes: ", "pairs of boxes: ",
        "pairs of edges decided by doubles: ", "in integers of 64 bits: ",
        "in integers of 128 bits: 0\n", "in integers of GMP: 0\n", "isolated vertices: 1\n"})
    EXPECT_TRUE(has("\n" + by_default.err, "\n" + line));
}

TEST_F(Sum, stats_show_the_published_arrangement_sizes) {
  const std::string data = data_folder();
  for (const auto& [name, edges] :
       {std::pair{"fork", "6154"}, std::pair{"comb", "579"}, std::pair{"stars", "791"}}) {
    const std::string pair = data + "/" + name;
    const Ran ran = run("oplus sum '" + pair + "_part1.dat' '" + pair +
                        "_part2.dat' --engine rca --stats -o s.wkt");
    EXPECT_TRUE(has(ran.err, "arrangement edges: " + std::string(edges) + "\n"));
  }
}

TEST_F(Sum, svg_is_a_picture_of_everything) {
  expect_output("oplus sum frame.wkt plug.wkt --open --svg s.svg -o s.wkt", "");
  EXPECT_NO_THROW(parsed(content("s.svg")));
  for (const std::string kind :
       {"summand-p", "summand-q", "convolution", "reduced-convolution", "sum", "isolated-vertices"})
    EXPECT_TRUE(has(content("s.svg"), "class=\"" + kind + "\""));
}

TEST_F(Sum, svg_is_without_convolutions_that_nobody_could_see) {
  run("oplus gen star --n 200 --summand P -o p.wkt");
  run("oplus gen star --n 200 --summand Q -o q.wkt");
  const Ran ran = run("oplus sum p.wkt q.wkt --svg s.svg -o s.wkt");
  EXPECT_TRUE(
      has(ran.err, "oplus: the picture is without convolutions of more than 20000 segments\n"));
  EXPECT_TRUE(has(content("s.svg"), "class=\"summand-p\""));
  EXPECT_TRUE(has(content("s.svg"), "class=\"sum\""));
  EXPECT_EQ(content("s.svg").find("class=\"convolution\""), std::string::npos);
}

TEST_F(Sum, empty_summand) {
  for (const std::string engine : {"rca", "loops", "winding", "oracle"}) {
    const Ran ran =
        run("oplus sum empty.wkt square.wkt --open --svg s.svg --origins o.json --stats --engine " +
                engine,
            0);
    EXPECT_EQ(ran.out, "POLYGON EMPTY\n");
    EXPECT_EQ(content("o.json"), "[]\n");
  }
}

TEST_F(Sum, refuses_invalid_regions) {
  put("repeated.dat", "6\n2 3\n1 1\n2 3\n0 0\n5 0\n5 5\n");
  put("bow.wkt", "POLYGON ((0 0, 1 1, 1 0, 0 1, 0 0))");
  put("noise.dat", "\x01\x02nonsense");
  expect_refusal("oplus sum repeated.dat square.wkt -o s.wkt", "repeated.dat");
  expect_refusal("oplus sum square.wkt bow.wkt -o s.wkt", "bow.wkt");
  expect_refusal("oplus sum noise.dat square.wkt", "noise.dat");
  expect_refusal("oplus sum missing.dat square.wkt", "missing.dat");
  expect_refusal("oplus sum . square.wkt", "oplus: ");
  expect_refusal("oplus sum /dev/null square.wkt", "/dev/null");
}

TEST_F(Sum, refuses_impossible_commands) {
  expect_refusal("oplus", "a command is needed");
  expect_refusal("oplus add square.wkt square.wkt", "oplus: ");
  expect_refusal("oplus sum", "oplus sum --help");
  expect_refusal("oplus sum square.wkt", "Q");
  expect_refusal("oplus sum square.wkt square.wkt square.wkt", "square.wkt");
  expect_refusal("oplus sum square.wkt square.wkt --digits -1", "--digits");
  expect_refusal("oplus sum square.wkt square.wkt --digits many", "--digits");
  expect_refusal("oplus sum square.wkt square.wkt --digits 99999999999999999999", "--digits");
  expect_refusal("oplus sum square.wkt square.wkt --format svg", "--format");
  expect_refusal("oplus sum square.wkt square.wkt -o sum.shape", "sum.shape");
  expect_refusal("oplus sum square.wkt square.wkt -o noending", "noending");
}

TEST_F(Sum, refuses_outputs_that_cannot_be_written) {
  run("mkdir taken.wkt");
  expect_refusal("oplus sum square.wkt square.wkt -o missing/s.wkt", "missing");
  expect_refusal("oplus sum square.wkt square.wkt -o taken.wkt", "folder");
  expect_refusal("oplus sum square.wkt square.wkt -o square.wkt/s.wkt", "square.wkt");
  expect_refusal("oplus sum square.wkt square.wkt -o ''", "oplus: ");
  expect_refusal("oplus sum square.wkt square.wkt --svg missing/s.svg", "missing");
  expect_refusal("oplus sum square.wkt square.wkt -o s.wkt --origins missing/o.json", "missing");
  expect_refusal("oplus sum square.wkt square.wkt -o s.wkt --svg ./s.wkt", "two outputs");
  expect_refusal("oplus sum square.wkt square.wkt --svg -", "two outputs");
}

TEST_F(Sum, leaves_all_of_its_files_or_none) {
  const std::string sum = "oplus sum square.wkt square.wkt -o s.wkt ";
  for (const std::string option : {"--svg", "--origins", "--certificate", "--stats-json"})
    expect_refusal(sum + option + " /dev/full", "cannot write /dev/full");
  expect_refusal(sum + "--svg s.svg --origins - >/dev/full", "cannot write standard output");
  expect_refusal("oplus nfp square.wkt square.wkt -o s.wkt --svg /dev/full", "/dev/full");
  expect_refusal("oplus verify square.wkt square.wkt full.wkt --svg s.svg >/dev/full",
                 "standard output");
  expect_refusal("oplus repair square.wkt -o s.wkt --json >/dev/full", "standard output");
  EXPECT_EQ(
      run(sum + "--svg s.svg --origins o.json --certificate s.cert --stats-json t.json").exit_code,
      0);
  for (const std::string file : {"s.wkt", "s.svg", "o.json", "s.cert", "t.json"})
    EXPECT_TRUE(files().contains(file)) << file;
}

TEST_F(Sum, says_that_standard_output_cannot_be_written) {
  expect_refusal("oplus sum square.wkt square.wkt >&-", "standard output");
  expect_refusal("oplus sum square.wkt square.wkt >/dev/full", "standard output");
  expect_refusal("oplus --help >/dev/full", "standard output");
  expect_refusal("oplus sum --help >&-", "standard output");
  expect_refusal("oplus --version >/dev/full", "standard output");
}

TEST_F(Sum, a_closed_pipe_ends_the_program_quietly) {
  const std::string pipe = "rm -f ../pipe; mkfifo ../pipe; exec 3<>../pipe 4>../pipe 3>&-; ";
  expect_output(pipe + "oplus sum square.wkt square.wkt >&4", "", 128 + SIGPIPE);
  // Even where the signal was ignored.
  expect_output("trap '' PIPE; " + pipe + "oplus --help >&4", "", 128 + SIGPIPE);
  expect_output(
      "oplus-check theorems | head -1 >first; oplus-check theorems >all; "
      "head -1 all | cmp - first",
      "");
}

TEST_F(Sum, a_closed_standard_output_is_not_mistaken_for_a_file) {
  expect_output("oplus sum square.wkt square.wkt -o s.wkt >&- <&-", "");
  EXPECT_EQ(content("s.wkt"), doubled_square);
}

TEST_F(Sum, writes_to_a_device_and_leaves_it_one) {
  run("oplus sum square.wkt square.wkt --format wkt -o /dev/null", 0);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(Sum, replaces_a_file) {
  run("oplus sum square.wkt square.wkt -o square.wkt", 0);
  EXPECT_EQ(content("square.wkt"), doubled_square);
}

TEST_F(Sum, files_may_be_named_as_subcommands) {
  for (const std::string name : {"sum", "draw"}) put(name, content("square.wkt"));
  expect_output("oplus sum sum draw", doubled_square);
}

}  // namespace
}  // namespace oplus
