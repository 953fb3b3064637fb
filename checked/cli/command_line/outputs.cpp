// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/command_line/outputs.hpp"

#include <unistd.h>

#include <system_error>
#include <tuple>

#include "checked/cli/command_line/progress.hpp"
#include "checked/cli/usage_error.hpp"

namespace oplus {

namespace {

template <typename Work>
void attempt(const std::string& path, const Work& work) {
  try {
    work();
  } catch (const std::system_error& error) {
    throw UsageError("cannot write " + (path == "-" ? "standard output" : path) + ": " +
                     error.code().message());
  }
}

}  // namespace

void Outputs::write(const std::vector<OutputTo>& texts) {
  for (const bool is_regular : {true, false}) {
    for (const auto& [path, text] : texts) {
      if (OutputFile::is_replaced(path) != is_regular) continue;
      // Both would be on one terminal.
      if (path == "-" && isatty(STDOUT_FILENO) == 1) ShownStep::hide_all();
      attempt(path, [&, &path = path, &text = text] {
        files_.emplace_back(std::piecewise_construct, std::tie(path), std::tie(path));
        files_.back().second.write(text);
      });
    }
  }
}

void Outputs::finish() {
  for (auto& [path, file] : files_) attempt(path, [&file = file] { file.finish(); });
  files_.clear();
}

void write_text(const std::string& path, const std::string& text) {
  Outputs outputs;
  outputs.write({{path, text}});
  outputs.finish();
}

}  // namespace oplus
