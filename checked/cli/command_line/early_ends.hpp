// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace oplus {

/// From now on, a program that ends early leaves no temporary file and says why:
///  1. a signal that ends it (HUP, INT, QUIT, TERM, XCPU) still does, after its temporary files are removed;
///  2. a file beyond the limit of its size is an error of writing, not the signal XFSZ;
///  3. it takes no more memory than the machine has left now, or than the soft limit RLIMIT_DATA (ulimit -d) says;
///  4. where GMP, or what no one catches, finds too little memory, it ends as invalid input does; GMP has the memory
///     of number_memory.hpp, but for sanitizers.
/// Signals that are handled or ignored already stay so, but for XFSZ.
void prepare_for_early_ends();

/// Removes temporary files and ends the program by the signal, as if nothing had handled it.
[[noreturn]] void end_by_signal(int number);

/// Writes one line, removes temporary files, and ends the program with the exit code of invalid input.
[[noreturn]] void end_without_memory() noexcept;

/// Turns a crash (a failed assertion in a library, an invalid pointer) into one line on standard
/// error and the exit code of a bug, without a core dump. Leaves signals alone that are already
/// handled, by a sanitizer for example.
void report_crashes();

}  // namespace oplus
