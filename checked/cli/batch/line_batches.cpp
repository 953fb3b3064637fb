// SPDX-License-Identifier: GPL-3.0-or-later
#include "checked/cli/batch/line_batches.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "reference/io/input_text.hpp"

namespace oplus {

namespace {

constexpr std::size_t bytes_of_a_batch = 1 << 13;
constexpr std::size_t bytes_at_once = 1 << 16;

}  // namespace

LineBatches::LineBatches(const std::string& path)
    : name_(path == "-" ? "standard input" : path),
      descriptor_(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (descriptor_ < 0)
    throw InvalidInput({name_, 0, 0},
                       std::string("cannot be opened (") + std::strerror(errno) + ")",
                       "a file that can be read");
  struct stat status {};
  if (::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode))
    bytes_ = static_cast<std::size_t>(status.st_size);
}

LineBatches::~LineBatches() {
  if (descriptor_ != STDIN_FILENO && descriptor_ >= 0) ::close(descriptor_);
}

bool LineBatches::read_more(const std::function<bool()>& is_stopping) {
  // So that it ends where nothing more comes from a pipe, and nothing more is wanted.
  for (pollfd input{descriptor_, POLLIN, 0}; ::poll(&input, 1, 100) == 0;)
    if (is_stopping && is_stopping()) return false;
  buffer_.erase(0, begin_);
  scanned_ -= begin_;
  begin_ = 0;
  const std::size_t size = buffer_.size();
  buffer_.resize(size + bytes_at_once);
  const ssize_t count = ::read(descriptor_, buffer_.data() + size, bytes_at_once);
  if (count < 0 && (errno == EINTR || errno == EAGAIN)) {
    buffer_.resize(size);
    return true;
  }
  if (count < 0)
    throw InvalidInput({name_, 0, 0}, std::string("cannot be read (") + std::strerror(errno) + ")",
                       "lines of text");
  buffer_.resize(size + static_cast<std::size_t>(count));
  if (count == 0) is_at_end_ = true;
  if (is_at_start_ && (is_at_end_ || buffer_.size() >= byte_order_mark.size())) {
    is_at_start_ = false;
    buffer_.erase(0, buffer_.size() - without_byte_order_mark(buffer_).size());
  }
  return true;
}

std::size_t LineBatches::end_of_batch() {
  if (is_at_start_) return begin_;
  const std::size_t wanted = std::min(begin_ + bytes_of_a_batch, buffer_.size());
  const std::string_view in_a_batch = std::string_view(buffer_).substr(begin_, wanted - begin_);
  if (const std::size_t last = in_a_batch.rfind('\n'); last != std::string_view::npos)
    return begin_ + last + 1;
  const std::size_t first = buffer_.find('\n', std::max(scanned_, wanted));
  scanned_ = buffer_.size();
  if (first != std::string::npos) return first + 1;
  return is_at_end_ ? buffer_.size() : begin_;
}

std::optional<LineBatch> LineBatches::next(const std::function<bool()>& is_stopping) {
  std::size_t end = end_of_batch();
  while (end == begin_) {
    if (is_at_end_ || !read_more(is_stopping)) return std::nullopt;
    end = end_of_batch();
  }
  LineBatch batch{buffer_.substr(begin_, end - begin_), line_};
  line_ += static_cast<std::size_t>(std::count(batch.text.begin(), batch.text.end(), '\n'));
  bytes_done_ += batch.text.size();
  begin_ = scanned_ = end;
  return batch;
}

}  // namespace oplus
