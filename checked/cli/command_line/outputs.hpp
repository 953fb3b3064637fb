// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <list>
#include <string>
#include <utility>
#include <vector>

#include "reference/io/output_file.hpp"

namespace oplus {

/// A path, or - for standard output, and the text that goes there.
using OutputTo = std::pair<std::string, std::string>;

/// What a command writes. Its files appear all together, at finish(), or none does. Standard output (-), devices
/// and pipes are written to at once, after all files have been prepared.
class Outputs {
 public:
  /// Throws UsageError, which names the path.
  void write(const std::vector<OutputTo>& texts);

  /// To be called once, after all is written. Throws UsageError.
  void finish();

 private:
  std::list<std::pair<std::string, OutputFile>> files_;
};

/// Writes one, all of the text or nothing. Throws UsageError.
void write_text(const std::string& path, const std::string& text);

}  // namespace oplus
