// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/algorithm/string/trim.hpp>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "properties/compare/peers/method.hpp"
#include "properties/runner/child_process.hpp"
#include "properties/runner/temporary_folder.hpp"
#include "reference/chains/region_of.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"
#include "tests/bench/engine.hpp"

namespace oplus {

namespace {

/// What programs read and write.
struct Files {
  std::shared_ptr<TemporaryFolder> folder;
  std::string p, q, sum, certificate;
};

using Command = std::vector<std::string>;

EndedProcess ended_well(const Command& command) {
  EndedProcess ended = run_program(command, {.is_quiet = true});
  if (ended.how != EndedProcess::How::exited || ended.code != 0)
    throw std::runtime_error(command[0] + " ended with code " + std::to_string(ended.code) + ": " +
                             boost::trim_copy(ended.output + ended.errors));
  return ended;
}

Command sum_of(const Files& files) {
  return {program_beside("oplus"), "sum", files.p, files.q, "-o", files.sum};
}

Command sum_with_certificate(const Files& files) {
  Command command = sum_of(files);
  command.insert(command.end(), {"--certificate", files.certificate});
  return command;
}

Command check(const Files& files) {
  return {program_beside("oplus-certified"), files.p, files.q, files.sum, files.certificate};
}

Command proved_sum(const Files& files) {
  return {program_beside("oplus-proved"), "sum", files.p, files.q, "-o", files.sum};
}

/// The size of a file by gzip.
std::size_t zipped_size(const std::string& path) {
  return run_program({"gzip", "-9", "-c", path}, {}).output.size();
}

/// A program that reads P and Q from files and writes their sum into another one, or checks it.
struct WholeCommand {
  using Input = Files;
  using Sum = EndedProcess;

  Command (*command)(const Files& files);
  Format format = Format::dat;
  Command (*before)(const Files& files) = nullptr;  ///< if any: writes what the command reads
  bool rounds = false;

  Files converted(const Summands& pair) const {
    auto folder = std::make_shared<TemporaryFolder>("oplus-bench");
    const auto file = [&](const std::string& name) {
      return (folder->path() / (name + (format == Format::dat ? ".dat" : ".wkt"))).string();
    };
    Files files{folder, file("p"), file("q"), file("sum"), folder->path() / "certificate"};
    if (const Command words = command(files); !std::filesystem::exists(words[0]))
      throw Unsupported("was not built");
    for (const Region* region : {&pair.p, &pair.q})
      if (region->components.size() != 1 || has_hole(*region))
        throw Unsupported("supports one polygon without holes only");
    write_file(files.p, written(pair.p, format));
    write_file(files.q, written(pair.q, format));
    if (before != nullptr) ended_well(before(files));
    return files;
  }

  EndedProcess sum(const Files& files) const { return ended_well(command(files)); }

  void describe(const Files& files, const EndedProcess& ended, Description& description) const {
    description.count("process_mb", static_cast<std::size_t>(ended.peak_mb));
    if (!rounds) description.add(canonical_sum(read_region_file(files.sum).region));
    if (!std::filesystem::exists(files.certificate)) return;
    description.count("certificate_bytes", std::filesystem::file_size(files.certificate));
    description.count("zipped_bytes", zipped_size(files.certificate));
  }
};

using DescribeSums = void(std::istream& sums, Description& description);

/// How one command computes all pairs of a row.
struct ManyPairs {
  std::function<Command(const std::string& pairs, const std::string& sums)> command;
  DescribeSums* describe;
  bool is_of_parts = false;  ///< it reads the row's file of parts, not one of pairs
};

/// All pairs of a row in one command, from a file to a file, by one thread.
class WholeBatch : public PreparedPairs {
 public:
  WholeBatch(const ManyPairs& how, const Row& row, const std::vector<Summands>& pairs)
      : how_(how), command_(how.command(how.is_of_parts ? row.parts : pairs_, sums_)) {
    if (!std::filesystem::exists(command_[0])) throw Unsupported("was not built");
    if (how.is_of_parts) return;
    std::string lines;
    for (const auto& [p, q] : pairs) lines += wkt(p) + '\t' + wkt(q) + '\n';
    write_file(pairs_, lines);
  }

  void compute() override { ended_ = ended_well(command_); }
  void forget() override {}
  bool evaluate() override { return false; }
  void add_stages(std::map<std::string, double>&) const override {}

  void describe(Description& description) const override {
    description.count("process_mb", static_cast<std::size_t>(ended_.peak_mb));
    std::ifstream sums(sums_);
    how_.describe(sums, description);
  }

 private:
  TemporaryFolder folder_{"oplus-bench"};
  std::string pairs_ = folder_.path() / "pairs.tsv";
  std::string sums_ = folder_.path() / "sums";
  ManyPairs how_;
  Command command_;
  EndedProcess ended_;
};

Command batch(const std::string& pairs, const std::string& sums) {
  return {program_beside("oplus"), "batch", pairs, "-o", sums, "--threads", "1", "--quiet"};
}

Command batch_of_parts(const std::string& parts, const std::string& sums) {
  Command command = batch("--parts=" + parts, sums);
  command.insert(command.end(), {"--operation", "nfp"});
  return command;
}

/// Of a no-fit polygon the area alone: places where Q only touches are left out by others.
void describe_batch(std::istream& sums, Description& description) {
  for (std::string line; std::getline(sums, line);) {
    const std::string before = "\"result\": \"";  // WKT, in which nothing is escaped
    const std::size_t begin = line.find(before) + before.size();
    const std::string sum = line.substr(begin, line.find('"', begin) - begin);
    description.add(regularized(read_sum(sum, "sum").sum));
  }
}

/// What `oplus-peer NAME --parts` writes.
template <bool is_rounded>
void describe_peer(std::istream& sums, Description& description) {
  Rational scale, x, y;
  sums >> scale >> std::ws;
  for (std::string line; std::getline(sums, line);) {
    std::vector<Chain> chains;
    std::istringstream path(line);
    for (char command = 0; path >> command;) {
      if (command == 'Z') continue;
      if (command == 'M') chains.emplace_back();
      if (!(path >> x >> y) || chains.empty()) throw std::runtime_error("not a path: " + line);
      chains.back().push_back({x / scale, y / scale});
    }
    description.add(chains, is_rounded);
  }
}

BenchEngine command_engine(const std::string& name, const std::string& what,
                           const WholeCommand& how) {
  return {.name = name,
          .what = what,
          .prepare = each_pair([=](const Row&) { return how; }),
          .rounds = how.rounds,
          .is_ours = name == "oplus-sum" || how.format == Format::wkt,
          .is_of_all_rows = false};
}

BenchEngine batch_engine(const std::string& name, const std::string& what, const ManyPairs& how) {
  return {.name = name,
          .what = what,
          .prepare =
              [=](const Row& row, const std::vector<Summands>& pairs) {
                return std::make_unique<WholeBatch>(how, row, pairs);
              },
          .rounds = how.describe == describe_peer<true>,
          .is_ours = how.describe == describe_batch,
          .is_of_all_rows = false};
}

/// Another library's loop over a file of parts.
BenchEngine peer_of_parts(const std::string& name, const std::string& program,
                          const std::string& method, DescribeSums* describe) {
  return batch_engine(name,
                      "the whole command `" + program + " " + method + " --parts PARTS.wkt NFPS`",
                      {[=](const std::string& parts, const std::string& sums) -> Command {
                         return {program_beside(program), method, "--parts", parts, sums};
                       },
                       describe, true});
}

}  // namespace

std::vector<BenchEngine> command_engines() {
  return {
      command_engine("oplus-sum", "the whole command `oplus sum P.dat Q.dat -o S.dat`", {sum_of}),
      command_engine("sum-certificate",
                     "the whole command `oplus sum P.wkt Q.wkt -o S.wkt --certificate CERTIFICATE`",
                     {sum_with_certificate, Format::wkt}),
      command_engine("oplus-certified",
                     "the whole command `oplus-certified P.wkt Q.wkt S.wkt CERTIFICATE`",
                     {check, Format::wkt, sum_with_certificate}),
      command_engine("oplus-proved", "the whole command `oplus-proved sum P.wkt Q.wkt -o S.wkt`",
                     {proved_sum, Format::wkt}),
      command_engine("cgal-sum",
                     "a whole program (tests/bench/programs/cgal_sum.cpp): reads, "
                     "minkowski_sum_by_reduced_convolution_2, writes exactly",
                     {[](const Files& f) -> Command {
                       return {program_beside("cgal-sum"), f.p, f.q, f.sum};
                     }}),
      command_engine(
          "clipper-sum",
          "a whole program (tests/bench/programs/clipper_sum.cpp): reads, MinkowskiSum, writes",
          {.command = [](const Files& f) -> Command {
             return {program_beside("clipper-sum"), f.p, f.q, f.sum};
           },
           .rounds = true}),
      batch_engine(
          "oplus-batch",
          "the whole command `oplus batch PAIRS.tsv -o SUMS.jsonl --threads 1` for all pairs of a row",
          {batch, describe_batch}),
      batch_engine("oplus-nfp",
                   "the whole command `oplus batch --parts PARTS.wkt --operation nfp -o NFPS.jsonl "
                   "--threads 1`",
                   {batch_of_parts, describe_batch, true}),
      peer_of_parts("cgal-nfp", "oplus-peer", "cgal-reduced", describe_peer<false>),
      peer_of_parts("clipper-nfp", "oplus-peer", "clipper", describe_peer<true>),
      peer_of_parts("cgal-nfp-newest", "oplus-peer-newest", "cgal-reduced", describe_peer<false>),
      peer_of_parts("clipper2-nfp", "oplus-peer-newest", "clipper2", describe_peer<true>),
  };
}

}  // namespace oplus
