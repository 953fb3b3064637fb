// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/io/output_file.hpp"

namespace oplus {

/// A path, or - for standard output, and the text that goes there.
using OutputTo = std::pair<std::string, std::string>;

/// An OutputFile of a command, whose errors name the path; - is standard output. On a terminal it ends what is shown
/// of the command's steps. All functions throw UsageError.
class CommandOutput {
 public:
  explicit CommandOutput(const std::string& path,
                         OutputFile::Regular regular = OutputFile::Regular::replaced);
  void write(std::string_view text);
  void finish();

 private:
  template <typename Work>
  void attempt(const Work& work) const;

  std::string path_;
  std::optional<OutputFile> file_;
};

/// What a command writes. Its files appear all together, at finish(), or none does. Standard output (-), devices
/// and pipes are written to at once, after all files have been prepared.
class Outputs {
 public:
  /// Throws UsageError, which names the path.
  void write(const std::vector<OutputTo>& texts);

  /// To be called once, after all is written. Throws UsageError.
  void finish();

 private:
  std::list<CommandOutput> outputs_;
};

/// Writes them, all or none; or one, all of the text or nothing. Throw UsageError.
void write_texts(const std::vector<OutputTo>& texts);
void write_text(const std::string& path, const std::string& text);

}  // namespace oplus
