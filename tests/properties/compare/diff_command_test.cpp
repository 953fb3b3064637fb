// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

/// The last line of a text that starts so, without the start.
std::string last_line_after(const std::string& text, const std::string& start) {
  const std::size_t at = text.rfind(start) + start.size();
  return text.substr(at, text.find('\n', at) - at);
}

class DiffCommand : public Shell {
 protected:
  void SetUp() override {
    Shell::SetUp();
    put("square.dat", "4\n0 0\n1 0\n1 1\n0 1\n");
    put("frame.dat", "4\n0 0\n4 0\n4 4\n0 4\n1\n4\n1 1\n1 3\n3 3\n3 1\n");
  }

  Ran diff(const std::string& options, int exit_code) {
    return run("oplus-check diff " + options, exit_code);
  }
};

TEST_F(DiffCommand, finds_an_operation_by_a_wrong_sum_and_reproduces_it) {
  for (const char* pair : {"square.dat frame.dat", "outside.dat square.dat"}) {
    put("outside.dat", "0\n1\n4\n0 0\n0 4\n4 4\n4 0\n");
    const Ran ran = diff(std::string("--operation nfp --engine 'exec:cat {p} # {boundary}' "
                                     "--shrink-tries 20 --pair ") +
                             pair,
                         1);
    EXPECT_TRUE(has(ran.out, "disagreement on nfp, found in ")) << ran.out;
    EXPECT_TRUE(has(ran.out, "the first is the definition of nfp: "));
    const Ran again = run(last_line_after(ran.out, "  reproduce: "), 1);
    EXPECT_EQ(last_line_after(again.out, " vertices: "), last_line_after(ran.out, " vertices: "));
  }
}

TEST_F(DiffCommand, reproduces_a_failure_by_the_printed_line) {
  run("mkdir 'my programs'");
  put("my programs/sum", "#!/bin/sh\ncat \"$1\"\n");
  run("chmod +x 'my programs/sum'");
  for (const std::string out : {"", "--out 'else where/it'\\''s' ", "--out \"$PWD/found\" "}) {
    const Ran first = diff(
        "--pair square.dat frame.dat --engine \"exec:'./my programs/sum' {p} {q}\" --time-limit 500 "
        "--report r.json --report r.md " +
            out,
        1);
    const std::string line = last_line_after(first.out, "  reproduce: ");
    EXPECT_TRUE(line.starts_with("oplus-check diff ")) << line;
    const Ran again = run(line, 1);
    const std::string kind = last_line_after(first.out, " vertices: ");
    EXPECT_EQ(last_line_after(again.out, " vertices: "), kind);
    EXPECT_EQ(last_line_after(again.out, "they differ at"),
              last_line_after(first.out, "they differ at"));
    const auto report = nlohmann::json::parse(content("r.json"));
    EXPECT_EQ(report.at("counterexamples").at(kind).at("replay"), line);
    EXPECT_TRUE(has(content("r.md"), line));
    // The picture's link is from the folder of the report.
    const std::string link = last_line_after(content("r.md"), "and the sums](<");
    run("test -s \"" + link.substr(0, link.find(">)")) + "\"", 0);
  }
}

TEST_F(DiffCommand, shows_how_it_shrinks) {
  const std::string command =
      "oplus-check diff --pair square.dat frame.dat --engine \"exec:cat {p} #\" --shrink-tries 20";
  const std::string start = "shrinking hole lost: ";
  const Ran plain = run(command);
  EXPECT_TRUE(has(plain.err, start + "12 vertices, 0 pairs tried\n")) << plain.err;
  const Ran on_terminal = run("script -qec '" + command + "' /dev/null");
  EXPECT_TRUE(has(on_terminal.out, "\r" + start + "12 vertices, 0 pairs tried\r"));
  EXPECT_TRUE(has(on_terminal.out, " vertices, 21 pairs tried"));
  EXPECT_FALSE(has(on_terminal.out, start + "12 vertices, 21 pairs tried"));
}

TEST_F(DiffCommand, interrupted_writes_what_was_compared_and_does_not_wait_for_the_engine) {
  // The fifth sum never ends, and tells.
  put("slow",
      "#!/bin/sh\necho >>calls\n[ $(wc -l <calls) -lt 5 ] || { touch waits; exec sleep 100000; }\n"
      "exec oplus sum \"$1\" \"$2\" --format wkt\n");
  for (const std::string signal : {"INT", "TERM"}) {
    const Ran ran = run(
        "rm -f calls waits\n"
        "env --default-signal oplus-check diff --family grid --cases 20 --threads 1 "
        "--engine 'exec:sh ./slow' --time-limit 100000 --memory-limit 0 --report r.md --report r.json --report r.xml & run=$!\n"
        "until [ -e waits ]; do kill -0 $run || exit 99; sleep 0.05; done\n"
        "kill -" +
            signal + " $run\nwait $run",
        5);
    EXPECT_TRUE(has(ran.err, "interrupted: writing the report"));
    EXPECT_TRUE(has(ran.out, "interrupted after 3 of 20 pairs: 3 cases run"));
    EXPECT_TRUE(has(content("r.md"), "interrupted after 3 of 20 pairs**"));
    const auto report = nlohmann::json::parse(content("r.json"));
    EXPECT_EQ(report.at("interrupted"), true);
    EXPECT_EQ(report.at("all").at("ran"), 3);
    EXPECT_TRUE(has(content("r.xml"), "<testcase"));
    const Ran merged = run("oplus-check merge r.json", 2);
    EXPECT_TRUE(has(merged.err, "the shard was interrupted: 3 of 20 pairs"));
  }
}

TEST_F(DiffCommand, ends_at_once_at_the_second_interrupt) {
  run("oplus gen fork --n 300 --seed 1 -o p.dat; oplus gen fork --n 300 --seed 1 --summand Q -o q.dat\n"
      "oplus-check diff --pair p.dat q.dat --largest 1000000000 --threads 1 2>err & run=$!\n"
      // Until it computes: it has had a fifth of a second of processor time.
      "until [ $(cut -d' ' -f14 /proc/$run/stat) -ge 20 ]; do kill -0 $run || exit 99; sleep 0.05; done\n"
      "kill -TERM $run\n"
      "until grep -q 'a second interrupt ends' err; do kill -0 $run || exit 98; sleep 0.05; done\n"
      "kill -TERM $run; wait $run",
      128 + SIGTERM);
  EXPECT_FALSE(files().contains("oplus-findings"));
}

}  // namespace
}  // namespace oplus
