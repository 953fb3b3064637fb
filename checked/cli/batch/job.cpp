// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/batch/job.hpp"

#include <array>
#include <boost/algorithm/string/join.hpp>
#include <boost/crc.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "checked/cli/command_line/outputs.hpp"
#include "checked/cli/usage_error.hpp"
#include "checked/version.hpp"
#include "reference/io/file_text.hpp"
#include "reference/io/quoting.hpp"

namespace oplus {

namespace {

std::string path_of_job(const std::string& output) { return output + ".oplus-job"; }

/// CRC-64 of ECMA-182, as xz has it.
std::string content_of(const std::string& file) {
  if (!std::filesystem::is_regular_file(file))
    throw UsageError("--resume and --shard take files that can be read again; " + one_line(file) +
                     (std::filesystem::exists(file) ? " is not one" : " does not exist"));
  std::ifstream in(file, std::ios::binary);
  constexpr std::uint64_t all = ~std::uint64_t{0};
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693, all, all, true, true> checksum;
  std::size_t bytes = 0;
  std::array<char, 1 << 16> block;
  while (in.read(block.data(), block.size()), in.gcount() > 0) {
    const auto count = static_cast<std::size_t>(in.gcount());
    checksum.process_bytes(block.data(), count);
    bytes += count;
  }
  if (!in.eof()) throw UsageError(one_line(file) + " cannot be read");
  return std::to_string(bytes) + " bytes, CRC-64 " + std::to_string(checksum.checksum());
}

}  // namespace

Job job_of(std::vector<std::string> options, const std::vector<std::string>& inputs,
           const Shard& shard) {
  Job job{version, std::move(options), {}, shard};
  for (const std::string& input : inputs) job.contents.push_back(content_of(input));
  return job;
}

std::string difference(const Job& job, const Job& other) {
  const auto text = [](const std::vector<std::string>& words) {
    return one_line(boost::algorithm::join(words, " "));
  };
  if (job.options != other.options)
    return "its options are " + text(job.options) + ", not " + text(other.options);
  if (job.contents != other.contents) return "its input has changed";
  if (job.oplus != other.oplus)
    return "it is of version " + one_line(job.oplus) + ", not " + one_line(other.oplus);
  return "";
}

Job read_job(const std::string& output) {
  const std::string path = path_of_job(output);
  if (!std::filesystem::exists(path))
    throw UsageError(one_line(path) + " is missing, which --resume and --shard write beside " +
                     one_line(output));
  try {
    const auto json = nlohmann::json::parse(text_of_file(path));
    Job job{json.at("oplus"), json.at("options"), json.at("contents"), shard_of(json.at("shard"))};
    if (json.contains("bytes")) job.bytes = json.at("bytes").get<std::size_t>();
    return job;
  } catch (const nlohmann::json::exception&) {
    throw UsageError(one_line(path) + " is damaged; expected a line that oplus batch wrote");
  }
}

void write_job(const Job& job, const std::string& output) {
  nlohmann::ordered_json json = {
      {"oplus", job.oplus},
      {"options", job.options},
      {"contents", job.contents},
      {"shard", std::to_string(job.shard.index) + "/" + std::to_string(job.shard.of)}};
  if (job.bytes) json["bytes"] = *job.bytes;
  write_text(path_of_job(output),
             json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace oplus
