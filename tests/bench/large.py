# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands on large regions: the wall time and the peak memory of each process."""

import os
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

from measuring import Measurement, Row

SMALL, LARGE = 100_000, 1_000_000
SQUARE = "POLYGON((0 0,2 0,2 2,0 2,0 0))\n"
# In this order, as later ones read what earlier ones wrote.
COMMANDS = {"read": ("reading, validity, writing: `oplus reflect P`", "oplus reflect p.wkt -o r.wkt"),
            "sum": ("`oplus sum`, one thread", "oplus sum p.wkt q.wkt -o s.wkt --threads 1"),
            "sum2": ("`oplus sum`, two threads", "oplus sum p.wkt q.wkt -o s.wkt --threads 2"),
            "open": ("`oplus sum --open`, one thread", "oplus sum p.wkt q.wkt --open -o o.wkt --threads 1"),
            "round": ("`oplus sum --digits 0`, one thread", "oplus sum p.wkt q.wkt --digits 0 -o d.wkt --threads 1"),
            "verify": ("`oplus verify`", "oplus verify p.wkt q.wkt s.wkt"),
            "certify": ("`oplus certify`", "oplus certify p.wkt q.wkt s.wkt -o certificate"),
            "check": ("`oplus-certified`", "oplus-certified p.wkt q.wkt s.wkt certificate")}


def measured(command, programs, folder):
    """A command that takes less than a second, three times."""
    words = command.split()
    seconds, mb = [], 0
    while not seconds or (seconds[0] < 1 and len(seconds) < 3):
        start = time.perf_counter()
        process = subprocess.Popen([programs / words[0], *words[1:], *["--quiet"] * (words[0] == "oplus")], cwd=folder,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        seconds.append(time.perf_counter() - start)
        mb = max(mb, usage.ru_maxrss * 1024 / 1e6)
        if process.returncode:
            return {}, f"exit code {process.returncode}"
    return {"seconds": statistics.median(seconds), "seconds_least": min(seconds), "seconds_most": max(seconds),
            "process_mb": mb}, ""


def rows(programs, sizes=(SMALL, LARGE)):
    """A row of each command; its engines are "small" and "large", coastlines of so many vertices with a square."""
    made = {name: Row("large_" + name, "large", what, "large") for name, (what, _) in COMMANDS.items()}
    for engine, vertices in zip(("small", "large"), sizes):
        with tempfile.TemporaryDirectory(prefix="oplus-bench-") as folder:
            subprocess.run([programs / "oplus", "gen", "coast", "--n", str(vertices), "-o", "p.wkt"], cwd=folder, check=True)
            (Path(folder) / "q.wkt").write_text(SQUARE)
            for name, row in made.items():
                numbers, failed = measured(COMMANDS[name][1], programs, folder)
                row.measurements.append(Measurement(engine, "failed" if failed else "done", failed,
                                                    numbers={**numbers, "vertices": vertices}))
                print(f"large_{name}, {vertices} vertices: {failed or numbers}", flush=True)
    return list(made.values())
