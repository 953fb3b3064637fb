// SPDX-License-Identifier: MIT
#pragma once

#include <thread>

namespace oplus {

/// A thread that is joined where it is destroyed: std::jthread, which Clang's library has from version 20 on only.
class JoinedThread : public std::thread {
 public:
  using std::thread::thread;
  JoinedThread(JoinedThread&&) = default;
  ~JoinedThread() {
    if (joinable()) join();
  }
};

}  // namespace oplus
