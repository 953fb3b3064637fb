// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/algorithm/string/replace.hpp>
#include <map>

#include "checked/cli/command_line/completion.hpp"
#include "checked/cli/command_line/options.hpp"
#include "checked/cli/command_line/outputs.hpp"
#include "checked/cli/command_line/terminal.hpp"

namespace oplus {

namespace {

// In each script PROGRAM is replaced by the name of the program.

constexpr const char* bash = R"sh(_PROGRAM() {
  local IFS=$'\n' current=${COMP_WORDS[COMP_CWORD]} found files=
  mapfile -t found < <(PROGRAM --complete "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
  [[ $current == = ]] && current=
  case ${found[0]-} in
    :files) files=-f ;;
    :folders) files=-d ;;
  esac
  COMPREPLY=("${found[@]%%$'\t'*}")
  if [[ -n $files ]]; then
    mapfile -t COMPREPLY < <(printf '%s\n' "${COMPREPLY[@]:1}" | sed '/^$/d'; compgen $files -- "$current")
    compopt -o filenames 2>/dev/null
  fi
}
complete -F _PROGRAM PROGRAM
)sh";

constexpr const char* fish = R"sh(function _PROGRAM
  set -l word (commandline -ct)
  set -l found (PROGRAM --complete (commandline -opc)[2..] "$word" 2>/dev/null)
  set -l before (string match -r -- '^--[^=]*=' "$word")
  set -l rest (string replace -r -- '^--[^=]*=' '' "$word")
  switch "$found[1]"
    case :files
      test (count $found) -gt 1; and printf '%s\n' $found[2..]
      __fish_complete_path "$rest" | string replace -r -- '^' "$before"
    case :folders
      __fish_complete_directories "$rest" | string replace -r -- '^' "$before"
    case '*'
      printf '%s\n' $found
  end
end
complete -c PROGRAM -f -a '(_PROGRAM)'
)sh";

constexpr const char* zsh = R"sh(#compdef PROGRAM
_PROGRAM() {
  local -a found
  found=(${(f)"$(PROGRAM --complete "${(@Q)words[2,CURRENT]}" 2>/dev/null)"})
  case ${found[1]-} in
    :files)
      (($#found > 1)) && { local -a rest=("${(@)found[2,-1]/$'\t'/:}"); _describe PROGRAM rest }
      compset -P '--*='; _files ;;
    :folders) compset -P '--*='; _files -/ ;;
    ?*) found=("${(@)found//:/\\:}"); found=("${(@)found/$'\t'/:}"); _describe PROGRAM found ;;
  esac
}
if [[ $funcstack[1] == _PROGRAM ]]; then _PROGRAM "$@"; else compdef _PROGRAM PROGRAM; fi
)sh";

const std::map<std::string, std::string> scripts = {{"bash", bash}, {"fish", fish}, {"zsh", zsh}};

struct CompletionOptions {
  std::string shell;
  std::string output = "-";
};

int print_completion(const CompletionOptions& options) {
  write_text(options.output, boost::algorithm::replace_all_copy(scripts.at(options.shell),
                                                                "PROGRAM", speech().program));
  return 0;
}

}  // namespace

void add_completion_command(Program& program) {
  const auto& [command, options] = program.add(
      "completion", "Print the completion of this program for bash, zsh or fish", print_completion);
  command.option("SHELL NAME", options.shell, "bash, zsh or fish")
      .required()
      .one_of({"bash", "fish", "zsh"});
  command.file("-o,--output", options.output, "write it there, not to standard output");
  const std::string& name = speech().program;
  command.footer("Example:\n  source <(" + name + " completion bash)\n  " + name +
                 " completion zsh -o _" + name + "\n  " + name + " completion fish -o " + name +
                 ".fish\n"
                 "\n"
                 "bash: into ~/.local/share/bash-completion/completions/" +
                 name + ", or source it;\nzsh: as _" + name +
                 " into a folder of $fpath; fish: into ~/.config/fish/completions.\n"
                 "An installation of oplus contains all three.");
}

}  // namespace oplus
