// SPDX-License-Identifier: MIT
#pragma once

#include_next <fcntl.h>
#include <io.h>

// As everywhere else: bytes are not changed, and other programs don't inherit files.
#define O_CLOEXEC (_O_BINARY | _O_NOINHERIT)
#define F_GETFD 1

inline int open(const wchar_t* path, int flags, int permissions = 0) { return _wopen(path, flags, permissions); }

/// Whether a descriptor is open; what goes through it is not changed from then on.
inline int fcntl(int descriptor, int /*F_GETFD*/) { return _setmode(descriptor, _O_BINARY) == -1 ? -1 : 0; }
