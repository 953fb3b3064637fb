// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/outputs.hpp"

#include <unistd.h>

#include <system_error>

#include "checked/cli/command_line/progress.hpp"
#include "checked/cli/usage_error.hpp"

namespace oplus {

CommandOutput::CommandOutput(const std::string& path, OutputFile::Regular regular) : path_(path) {
  // Both would be on one terminal.
  if (path == "-" && isatty(STDOUT_FILENO) != 0) ShownStep::hide_all();
  attempt([&] { file_.emplace(path, regular); });
}

void CommandOutput::write(std::string_view text) {
  attempt([&] { file_->write(text); });
}

void CommandOutput::finish() {
  attempt([&] { file_->finish(); });
}

template <typename Work>
void CommandOutput::attempt(const Work& work) const {
  try {
    work();
  } catch (const std::system_error& error) {
    throw UsageError("cannot write " + (path_ == "-" ? "standard output" : path_) + ": " +
                     error.code().message());
  }
}

void Outputs::write(const std::vector<OutputTo>& texts) {
  for (const bool is_regular : {true, false}) {
    for (const auto& [path, text] : texts) {
      if (OutputFile::is_replaced(path) != is_regular) continue;
      outputs_.emplace_back(path).write(text);
    }
  }
}

void Outputs::finish() {
  for (CommandOutput& output : outputs_) output.finish();
  outputs_.clear();
}

void write_texts(const std::vector<OutputTo>& texts) {
  Outputs outputs;
  outputs.write(texts);
  outputs.finish();
}

void write_text(const std::string& path, const std::string& text) { write_texts({{path, text}}); }

}  // namespace oplus
