// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/compare/engine_called.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "properties/compare/certified_engine.hpp"
#include "properties/compare/crash_site.hpp"
#include "properties/compare/engine_failure.hpp"
#include "properties/compare/peers/peer_table.hpp"
#include "properties/runner/checked_engines.hpp"
#include "properties/runner/finding.hpp"
#include "properties/runner/temporary_folder.hpp"
#include "reference/definitions/convolution.hpp"
#include "reference/io/boundary_name.hpp"
#include "reference/io/reading.hpp"
#include "reference/io/writing.hpp"

namespace oplus {

namespace {

using Kind = EngineFailure::Kind;

constexpr std::string_view exec = "exec:";

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// The line that says why: the last of a traceback of Python's, else the first.
std::string reason_in(const std::string& errors) {
  if (errors.find("Traceback (most recent call last):") == std::string::npos)
    return first_line(errors);
  const std::string lines = errors.substr(0, errors.find_last_not_of('\n') + 1);
  return lines.substr(lines.rfind('\n') + 1);
}

std::string format(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

/// A shell's exit code for a program that a signal ended is 128 and the signal.
constexpr int of_signal = 128;

std::string how_it_ended(const EndedProcess& ended) {
  if (ended.how == EndedProcess::How::killed_by_signal) return signal_name(ended.code);
  constexpr int signals = 32;
  if (ended.code > of_signal && ended.code < of_signal + signals)
    return signal_name(ended.code - of_signal);
  return "exit code " + std::to_string(ended.code);
}

[[noreturn]] void report_failure(const EndedProcess& ended) {
  const std::string said = ended.errors.empty() ? "" : ": " + reason_in(ended.errors);
  const std::string how = how_it_ended(ended);
  if (ended.how == EndedProcess::How::exited) {
    if (ended.code == exit_refused)
      throw EngineFailure(Kind::refused, first_line(ended.errors),
                          said.empty() ? "it gives no reason" : reason_in(ended.errors));
    if (ended.code == exit_no_region)
      throw EngineFailure(Kind::unreadable, first_line(ended.errors),
                          "its result is not the boundary of a region: " +
                              first_line(ended.errors.substr(ended.errors.find('\n') + 1)));
  }
  if (says_out_of_memory(ended.errors))
    throw EngineFailure(Kind::out_of_memory, "", "out of memory: " + how + said);
  const std::string site = crash_site(ended.errors, how);
  throw EngineFailure(
      Kind::crashed, site,
      "crashed: " + (site == how ? how : how + ", " + site) + (site == how ? said : ""));
}

PlanarSet sum_in(const std::string& output) {
  if (output.find_first_not_of(" \t\r\n\v\f") == std::string::npos)
    throw EngineFailure(Kind::unreadable, "nothing", "it wrote nothing");
  try {
    return read_sum(output, "its output").sum;
  } catch (const InvalidInput& e) {
    throw EngineFailure(Kind::unreadable, "not a sum", std::string("unreadable: ") + e.what());
  }
}

PlanarSet sum_by(const EndedProcess& ended, const ProcessLimits& limits) {
  if (ended.how == EndedProcess::How::interrupted)
    throw std::system_error(std::make_error_code(std::errc::interrupted));
  if (ended.how == EndedProcess::How::over_time)
    throw EngineFailure(Kind::hung, "", "hung: no sum after " + format(limits.seconds) + " s");
  if (ended.how == EndedProcess::How::over_output)
    throw EngineFailure(Kind::unreadable, "too much",
                        "it wrote more than " + std::to_string(limits.output_mb) + " MB");
  if (ended.how == EndedProcess::How::killed_by_signal || ended.code != 0) report_failure(ended);
  return sum_in(ended.output);
}

std::filesystem::path folder_that_needs_no_quotes() {
  std::error_code none;
  const std::filesystem::path wanted = std::filesystem::temp_directory_path(none);
  return wanted.is_absolute() && for_shell(wanted) == wanted ? wanted : "/tmp";
}

/// A pair in two files of a folder of its own, which is removed with this object. Their names need no
/// quotes in a shell.
struct SummandFiles {
  SummandFiles(const Region& first, const Region& second) {
    write_file(p, written(first, Format::wkt));
    write_file(q, written(second, Format::wkt));
  }

  const TemporaryFolder folder{"oplus-pair", folder_that_needs_no_quotes()};
  const std::string p = folder.path() / "p.wkt";
  const std::string q = folder.path() / "q.wkt";
};

std::string script_of(const std::string& command, const SummandFiles& files, Boundary boundary) {
  const bool names_files =
      command.find("{p}") != std::string::npos || command.find("{q}") != std::string::npos;
  std::string script = names_files ? command : command + " {p} {q}";
  boost::replace_all(script, "{boundary}", name(boundary));
  boost::replace_all(script, "{p}", files.p);
  boost::replace_all(script, "{q}", files.q);
  return script;
}

EndedProcess run_command(const std::string& command, const SummandFiles& files, Boundary boundary,
                         const ProcessLimits& limits) {
  return run_program({"/bin/sh", "-c", script_of(command, files, boundary)}, limits);
}

EngineFailure open_unsupported() {
  return {Kind::open_unsupported, "open", "it computes closed sums only"};
}

}  // namespace

Engine proved_engine(ProcessLimits limits, std::size_t most_segments) {
  limits.is_quiet = true;
  Engine engine = named_engine("proved", [=](const Region& p, const Region& q, Boundary boundary) {
    if (convolution(p, q).size() > most_segments)
      throw EngineFailure(Kind::refused, "size",
                          "it is asked for sums of at most " + std::to_string(most_segments) +
                              " segments of the convolution");
    const SummandFiles files(p, q);
    std::vector<std::string> command = {program_beside("oplus-proved"), "sum", files.p, files.q};
    if (boundary == Boundary::open) command.emplace_back("--open");
    return sum_by(run_program(command, limits), limits);
  });
  engine.what = "sums by the program oplus-proved, which is proved in Coq";
  return engine;
}

std::vector<Engine> peers(ProcessLimits limits) {
  limits.is_quiet = true;
#ifdef __SANITIZE_ADDRESS__
  limits.address_space_mb = 0;  // the sanitizer is linked with it and needs terabytes
#endif
  std::vector<Engine> all;
  for_each_peer([&](const char* name, const char* what, auto /*there*/) {
    Engine peer =
        named_engine(name, [name, limits](const Region& p, const Region& q, Boundary boundary) {
          if (boundary == Boundary::open) throw open_unsupported();
          const SummandFiles files(p, q);
          return sum_by(run_program({program_beside("oplus-peer"), name, files.p, files.q}, limits),
                        limits);
        });
    peer.what = what;
    all.push_back(std::move(peer));
  });
  return all;
}

Engine program_engine(const std::string& command, ProcessLimits limits) {
  limits.is_quiet = true;
  const bool supports_open = command.find("{boundary}") != std::string::npos;
  return named_engine(
      std::string(exec) + command, [=](const Region& p, const Region& q, Boundary boundary) {
        if (boundary == Boundary::open && !supports_open) throw open_unsupported();
        return sum_by(run_command(command, SummandFiles(p, q), boundary, limits), limits);
      });
}

std::string why_it_cannot_run(const std::string& engine, ProcessLimits limits) {
  const bool is_extracted = engine == "certified" || engine == "proved";
  if (is_extracted && !std::filesystem::exists(program_beside("oplus-" + engine)))
    return "oplus-" + engine + " was not built; it needs Debian's coq and libzarith-ocaml-dev";
  const std::string peer = program_beside("oplus-peer");
  if (find_engine(peers(limits), engine) && !std::filesystem::exists(peer))
    return peer +
           " was not built; `cmake --build --preset release --target oplus-peer` does, and Debian's "
           "package oplus-peer has it";
  if (!engine.starts_with(exec)) return "";
  limits.is_quiet = true;
  const Region square = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const EndedProcess ended = run_command(engine.substr(exec.size()), SummandFiles(square, square),
                                         Boundary::closed, limits);
  // The shell's exit codes for a file that is not executable, and for one that is not found.
  const bool is_missing = ended.code == 126 || ended.code == 127;
  return is_missing && ended.how == EndedProcess::How::exited
             ? how_it_ended(ended) + ", " + first_line(ended.errors)
             : "";
}

std::optional<Engine> engine_called(const std::string& engine, const ProcessLimits& limits) {
  if (engine == "certified") return certified_engine(limits);
  if (engine == "proved") return proved_engine(limits);
  const std::vector<Engine> all = peers(limits);
  if (const Engine* peer = find_engine(all, engine)) return *peer;
  if (engine.starts_with(exec) && engine.size() > exec.size())
    return program_engine(engine.substr(exec.size()), limits);
  return std::nullopt;
}

}  // namespace oplus
