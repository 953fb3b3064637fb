#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""try_made.py COPY: tries the faults of made_mutants.py, built in COPY/build/check: for each, the tests that come to its
place, the cheapest first, until one fails. Writes COPY/tried.tsv: the lines of COPY/made.tsv, each with the kind of the tests
that ended it, and by which one and how; or "survived", or "not reached". A fault that is there already is not tried again.

docs/theorems/made.tsv is such a file in which, by hand, each "survived" was replaced by what became of the fault, and why."""

import concurrent.futures
import json
import os
import re
import resource
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

COPY = Path(sys.argv[1]).resolve()
BUILD = COPY / "build/check"
# How many pairs of a family are compared with the oracle.
COMPARED = {"grid": 200, "holes": 30, "tight": 30, "components": 20, "islands": 20, "fork": 2}
STAGES = ("unit tests", "corpus", "statements", "comparison")


def run(command, environment, seconds):
    """Returns "" if it passes, or how it fails; and the seconds of processor time that it took."""
    def limits():
        resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
        signal.signal(signal.SIGINT, signal.SIG_DFL)  # which a shell ignores for what runs beside it

    with tempfile.TemporaryDirectory() as folder:
        process = subprocess.Popen(command, cwd=folder, env=os.environ | environment, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=limits)
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = code = os.waitstatus_to_exitcode(status)
    spent = used.ru_utime + used.ru_stime
    return ("" if code == 0 else f"takes more than {seconds} s" if spent >= seconds else "fails"), spent


def tests():
    """Yields the stage, the name and the command of each test."""
    listed = json.loads(subprocess.run(["ctest", "--test-dir", BUILD, "--show-only=json-v1"], check=True,
                                       capture_output=True).stdout)
    for test in listed["tests"]:
        if re.match(r"(checked|corpus)\b", test["name"]):
            yield int(test["name"].startswith("corpus")), test["name"], test["command"]
    check = str(BUILD / "bin/oplus-check")
    theorems = json.loads(subprocess.run([check, "theorems", "--json"], check=True, capture_output=True).stdout)
    for statement in theorems["statements"]:
        if re.match("fact|law|step", statement["statement"]):
            yield 2, statement["statement"], [check, "properties", "--cases", "100", "--theorem", statement["statement"]]
    for family, cases in COMPARED.items():
        yield 3, f"diff {family}", [check, "diff", "--family", family, "--cases", str(cases), "--threads", "1"]


def reached(test):
    """The test with the seconds that it takes and the faults to whose places it comes; None if it fails without any."""
    with tempfile.NamedTemporaryFile() as file:
        file.write(bytes(4096))
        file.flush()
        how, seconds = run(test[2], {"OPLUS_MADE_REACHED": file.name}, 600)
        places = [n for n, byte in enumerate(Path(file.name).read_bytes()) if byte]
    if how:
        print(f"{test[1]}: {how} without a fault", flush=True)
    return None if how else (test[0], seconds, test[1], test[2], places)


def outcome(number, measured):
    """The kind of what kills it, and what does, and how; () if nothing does; None if no test comes to its place."""
    came = sorted((test for test in measured if number in test[4]), key=lambda test: test[1])
    for stage, seconds, name, command, _ in came:
        if how := run(command, {"OPLUS_MADE": str(number)}, 10 + int(20 * seconds))[0]:
            return STAGES[stage], name if how == "fails" else f"{name} {how}"
    return () if came else None


def fields(path):
    return [line.split("\t") for line in path.read_text(encoding="utf-8").splitlines()]


def main(pool):
    names, *faults = fields(COPY / "made.tsv")
    made = {fault[0]: fault for fault in faults}
    record = COPY / "tried.tsv"
    if not record.exists():
        record.write_text("\t".join([*names, "end", "by"]) + "\n", encoding="utf-8")
    done = {fault[0] for fault in fields(record)}
    came = {n: False for n in made if n not in done}

    def write(n, end, by=""):
        with record.open("a", encoding="utf-8") as out:
            out.write("\t".join([*made[n], end, by]) + "\n")

    for stage in range(len(STAGES)):
        cached = COPY / f"reached-{stage}.json"
        if not cached.exists():
            of_stage = [test for test in tests() if test[0] == stage]
            cached.write_text(json.dumps([test for test in pool.map(reached, of_stage) if test]), encoding="utf-8")
        measured = json.loads(cached.read_text(encoding="utf-8"))
        # The cheap ones for all faults before any of the dear ones, which most faults do not come to then.
        for some in ([test for test in measured if test[1] < 0.5], [test for test in measured if test[1] >= 0.5]):
            tried = {pool.submit(outcome, int(n), some): n for n in came}
            for future in concurrent.futures.as_completed(tried):
                n, how = tried[future], future.result()
                came[n] |= how is not None
                if how:
                    del came[n]
                    write(n, *how)
        print(f"{len(came)} left after the {STAGES[stage]}", flush=True)
    for n, ever in came.items():
        write(n, "survived" if ever else "not reached")


if __name__ == "__main__":
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
        main(workers)
