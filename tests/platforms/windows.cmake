# SPDX-License-Identifier: GPL-3.0-or-later
# Windows, of 64 bits, by MinGW-w64 and wine. Programs need no other library.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
set(CMAKE_CROSSCOMPILING_EMULATOR /usr/lib/wine/wine64)
# What windows_libraries makes.
file(REAL_PATH ../../build/platforms/windows/prefix prefix BASE_DIRECTORY ${CMAKE_CURRENT_LIST_DIR})
set(CMAKE_FIND_ROOT_PATH ${prefix})
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -L${prefix}/lib")
set(CMAKE_SHARED_LINKER_FLAGS_INIT "-static -L${prefix}/lib")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(Boost_NO_BOOST_CMAKE ON)
