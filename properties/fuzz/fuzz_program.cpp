// SPDX-License-Identifier: GPL-3.0-or-later
#include "properties/fuzz/fuzz_program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>
#include <vector>

namespace oplus {

namespace {

std::vector<std::string> arguments(const FuzzRun& wanted) {
  std::vector<std::string> all{wanted.program.string(),
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

/// Its exit status as waitpid tells it.
int spawn_and_wait(std::vector<std::string> arguments, const std::filesystem::path& log) {
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0644);
  ::posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  pid_t pid = 0;
  const int error = ::posix_spawn(&pid, argv[0], &actions, nullptr, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::system_error(error, std::generic_category(), arguments[0]);
  int status = 0;
  while (::waitpid(pid, &status, 0) < 0)
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitpid");
  return status;
}

}  // namespace

FuzzReport run(const FuzzRun& wanted) {
  std::filesystem::create_directories(wanted.corpus);
  std::filesystem::create_directories(wanted.out);
  const std::filesystem::path log = wanted.out / (wanted.target + ".log");
  const int status = spawn_and_wait(arguments(wanted), log);
  std::ifstream in(log, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return report_of(wanted.target, text, WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

}  // namespace oplus
