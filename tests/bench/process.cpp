// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace oplus {

namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void fail(int error, const std::string& what) {
  throw std::system_error(error, std::generic_category(), what);
}

/// Starts the program, its standard output going to `output`.
pid_t start(const std::vector<std::string>& command, int output) {
  std::vector<char*> arguments;
  for (const std::string& argument : command)
    arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  pid_t process = 0;
  const int error =
      ::posix_spawn(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) fail(error, command[0]);
  return process;
}

/// Reads until the other end is closed. Returns false where the clock passes the limit.
bool read_lines(int input, double limit, std::string& text) {
  Clock::time_point line_start = Clock::now();
  std::array<char, 4096> part;
  while (true) {
    const double left = limit - std::chrono::duration<double>(Clock::now() - line_start).count();
    if (left <= 0) return false;
    pollfd ready{input, POLLIN, 0};
    const double milliseconds = std::min(std::ceil(left * 1000), 1e9);
    const int polled = ::poll(&ready, 1, static_cast<int>(milliseconds));
    if (polled < 0 && errno != EINTR) fail(errno, "poll");
    if (polled <= 0) continue;
    const ssize_t got = ::read(input, part.data(), part.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return true;
    text.append(part.data(), static_cast<std::size_t>(got));
    if (text.ends_with('\n')) line_start = Clock::now();
  }
}

}  // namespace

EndedProcess run_process(const std::vector<std::string>& command, double limit) {
  std::array<int, 2> ends;
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail(errno, "pipe");
  const auto [to_read, to_write] = ends;
  EndedProcess ended;
  pid_t process = 0;
  try {
    process = start(command, to_write);
  } catch (...) {
    ::close(to_read);
    ::close(to_write);
    throw;
  }
  ::close(to_write);
  const bool in_time = read_lines(to_read, limit, ended.output);
  ::close(to_read);
  if (!in_time) ::kill(process, SIGKILL);

  int status = 0;
  rusage usage{};
  while (::wait4(process, &status, 0, &usage) < 0)
    if (errno != EINTR) fail(errno, "wait4");
  ended.peak_mb = static_cast<double>(usage.ru_maxrss) * 1024 / 1e6;
  if (!in_time) {
    ended.how = EndedProcess::How::over_limit;
  } else if (WIFSIGNALED(status)) {
    ended.how = EndedProcess::How::killed_by_signal;
    ended.code = WTERMSIG(status);
  } else {
    ended.code = WEXITSTATUS(status);
  }
  return ended;
}

std::string own_path() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

void end_with_parent() { ::prctl(PR_SET_PDEATHSIG, SIGKILL); }

double own_peak_mb() {
  // Not getrusage: that starts with what the parent had at the fork.
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kibibytes = 0;
    if (word == "VmHWM:" && status >> kibibytes) return kibibytes * 1024 / 1e6;
  }
  return 0;
}

}  // namespace oplus
