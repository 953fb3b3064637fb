// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "checked/joined_thread.hpp"

namespace oplus {

/// Work on lots of something by several threads, whose results are passed on in the order of the lots.
/// A lot is not begun as long as one that is far before it is not done, so that memory is bounded.
template <typename Lot, typename Done>
class OrderedWork {
 public:
  struct Steps {
    std::function<std::optional<Lot>()> take;  ///< one call at a time; none: that was all
    std::function<Done(Lot&&)> work;           ///< on any thread
    std::function<void(Done&&)> pass_on;       ///< one call at a time, in order
  };

  explicit OrderedWork(Steps steps) : steps_(std::move(steps)) {}

  /// Does all of it. Calls `watch` on this thread now and then. Throws what a step throws, after all
  /// threads have stopped.
  template <typename Watch>
  void run(unsigned threads, const Watch& watch) {
    window_ = lots_ahead * threads;
    std::vector<JoinedThread> workers;
    workers.reserve(threads);
    try {
      while (workers.size() < threads) {
        {
          const std::lock_guard lock(mutex_);
          ++running_;
        }
        workers.emplace_back([this] { work_until_the_end(); });
      }
    } catch (const std::system_error&) {
      // As many as the system has.
      const std::lock_guard lock(mutex_);
      --running_;
    }
    if (workers.empty()) {
      ++running_;
      work_until_the_end();
    }
    std::unique_lock lock(mutex_);
    while (!ended_.wait_for(lock, std::chrono::milliseconds(50), [&] { return running_ == 0; })) {
      lock.unlock();
      watch();
      lock.lock();
    }
    lock.unlock();
    workers.clear();
    if (thrown_) std::rethrow_exception(thrown_);
  }

  /// Whether no more is wanted: a step that waits for something may return then.
  bool is_stopping() {
    const std::lock_guard lock(mutex_);
    return is_stopping_;
  }

 private:
  static constexpr std::size_t lots_ahead = 16;  ///< for each thread

  void work_until_the_end() noexcept {
    try {
      while (work_on_one()) {
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!thrown_) thrown_ = std::current_exception();
      is_stopping_ = true;
    }
    const std::lock_guard lock(mutex_);
    changed_.notify_all();
    if (--running_ == 0) ended_.notify_all();
  }

  /// Returns whether there may be more to do.
  bool work_on_one() {
    std::optional<Lot> lot;
    std::size_t number = 0;
    {
      const std::lock_guard taking(taking_);
      {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return is_stopping_ || taken_ < passed_on_ + window_; });
        if (is_stopping_ || is_all_taken_) return false;
        number = taken_;
      }
      lot = steps_.take();
      const std::lock_guard lock(mutex_);
      if (!lot) is_all_taken_ = true;
      if (!lot) return false;
      ++taken_;
    }
    Done done = steps_.work(std::move(*lot));
    std::unique_lock lock(mutex_);
    done_.emplace(number, std::move(done));
    // One thread passes on all that is ready; meanwhile others add to it.
    if (is_passing_on_) return true;
    is_passing_on_ = true;
    while (!is_stopping_ && !done_.empty() && done_.begin()->first == passed_on_) {
      auto next = done_.extract(done_.begin());
      lock.unlock();
      steps_.pass_on(std::move(next.mapped()));
      lock.lock();
      ++passed_on_;
      changed_.notify_all();
    }
    is_passing_on_ = false;
    return !is_stopping_;
  }

  Steps steps_;
  std::size_t window_ = 0;
  std::mutex taking_;
  std::mutex mutex_;  ///< of all that follows
  std::condition_variable changed_;
  std::condition_variable ended_;     ///< all of them
  std::map<std::size_t, Done> done_;  ///< and not passed on
  std::size_t taken_ = 0;
  std::size_t passed_on_ = 0;
  std::size_t running_ = 0;
  bool is_all_taken_ = false;
  bool is_passing_on_ = false;
  bool is_stopping_ = false;
  std::exception_ptr thrown_;
};

}  // namespace oplus
