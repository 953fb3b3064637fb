// SPDX-License-Identifier: MIT
#pragma once

#include_next <unistd.h>
#include <wchar.h>

inline int access(const wchar_t* path, int how) { return _waccess(path, how); }

inline int unlink(const wchar_t* path) { return _wunlink(path); }

inline ssize_t write(int descriptor, const void* data, size_t size) {
  constexpr size_t most = 1 << 30;
  return write(descriptor, data, static_cast<unsigned>(size < most ? size : most));
}
