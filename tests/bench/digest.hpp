// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/uuid/detail/sha1.hpp>
#include <string>

namespace oplus {

/// SHA-1 of lines of text.
class Digest {
 public:
  void add(const std::string& line) {
    hash_.process_bytes(line.data(), line.size());
    hash_.process_byte('\n');
  }

  /// 40 digits. Requires: nothing is added after.
  std::string hexadecimal() {
    unsigned int words[5];
    hash_.get_digest(words);
    std::string text;
    for (const unsigned int word : words)
      for (int shift = 28; shift >= 0; shift -= 4)
        text += "0123456789abcdef"[(word >> shift) & 15U];
    return text;
  }

 private:
  boost::uuids::detail::sha1 hash_;
};

}  // namespace oplus
