// SPDX-License-Identifier: GPL-3.0-or-later
// Boost.Process 1.74 does not suffice: its pipes are inherited by processes that other threads start, and
// waiting with a time limit forks another process and changes how SIGCHLD is handled.
#include "properties/runner/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

namespace oplus {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kept_errors = 1 << 16;

[[noreturn]] void fail(int error, const std::string& what) {
  throw std::system_error(error, std::generic_category(), what);
}

class File {
 public:
  explicit File(int descriptor) : descriptor_(descriptor) {}
  File(File&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  File& operator=(File&&) = delete;
  ~File() { close(); }

  int get() const { return descriptor_; }
  void close() {
    if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  }

 private:
  int descriptor_;
};

struct Pipe {
  File to_read;
  File to_write;

  /// Not inherited by programs that other threads start.
  static Pipe make() {
    std::array<int, 2> ends;
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail(errno, "pipe");
    return {File(ends[0]), File(ends[1])};
  }
};

void limit_resource(int resource, std::size_t value) {
  const rlimit limit{value, value};
  ::setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

void limit_memory(std::size_t limit_mb) {
  // Of this program alone: one with sanitizers reserves terabytes.
  rlimit own{};
  ::getrlimit(RLIMIT_DATA, &own);
  limit_resource(RLIMIT_DATA, own.rlim_max);
  if (limit_mb > 0) limit_resource(RLIMIT_AS, limit_mb * 1'000'000);
}

/// The forked process calls this to become another program. Other threads may have held any lock at
/// the fork, so it allocates nothing. Returns where it could not become that program.
void become(char* const* command, const ProcessLimits& limits, int output, int errors) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  limit_resource(RLIMIT_CORE, 0);
  limit_memory(limits.address_space_mb);
  const int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  if (nothing != STDIN_FILENO) ::close(nothing);
  ::dup2(output, STDOUT_FILENO);
  if (errors >= 0) ::dup2(errors, STDERR_FILENO);
  ::execvp(command[0], command);
}

/// A process that was started and is not yet waited for.
class Child {
 public:
  explicit Child(pid_t process) : process_(process) {
    descriptor_ = static_cast<int>(::syscall(SYS_pidfd_open, process, 0));
    if (descriptor_ >= 0) return;
    const int error = errno;
    kill();
    ::waitpid(process_, nullptr, 0);
    fail(error, "pidfd_open");
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    ::close(descriptor_);
    if (is_waited_for_) return;
    kill();
    ::waitpid(process_, nullptr, 0);
  }

  /// Can be read from when it has ended.
  int descriptor() const { return descriptor_; }

  /// Until it is waited for, no other process has its number.
  void kill() const { ::kill(-process_, SIGKILL); }

  /// Returns its status.
  int wait(rusage& usage) {
    int status = 0;
    while (::wait4(process_, &status, 0, &usage) < 0)
      if (errno != EINTR) fail(errno, "wait4");
    is_waited_for_ = true;
    return status;
  }

 private:
  pid_t process_;
  int descriptor_ = -1;
  bool is_waited_for_ = false;
};

/// Reads what a process writes, until it has ended or passes a limit.
class Listener {
 public:
  Listener(const ProcessLimits& limits, EndedProcess& ended) : limits_(limits), ended_(ended) {}

  /// `errors` may be -1.
  void listen(int output, int errors, const Child& child) {
    for (const int file : {output, errors})
      if (file >= 0) ::fcntl(file, F_SETFL, O_NONBLOCK);
    std::array<pollfd, 3> files{pollfd{output, POLLIN, 0}, pollfd{errors, POLLIN, 0},
                                pollfd{child.descriptor(), POLLIN, 0}};
    const Clock::time_point start = Clock::now();
    while (true) {
      const double left =
          limits_.seconds - std::chrono::duration<double>(Clock::now() - start).count();
      if (left <= 0) return over(EndedProcess::How::over_time, child);
      if (limits_.is_interrupted != nullptr && limits_.is_interrupted())
        return over(EndedProcess::How::interrupted, child);
      const double most = limits_.is_interrupted == nullptr ? 1e9 : 100;
      const double milliseconds = std::min(std::ceil(left * 1000), most);
      if (::poll(files.data(), files.size(), static_cast<int>(milliseconds)) < 0) {
        if (errno == EINTR) continue;
        fail(errno, "poll");
      }
      const bool has_ended = files[2].revents != 0;
      // Processes that it started may still be writing.
      if (has_ended) child.kill();
      if (files[0].revents != 0 && !read_output(output)) files[0].fd = -1;
      if (files[1].revents != 0 && !read_errors(errors)) files[1].fd = -1;
      if (is_over_output()) return over(EndedProcess::How::over_output, child);
      if (has_ended) return read_rest(output, errors, child);
    }
  }

 private:
  void over(EndedProcess::How how, const Child& child) {
    ended_.how = how;
    child.kill();
  }

  bool is_over_output() const {
    return limits_.output_mb > 0 && ended_.output.size() > limits_.output_mb * 1'000'000;
  }

  void read_rest(int output, int errors, const Child& child) {
    while (read_output(output))
      if (is_over_output()) return over(EndedProcess::How::over_output, child);
    while (errors >= 0 && read_errors(errors)) continue;
  }

  /// Returns false where nothing more can be read now.
  bool read_output(int file) { return read_into(ended_.output, file); }

  bool read_errors(int file) {
    if (!read_into(ended_.errors, file)) return false;
    if (ended_.errors.size() > 2 * kept_errors)
      ended_.errors.erase(0, ended_.errors.size() - kept_errors);
    return true;
  }

  static bool read_into(std::string& text, int file) {
    std::array<char, 1 << 16> part;
    ssize_t got = 0;
    do got = ::read(file, part.data(), part.size());
    while (got < 0 && errno == EINTR);
    if (got <= 0) return false;
    text.append(part.data(), static_cast<std::size_t>(got));
    return true;
  }

  const ProcessLimits& limits_;
  EndedProcess& ended_;
};

EndedProcess listened_to(Child& child, int output, int errors, const ProcessLimits& limits) {
  EndedProcess ended;
  Listener(limits, ended).listen(output, errors, child);
  rusage usage{};
  const int status = child.wait(usage);
  ended.peak_mb = static_cast<double>(usage.ru_maxrss) * 1024 / 1e6;
  if (ended.how != EndedProcess::How::exited) return ended;
  if (WIFSIGNALED(status)) {
    ended.how = EndedProcess::How::killed_by_signal;
    ended.code = WTERMSIG(status);
  } else {
    ended.code = WEXITSTATUS(status);
  }
  return ended;
}

}  // namespace

EndedProcess run_program(const std::vector<std::string>& command, const ProcessLimits& limits) {
  std::vector<char*> arguments;
  for (const std::string& argument : command)
    arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  Pipe output = Pipe::make();
  Pipe errors = Pipe::make();
  // Closed when the process becomes the program.
  Pipe failure = Pipe::make();
  const pid_t process = ::fork();
  if (process < 0) fail(errno, "fork");
  if (process == 0) {
    become(arguments.data(), limits, output.to_write.get(),
           limits.is_quiet ? errors.to_write.get() : -1);
    const int error = errno;
    static_cast<void>(::write(failure.to_write.get(), &error, sizeof error) < 0);
    ::_exit(127);
  }
  Child child(process);
  output.to_write.close();
  errors.to_write.close();
  failure.to_write.close();
  int error = 0;
  if (::read(failure.to_read.get(), &error, sizeof error) > 0) fail(error, command.at(0));
  return listened_to(child, output.to_read.get(), limits.is_quiet ? errors.to_read.get() : -1,
                     limits);
}

std::string program_beside(const std::string& name) {
  const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe");
  return (name.empty() ? own : own.parent_path() / name).string();
}

double own_peak_mb() {
  // Not getrusage: it starts with the parent's peak at the fork.
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kibibytes = 0;
    if (word == "VmHWM:" && status >> kibibytes) return kibibytes * 1024 / 1e6;
  }
  return 0;
}

std::string signal_name(int signal) {
  const char* const name = ::sigabbrev_np(signal);
  return name == nullptr ? "signal " + std::to_string(signal) : std::string("SIG") + name;
}

}  // namespace oplus
