// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace oplus {

/// Some lines of an input.
struct LineBatch {
  std::string text;            ///< with the ends of the lines; that of the last may be missing
  std::size_t first_line = 1;  ///< its number, from one
};

/// Reads an input in batches of lines, each as soon as it is there, so that whoever writes into a pipe may wait
/// for the results of a line. Lines may have any length. A byte order mark is left out.
class LineBatches {
 public:
  /// `path` may be "-", standard input. Throws InvalidInput where it cannot be opened.
  explicit LineBatches(const std::string& path);
  LineBatches(const LineBatches&) = delete;
  LineBatches& operator=(const LineBatches&) = delete;
  ~LineBatches();

  /// What messages call the input.
  const std::string& name() const { return name_; }

  /// Returns the next lines, or none at the end of the input, or where is_stopping() returns true while
  /// the input has none. Throws InvalidInput where the input cannot be read.
  std::optional<LineBatch> next(const std::function<bool()>& is_stopping = {});

  /// The number of bytes that were returned, and that of all; 0 where that is unknown, as of a pipe.
  std::size_t bytes_done() const { return bytes_done_; }
  std::size_t bytes() const { return bytes_; }

 private:
  /// Returns begin_ if there is no batch yet.
  std::size_t end_of_batch();
  /// Returns false if nothing more is wanted.
  bool read_more(const std::function<bool()>& is_stopping);

  std::string name_;
  int descriptor_;
  std::string buffer_;
  std::size_t begin_ = 0;    ///< of what was not returned yet
  std::size_t scanned_ = 0;  ///< there is no end of a line between begin_ and here
  bool is_at_start_ = true;
  bool is_at_end_ = false;
  std::size_t line_ = 1;  ///< of begin_
  std::size_t bytes_done_ = 0;
  std::size_t bytes_ = 0;
};

/// Calls visit(line, number) for each line of a batch, without the end of the line.
template <typename Visit>
void each_line(const LineBatch& batch, const Visit& visit) {
  std::string_view rest = batch.text;
  for (std::size_t number = batch.first_line; !rest.empty(); ++number) {
    const std::size_t end = rest.find('\n');
    std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    visit(line, number);
  }
}

}  // namespace oplus
