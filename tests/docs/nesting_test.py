#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""nesting_test.py OPLUS: the nesting of docs/examples prints and draws what its page shows, and places all parts."""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[2] / "docs/examples"


class NestingExample(unittest.TestCase):
    def test_is_what_its_page_shows(self):
        programs = f"{PROGRAM.parent}:{Path(sys.executable).parent}:{os.environ['PATH']}"
        with tempfile.TemporaryDirectory() as folder:
            ran = subprocess.run(["bash", EXAMPLES / "nesting/run"], cwd=folder, env=os.environ | {"PATH": programs},
                                 stdin=subprocess.DEVNULL, capture_output=True, text=True)
            self.assertEqual((ran.returncode, ran.stderr), (0, ""))
            self.assertIn(f"```\n{ran.stdout}```\n", (EXAMPLES / "README.md").read_text(encoding="utf-8"))
            self.assertTrue(ran.stdout.startswith("right\n"))
            self.assertTrue((Path(folder) / "nesting.svg").read_bytes() == (EXAMPLES / "nesting/nesting.svg").read_bytes(),
                            "nesting.svg is out of date")
            layout = json.loads((Path(folder) / "layout.json").read_text())
        names = [placement["part"] for placement in layout["placements"]]
        self.assertEqual(sorted(names), sorted(4 * list(layout["parts"])))
        self.assertEqual(len(layout["parts"]), 7)

    def test_is_short(self):
        self.assertLessEqual(len((EXAMPLES / "nesting/nesting.py").read_text().splitlines()), 100)


if __name__ == "__main__":
    PROGRAM = Path(sys.argv.pop(1)).resolve()
    unittest.main()
