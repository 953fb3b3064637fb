#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a CTest file with one test for each source file of a GoogleTest program.

Fails where a source has no case in the program.
Usage: tests_by_file.py PROGRAM BUILD TESTS PREFIX OUTPUT SOURCE...
BUILD is where the program was compiled, TESTS the folder that names of tests are relative to."""

import json
import subprocess
import sys
import tempfile
from pathlib import Path


def listed(program):
    """GoogleTest's list of suites, their cases, and the file of each."""
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "list.json"
        subprocess.run([program, "--gtest_list_tests", f"--gtest_output=json:{output}"],
                       stdout=subprocess.DEVNULL, check=True)
        return json.loads(output.read_text(encoding="utf-8"))["testsuites"]


def filters(suites, build):
    """By file, what selects all its cases and no others. The compiler names files relative to BUILD."""
    result = {}
    for suite in suites:
        file_of = {case["name"]: (Path(build) / case["file"]).resolve() for case in suite["testsuite"]}
        alone = len(set(file_of.values())) == 1
        for case, file in file_of.items():
            result.setdefault(file, set()).add(f"{suite['name']}.{'*' if alone else case}")
    return result


def entries(filter_of, tests, prefix, program, build):
    """The lines of the CTest file."""
    for file, selected in sorted(filter_of.items()):
        name = prefix + file.relative_to(tests).with_suffix("").as_posix()
        yield f'add_test([=[{name}]=] [=[{program}]=] [=[--gtest_filter={":".join(sorted(selected))}]=])'
        yield (f'set_tests_properties([=[{name}]=] PROPERTIES WORKING_DIRECTORY [=[{build}]=] '
               "SKIP_RETURN_CODE 77)")


def without_cases(filter_of, sources):
    return [f"{source}: no case of it is in the program" for source in sources
            if Path(source).resolve() not in filter_of]


def main():
    program, build, tests, prefix, output, *sources = sys.argv[1:]
    filter_of = filters(listed(program), build)
    missing = without_cases(filter_of, sources)
    if missing or not sources:
        sys.exit("\n".join(missing or ["no sources"]))
    lines = entries(filter_of, Path(tests).resolve(), prefix, program, build)
    Path(output).write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
