// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/engine_called.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "properties/compare/corpus.hpp"
#include "properties/compare/engine_failure.hpp"
#include "properties/compare/peers/peer_table.hpp"
#include "properties/runner/finding.hpp"
#include "properties/runner/temporary_folder.hpp"
#include "reference/chains/region_of.hpp"
#include "tests/checked/cli/shell.hpp"

namespace oplus {
namespace {

using Kind = EngineFailure::Kind;
const Region triangle = polygon({{0, 0}, {1, 0}, {0, 1}});
const Region square = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
const Region two{{{{{0, 0}, {1, 0}, {0, 1}}, {}}, {{{5, 5}, {6, 5}, {5, 6}}, {}}}};
const PlanarSet sum_of_both = canonical_sum(polygon({{0, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 2}}));

/// As `oplus-check` has them, but for all the time there is.
const ProcessLimits patient{.seconds = 100'000, .address_space_mb = 4000, .output_mb = 64};

PlanarSet sum(const std::string& engine, const Region& p = triangle, const Region& q = square,
              Boundary boundary = Boundary::closed, const ProcessLimits& limits = patient) {
  return engine_called(engine, limits).value().compute(p, q, boundary, {}).sum;
}

EngineFailure no_sum(const std::string& engine, const ProcessLimits& limits = patient,
                     Boundary boundary = Boundary::closed) {
  try {
    sum(engine, triangle, square, boundary, limits);
  } catch (const EngineFailure& e) {
    return e;
  }
  return {Kind::refused, "it returned a sum", ""};
}

void expect_no_sum(const std::string& command, Kind kind, const std::string& site,
                   const std::string& what, const ProcessLimits& limits = patient,
                   Boundary boundary = Boundary::closed) {
  const EngineFailure found = no_sum("exec:" + command, limits, boundary);
  EXPECT_EQ(name(found.kind()), name(kind)) << command << ": " << found.what();
  EXPECT_EQ(found.site(), site) << command << ": " << found.what();
  EXPECT_TRUE(has(found.what(), what)) << command;
}

TEST(EngineCalled, finds_peers_and_programs_only) {
  const ProcessLimits limits;
  EXPECT_EQ(engine_called("cgal-full", limits).value().name, "cgal-full");
  EXPECT_EQ(engine_called("exec:a b", limits).value().name, "exec:a b");
  for (const char* other : {"", "slide", "exec:", "exec", "cgal"})
    EXPECT_FALSE(engine_called(other, limits)) << other;
}

class EngineCalledAlone : public Shell {};

TEST_F(EngineCalledAlone, says_how_the_program_is_built_that_calls_other_libraries) {
  const Ran ran =
      run("cp \"$(command -v oplus-check)\" . && ./oplus-check diff --engine cgal-full", 2);
  EXPECT_EQ(ran.lines_of_err(), 1) << ran.err;
  EXPECT_TRUE(has(ran.err, "`cmake --build --preset release --target oplus-peer`")) << ran.err;
}

// The programs that stand in for others are the shell's scripts.

constexpr const char* right = "echo 'POLYGON ((0 0, 2 0, 2 1, 1 2, 0 2, 0 0))'; : ";

TEST(ProgramEngine, may_write_its_sum_in_any_format) {
  EXPECT_EQ(sum(std::string("exec:") + right), sum_of_both);
  EXPECT_EQ(sum("exec:printf '5 0 0 2 0 2 1 1 2 0 2\\n' #"), sum_of_both);
  EXPECT_EQ(
      sum("exec:echo '{\"type\": \"Polygon\", \"coordinates\": [[[0,0],[2,0],[2,1],[1,2],[0,2],"
          "[0,0]]]}' #"),
      sum_of_both);
}

TEST(ProgramEngine, gets_both_files_appended_or_where_it_wants_them) {
  const Region p = polygon({{0, 0}, {7, 0}, {0, 7}});
  // What reads a file as the sum gets that summand.
  EXPECT_EQ(sum("exec:cat {q} #"), canonical_sum(square));
  EXPECT_EQ(sum("exec:cat {p} # {p}", p), canonical_sum(p));
  EXPECT_EQ(sum("exec:f() { cat \"$2\"; }; f"), canonical_sum(square));
  EXPECT_EQ(sum("exec:head -q -n 1 '{p}' \"{q}\" | tail -n 1"), canonical_sum(square));
}

TEST(ProgramEngine, may_have_spaces_and_quotes_in_its_name) {
  const TemporaryFolder folder("oplus peers 'quoted' ");
  const std::filesystem::path program = folder.path() / "my \"sum\"";
  std::ofstream(program) << "#!/bin/sh\ncat \"$1\"\n";
  ::chmod(program.c_str(), 0700);
  EXPECT_EQ(sum("exec:" + for_shell(program.string())), canonical_sum(triangle));
}

TEST(ProgramEngine, computes_open_sums_where_it_says_so) {
  expect_no_sum(right, Kind::open_unsupported, "open", "closed sums only", patient, Boundary::open);
  const std::string both = "exec:test {boundary} = open && cat {p} || cat {q}";
  EXPECT_EQ(sum(both, triangle, square, Boundary::open), canonical_sum(triangle));
  EXPECT_EQ(sum(both), canonical_sum(square));
}

TEST(ProgramEngine, leaves_no_files) {
  const EngineFailure said = no_sum("exec:echo {p} >&2; exit 77");
  EXPECT_TRUE(said.site().ends_with("/p.wkt")) << said.site();
  EXPECT_FALSE(std::filesystem::exists(said.site()));
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::path(said.site()).parent_path()));
}

TEST(ProgramEngine, that_writes_nothing_or_garbage_or_half_a_sum_is_unreadable) {
  expect_no_sum("true", Kind::unreadable, "nothing", "wrote nothing");
  expect_no_sum("echo oops >&2 #", Kind::unreadable, "nothing", "wrote nothing");
  expect_no_sum("echo garbage #", Kind::unreadable, "not a sum", "its output:1:1: ");
  expect_no_sum("printf 'POLYGON ((0 0, 2 0, 2' #", Kind::unreadable, "not a sum",
                "the end of the input");
  expect_no_sum("printf '\\0\\377\\0' #", Kind::unreadable, "not a sum", "its output:1:1");
  expect_no_sum("echo 'POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))' #", Kind::unreadable, "not a sum",
                "cross");
}

TEST(ProgramEngine, that_writes_without_end_is_stopped) {
  ProcessLimits limits = patient;
  limits.output_mb = 1;
  expect_no_sum("yes POLYGON #", Kind::unreadable, "too much", "more than 1 MB", limits);
  expect_no_sum("head -c 1000000000 /dev/zero #", Kind::unreadable, "too much", "more than 1 MB",
                limits);
}

TEST(ProgramEngine, that_hangs_is_killed_with_its_children) {
  ProcessLimits limits = patient;
  limits.seconds = 0.2;
  expect_no_sum("exec sleep 100000 #", Kind::hung, "", "after 0.2 s", limits);
  expect_no_sum("sleep 100000 & sleep 100000; : ", Kind::hung, "", "hung", limits);
  expect_no_sum("echo 'POLYGON EMPTY'; cat | sleep 100000 #", Kind::hung, "", "hung", limits);
  // It has ended and left a child that holds its output open.
  EXPECT_EQ(sum(std::string("exec:sleep 100000 & ") + right), sum_of_both);
}

TEST(ProgramEngine, that_wants_more_memory_than_it_has_is_out_of_memory) {
  ProcessLimits limits = patient;
  limits.address_space_mb = 500;
  expect_no_sum("dd if=/dev/zero of=/dev/null count=1 bs=1000M #", Kind::out_of_memory, "",
                "exit code 1", limits);
}

TEST(ProgramEngine, that_fails_has_crashed_at_a_site) {
  expect_no_sum("kill -SEGV $$ #", Kind::crashed, "SIGSEGV", "crashed: SIGSEGV");
  // The shell says of a program that it has run to its end by a signal: 128 and the signal.
  expect_no_sum("sh -c 'kill -FPE $$'; exit $? #", Kind::crashed, "SIGFPE", "SIGFPE");
  expect_no_sum("echo why not >&2; exit 3 #", Kind::crashed, "exit code 3", "exit code 3: why not");
  expect_no_sum("echo \"x: a.c:1: int f(): Assertion \\`y' failed.\" >&2; kill -ABRT $$",
                Kind::crashed, "a.c:1: y", "SIGABRT, a.c:1: y");
  expect_no_sum("no-such-program", Kind::crashed, "exit code 127", "not found");
  // Even after a right answer.
  expect_no_sum(std::string(right) + "; kill -SEGV $$ #", Kind::crashed, "SIGSEGV", "");
}

TEST(ProgramEngine, that_does_not_support_a_pair_says_so_by_its_exit_code) {
  expect_no_sum("echo triangles only >&2; exit 77 #", Kind::refused, "triangles only",
                "triangles only");
  expect_no_sum("exit 77 #", Kind::refused, "", "it gives no reason");
  // Also of open sums, if the program is asked for them.
  expect_no_sum("echo {boundary} >&2; exit 77 #", Kind::refused, "open", "open", patient,
                Boundary::open);
}

TEST(ProgramEngine, that_is_interrupted_is_killed) {
  ProcessLimits limits = patient;
  limits.is_interrupted = [] { return true; };
  try {
    sum("exec:sleep 100000 #", triangle, square, Boundary::closed, limits);
    ADD_FAILURE() << "it returned";
  } catch (const std::system_error& e) {
    EXPECT_EQ(e.code(), std::errc::interrupted);
  }
}

CorpusPair row(const std::string& name) {
  const std::vector<CorpusPair> rows = corpus();
  const auto found = std::ranges::find(rows, name, &CorpusPair::name);
  if (found == rows.end()) throw std::runtime_error("no row " + name);
  return *found;
}

TEST(Peers, compute_sums_of_the_corpus_they_are_known_to_compute) {
  std::map<std::string, std::size_t> right_sums;
  for (const char* name : {"sum_with_a_hole", "decimals_and_fractions",
                           "equally_directed_overlapping_edges", "island_in_a_hole"}) {
    const CorpusPair pair = row(name);
    for (const Engine& peer : peers()) {
      try {
        EXPECT_EQ(sum(peer.name, pair.p, pair.q), pair.closed) << peer.name << ' ' << name;
        ++right_sums[peer.name];
      } catch (const EngineFailure& e) {
        EXPECT_EQ(e.kind(), Kind::refused) << peer.name << ' ' << name << ": " << e.what();
      }
    }
  }
  for (const Engine& peer : peers()) EXPECT_GE(right_sums[peer.name], 1U) << peer.name;
}

/// Where this fails a library has become better: docs/findings.md is to say so.
TEST(Peers, are_as_wrong_as_the_findings_say) {
  const auto by = [](const std::string& peer, const std::string& name) {
    const CorpusPair pair = row(name);
    return std::pair(sum(peer, pair.p, pair.q), pair.closed);
  };
  for (const char* crash :
       {"cgal_full_convolution_crash", "cgal_full_convolution_crash_of_nine_vertices"}) {
    try {
      by("cgal-full", crash);
      ADD_FAILURE() << crash << ": no crash";
    } catch (const EngineFailure& e) {
      EXPECT_EQ(e.kind(), Kind::crashed) << e.what();
    }
    const auto [other, expected] = by("cgal-reduced", crash);
    EXPECT_EQ(other, expected);
  }
  const auto [by_reduced, with_hole] = by("cgal-reduced", "cgal_reduced_convolution_lost_hole");
  EXPECT_EQ(with_hole.holes.size(), 1U);
  EXPECT_EQ(by_reduced.holes.size(), 0U);
  EXPECT_EQ(by_reduced.outer, with_hole.outer);
  for (const char* peer : {"clipper", "boost-polygon"}) {
    const auto [rounded, exact] = by(peer, "clipper_and_boost_polygon_round");
    EXPECT_NE(rounded, exact) << peer;
    EXPECT_EQ(rounded.outer.at(0).size(), exact.outer.at(0).size()) << peer;
  }
}

TEST(Peers, support_what_they_have_an_interface_for) {
  const Region frame{{{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{2, 2}, {2, 7}, {7, 7}, {7, 2}}}}}};
  const std::set<std::string> support_holes = {"cgal-reduced", "cgal-vertical",
                                               "cgal-triangulation", "clipper", "boost-polygon"};
  const auto is_supported = [](const Engine& peer, const Region& p, Boundary boundary) {
    try {
      sum(peer.name, p, triangle, boundary);
      return true;
    } catch (const EngineFailure& e) {
      EXPECT_EQ(name(e.kind()), boundary == Boundary::open ? "open unsupported" : "refused")
          << peer.name << ": " << e.what();
      return false;
    }
  };
  for (const Engine& peer : peers()) {
    EXPECT_TRUE(is_supported(peer, square, Boundary::closed)) << peer.name;
    EXPECT_FALSE(is_supported(peer, square, Boundary::open)) << peer.name;
    EXPECT_EQ(is_supported(peer, frame, Boundary::closed), support_holes.contains(peer.name))
        << peer.name;
    EXPECT_EQ(is_supported(peer, two, Boundary::closed), peer.name == "boost-polygon") << peer.name;
  }
}

TEST(Peers, of_cgal_are_right_where_a_chain_touches_the_inside_of_an_edge) {
  const Region q{{{{{0, -4}, {4, 0}, {0, 0}}, {{{0, 0}, {1, -1}, {1, -3}}}}}};
  const Region p = polygon({{-1, -2}, {0, 0}, {0, 1}});
  const PlanarSet right_sum =
      canonical_sum(polygon({{-1, -6}, {3, -2}, {4, 0}, {4, 1}, {0, 1}, {-1, -2}}));
  for (const char* peer : {"cgal-reduced", "cgal-vertical", "cgal-triangulation"})
    EXPECT_EQ(sum(peer, p, q), right_sum) << peer;
}

}  // namespace
}  // namespace oplus
