// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/fuzz_program.hpp"

#include <fstream>
#include <iterator>
#include <vector>

#include "properties/runner/child_process.hpp"

namespace oplus {

namespace {

std::vector<std::string> command(const FuzzRun& wanted, const std::filesystem::path& log) {
  std::vector<std::string> all{"/bin/sh",
                               "-c",
                               R"(exec "$@" >"$0" 2>&1)",
                               log.string(),
                               wanted.program.string(),
                               "-seed=" + std::to_string(wanted.seed),
                               "-max_len=" + std::to_string(wanted.longest),
                               "-print_final_stats=1",
                               "-timeout=120",
                               "-rss_limit_mb=4096",
                               "-artifact_prefix=" + (wanted.out / (wanted.target + "-")).string()};
  if (wanted.seconds > 0) all.push_back("-max_total_time=" + std::to_string(wanted.seconds));
  if (wanted.runs > 0) all.push_back("-runs=" + std::to_string(wanted.runs));
  if (std::filesystem::exists(wanted.dictionary))
    all.push_back("-dict=" + wanted.dictionary.string());
  all.push_back(wanted.corpus.string());
  if (std::filesystem::is_directory(wanted.seeds)) all.push_back(wanted.seeds.string());
  return all;
}

}  // namespace

FuzzReport run(const FuzzRun& wanted) {
  std::filesystem::create_directories(wanted.corpus);
  std::filesystem::create_directories(wanted.out);
  const std::filesystem::path log = wanted.out / (wanted.target + ".log");
  const EndedProcess ended = run_program(command(wanted, log), {});
  std::ifstream in(log, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return report_of(wanted.target, text, ended.how == EndedProcess::How::exited && ended.code == 0);
}

}  // namespace oplus
