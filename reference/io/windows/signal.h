// SPDX-License-Identifier: MIT
#pragma once

#include_next <signal.h>
#include <process.h>

// Signals that are never sent; sigaction() fails of them.
#define SIGHUP 1
#define SIGQUIT 3
#define SIGBUS 7
#define SIGPIPE 13
#define SIGXCPU 24
#define SIGXFSZ 25

#define SA_RESTART 0
#define SA_ONSTACK 0
struct sigaction {
  void (*sa_handler)(int);
  int sa_flags;
};
inline int sigaction(int number, const struct sigaction* now, struct sigaction* before) {
  void (*const handler)(int) = signal(number, now ? now->sa_handler : SIG_DFL);
  if (handler == SIG_ERR) return -1;
  if (before) before->sa_handler = handler;
  if (!now) signal(number, handler);
  return 0;
}

// No signal is held back, and handlers have the stack of the program.
#define SIG_UNBLOCK 0
typedef int sigset_t;
inline int sigemptyset(sigset_t*) { return 0; }
inline int sigaddset(sigset_t*, int) { return 0; }
inline int sigprocmask(int, const sigset_t*, sigset_t*) { return 0; }
struct stack_t {
  void* ss_sp;
  size_t ss_size;
};
inline int sigaltstack(const stack_t*, stack_t*) { return -1; }

/// Requires: one's own process.
inline int kill(int /*process*/, int number) { return raise(number); }
