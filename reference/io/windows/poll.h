// SPDX-License-Identifier: MIT
#pragma once

#include "system.h"

#define POLLIN 1

struct pollfd {
  int fd;
  short events, revents;
};

/// Waits for one descriptor: 0 where it is a pipe that stays open and empty so many milliseconds, else 1.
inline int poll(pollfd* input, unsigned long /*one*/, int milliseconds) {
  const HANDLE handle = handle_of(input->fd);
  DWORD bytes = 1;
  for (int waited = 0; GetFileType(handle) == FILE_TYPE_PIPE; waited += 10) {
    if (!PeekNamedPipe(handle, nullptr, 0, nullptr, &bytes, nullptr) || bytes > 0) return 1;
    if (waited >= milliseconds) return 0;
    Sleep(10);
  }
  return 1;
}
