# SPDX-License-Identifier: GPL-3.0-or-later
# Linux on ARM, of 64 bits, by Debian's compiler, libraries and emulator.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static)
# Headers alone, in the package of the system that compiles.
set(CGAL_DIR /usr/lib/x86_64-linux-gnu/cmake/CGAL)
