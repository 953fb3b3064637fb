#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""parallel_test.py OPLUS: the commands of docs/many_machines.md for GNU parallel, the first of them also killed and run
again, write what one run writes."""

import contextlib
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

PAGE = Path(__file__).resolve().parents[2] / "docs/many_machines.md"
SECTION = PAGE.read_text(encoding="utf-8").split("\n## GNU parallel\n")[1].split("\n## ")[0]
COMMANDS = re.findall(r"(?<=\n    \$ )(?:.*\\\n)*.*", SECTION)


def processes_of_session(session):
    """Jobs of parallel are in process groups of their own."""
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _, _, its_session, *_ = stat.read_text().rpartition(")")[2].split()
        except OSError:  # it has ended
            continue
        if int(its_session) == session and state != "Z":
            found.append(int(stat.parent.name))
    return found


class Parallel(unittest.TestCase):
    def setUp(self):
        self.environment = os.environ | {"PATH": f"{PROGRAM.parent}:{os.environ['PATH']}"}
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.environment["HOME"] = folder.name  # parallel has files there
        stars = [self.run_in_bash(f"oplus gen star --n {n} --seed {n}") for n in range(21, 33)]
        (self.folder / "parts.txt").write_text("".join(stars))
        (self.folder / "pairs.tsv").write_text("".join(p.strip() + "\t" + q for p in stars for q in stars[:3]))

    def run_in_bash(self, command):
        ran = subprocess.run(["bash", "-c", command], cwd=self.folder, env=self.environment, stdin=subprocess.DEVNULL,
                             capture_output=True, text=True)
        self.assertEqual(ran.returncode, 0, f"{command}\n{ran.stderr}")
        return ran.stdout

    def content(self, file):
        return (self.folder / file).read_bytes()

    def test_are_these(self):
        self.assertEqual([command.split()[0] for command in COMMANDS], ["parallel", "oplus", "parallel", "oplus"])

    def test_on_one_machine_also_after_a_kill(self):
        computes, merges = COMMANDS[:2]
        outputs = lambda: [path for path in self.folder.glob("no_fit.*.jsonl") if path.stat().st_size > 0]
        killed = subprocess.Popen(["bash", "-c", computes], cwd=self.folder, env=self.environment, stdin=subprocess.DEVNULL,
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
        while len(outputs()) < 2:
            self.assertIsNone(killed.poll(), "it ended before it was killed")
            time.sleep(0.001)
        while members := processes_of_session(killed.pid):
            for member in members:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(member, signal.SIGKILL)
            killed.poll()
        self.run_in_bash(computes)
        self.assertEqual(len(outputs()), 16)
        self.run_in_bash(merges)
        self.run_in_bash("oplus batch --parts parts.txt --operation nfp --rotations 0,90,180 -o whole")
        self.assertEqual(self.content("no_fit.jsonl").count(b"\n"), 12 * 12 * 3)
        self.assertTrue(self.content("no_fit.jsonl") == self.content("whole"))

    def test_on_several_machines(self):
        for command in COMMANDS[2:]:
            self.run_in_bash(command)
        self.run_in_bash("oplus batch pairs.tsv -o whole")
        self.assertTrue(self.content("sums.jsonl") == self.content("whole"))


if __name__ == "__main__":
    PROGRAM = Path(sys.argv.pop(1)).resolve()
    unittest.main()
