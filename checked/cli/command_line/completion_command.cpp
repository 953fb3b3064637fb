// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <memory>

#include "checked/cli/command_line/completion.hpp"
#include "checked/cli/command_line/program_frame.hpp"

namespace oplus {

namespace {

using Generator = std::string (*)(const DescribedProgram&);

const std::map<std::string, Generator>& generators() {
  static const std::map<std::string, Generator> table = {
      {"bash", bash_completion}, {"fish", fish_completion}, {"zsh", zsh_completion}};
  return table;
}

struct CompletionOptions {
  std::string shell;
  std::string output = "-";
};

}  // namespace

void add_completion_command(CLI::App& program, const Choose& choose) {
  const auto options = std::make_shared<CompletionOptions>();
  CLI::App& command = *program.add_subcommand(
      "completion", "Print the completion of this program for bash, zsh or fish");
  command.add_option("SHELL", options->shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember(generators()))
      ->type_name("NAME");
  command.add_option("-o,--output", options->output, "write it there, not to standard output")
      ->type_name("FILE");
  const std::string& name = program.get_name();
  command.footer("Example:\n  source <(" + name + " completion bash)\n  " + name +
                 " completion zsh -o _" + name + "\n  " + name + " completion fish -o " + name +
                 ".fish\n"
                 "\n"
                 "bash: into ~/.local/share/bash-completion/completions/" +
                 name + ", or source it;\nzsh: as _" + name +
                 " into a folder of $fpath; fish: into ~/.config/fish/completions.\n"
                 "An installed oplus has brought all three along.");
  command.callback([options, &program, choose] {
    choose([options, &program] {
      write_text(options->output, generators().at(options->shell)(described(program)));
    });
  });
}

}  // namespace oplus
