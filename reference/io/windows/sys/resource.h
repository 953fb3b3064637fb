// SPDX-License-Identifier: MIT
#pragma once

#include "../system.h"

// No limits are known.
#define RLIMIT_DATA 0
#define RLIMIT_NOFILE 1
#define RLIM_INFINITY (~rlim_t{0})
typedef unsigned long long rlim_t;
struct rlimit {
  rlim_t rlim_cur, rlim_max;
};
inline int getrlimit(int, rlimit*) { return -1; }
inline int setrlimit(int, const rlimit*) { return -1; }

#define RUSAGE_SELF 0
struct rusage {
  size_t ru_maxrss;  ///< in kilobytes
};
inline int getrusage(int /*RUSAGE_SELF*/, rusage* used) {
  PROCESS_MEMORY_COUNTERS counters{};
  if (!GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof counters)) return -1;
  used->ru_maxrss = counters.PeakWorkingSetSize / 1024;
  return 0;
}
