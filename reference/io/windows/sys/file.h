// SPDX-License-Identifier: MIT
#pragma once

#include <errno.h>

#include "../system.h"

#define LOCK_EX LOCKFILE_EXCLUSIVE_LOCK
#define LOCK_NB LOCKFILE_FAIL_IMMEDIATELY

/// Locks a byte that no file reaches, since what is locked cannot be read.
inline int flock(int descriptor, unsigned long how) {
  OVERLAPPED last{};
  last.Offset = last.OffsetHigh = 0x7fffffff;
  if (LockFileEx(handle_of(descriptor), how, 0, 1, 0, &last)) return 0;
  errno = GetLastError() == ERROR_LOCK_VIOLATION ? EWOULDBLOCK : ENOSYS;
  return -1;
}
