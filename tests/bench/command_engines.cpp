// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <utility>

#include "properties/compare/peers/method.hpp"
#include "properties/runner/child_process.hpp"
#include "properties/runner/temporary_folder.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"
#include "tests/bench/engine.hpp"

namespace oplus {

namespace {

/// A program that reads P and Q from files and writes their sum into another one.
struct WholeCommand {
  struct Files {
    std::shared_ptr<TemporaryFolder> folder;
    std::string p, q, sum;
  };
  using Input = Files;
  using Sum = EndedProcess;

  std::vector<std::string> program;   ///< with what stands before P Q
  std::vector<std::string> to_write;  ///< what stands before the file of the sum
  bool rounds;

  Files converted(const Summands& pair) const {
    auto folder = std::make_shared<TemporaryFolder>("oplus-bench");
    const auto file = [&](const std::string& name) { return (folder->path() / name).string(); };
    Files files{folder, file("p.dat"), file("q.dat"), file("sum.dat")};
    for (const Region* region : {&pair.p, &pair.q})
      if (region->components.size() != 1 || has_hole(*region))
        throw Unsupported("supports one polygon without holes only");
    write_file(files.p, written(pair.p, Format::dat));
    write_file(files.q, written(pair.q, Format::dat));
    return files;
  }

  EndedProcess sum(const Files& files) const {
    std::vector<std::string> command = program;
    command.insert(command.end(), {files.p, files.q});
    command.insert(command.end(), to_write.begin(), to_write.end());
    command.push_back(files.sum);
    EndedProcess ended = run_program(command, {});
    if (ended.how != EndedProcess::How::exited || ended.code != 0)
      throw std::runtime_error(program[0] + " ended with code " + std::to_string(ended.code));
    return ended;
  }

  void describe(const Files& files, const EndedProcess& ended, Description& description) const {
    description.count("process_mb", static_cast<std::size_t>(ended.peak_mb));
    if (!rounds) description.add(canonical_sum(read_region_file(files.sum).region));
  }
};

BenchEngine command(const std::string& name, const std::string& what, WholeCommand how) {
  const bool rounds = how.rounds, is_ours = name == "oplus-sum";
  return {.name = name,
          .what = what,
          .prepare = each_pair([how = std::move(how)](const Row&) { return how; }),
          .rounds = rounds,
          .is_ours = is_ours,
          .is_of_all_rows = false};
}

}  // namespace

std::vector<BenchEngine> command_engines() {
  return {
      command("oplus-sum", "the whole command `oplus sum P.dat Q.dat -o S.dat`",
              {{program_beside("oplus"), "sum"}, {"-o"}, false}),
      command("cgal-sum",
              "a whole program (tests/bench/programs/cgal_sum.cpp): reads, "
              "minkowski_sum_by_reduced_convolution_2, writes exactly",
              {{program_beside("cgal-sum")}, {}, false}),
      command("clipper-sum",
              "a whole program (tests/bench/programs/clipper_sum.cpp): reads, MinkowskiSum, writes",
              {{program_beside("clipper-sum")}, {}, true}),
  };
}

}  // namespace oplus
