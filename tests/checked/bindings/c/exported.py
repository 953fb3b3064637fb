#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""exported.py LIBRARY: liboplus.so.1 exports what checked/bindings/c/exported.map lists, with its version, and nothing
else; that is what oplus.h declares; the program beside this file calls each of them, well and badly; and the library
needs GMP and the libraries of GCC alone."""

import re
import subprocess
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
FOLDER = HERE.parents[3] / "checked/bindings/c"
LISTED = re.findall(r"^    (\w+);$", (FOLDER / "exported.map").read_text(encoding="utf-8"), re.M)
VERSION = "OPLUS_1"
NEEDED = {"libgmp.so.10", "libstdc++.so.6", "libm.so.6", "libgcc_s.so.1", "libc.so.6",
          "ld-linux-x86-64.so.2"}
# They can't fail.
CANNOT_FAIL = {"oplus_version", "oplus_message", "oplus_free", "oplus_free_text"}


def output(*command):
    return subprocess.run([*command, LIBRARY], check=True, capture_output=True, text=True).stdout


class Exported(unittest.TestCase):
    def test_what_is_listed(self):
        symbols = [line.split()[-1] for line in output("nm", "--dynamic", "--defined-only").splitlines()]
        self.assertEqual(sorted(symbols), sorted([f"{name}@@{VERSION}" for name in LISTED] + [VERSION]))

    def test_what_the_header_declares(self):
        header = (FOLDER / "oplus.h").read_text(encoding="utf-8")
        self.assertEqual(LISTED, sorted(re.findall(r"^OPLUS_PUBLIC [^(]*\b(oplus_\w+)\(", header, re.M)))
        self.assertGreater(len(LISTED), 20)

    def test_all_are_called_well_and_badly(self):
        program = (HERE / "oplus_test.c").read_text(encoding="utf-8")
        for name in LISTED:
            with self.subTest(function=name):
                self.assertRegex(program, rf"(?<!BAD\(){name}\(")
                self.assertTrue(name in CANNOT_FAIL or re.search(rf"BAD\({name}\(", program))

    def test_name_and_needs(self):
        dynamic = output("readelf", "--dynamic", "--wide")
        self.assertIn("soname: [liboplus.so.1]", dynamic)
        needed = set(re.findall(r"Shared library: \[(.*)\]", dynamic))
        self.assertLessEqual(needed, NEEDED)
        self.assertIn("libgmp.so.10", needed)


if __name__ == "__main__":
    LIBRARY = sys.argv.pop(1)
    unittest.main()
