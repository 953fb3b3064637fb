# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs oplus-bench, a row and an engine at a time, in processes of their own; compares engines; and writes numbers
and tables as text. What table.py and experiments.py share."""

import csv
import io
import json
import math
import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build/release/bin/oplus-bench"
REPETITIONS = 5
LONG_RUN = 0.5  # seconds; one that takes longer is not repeated (main.cpp)
OF_GOOGLE_BENCHMARK = {"family_index", "per_family_instance_index", "repetitions", "repetition_index", "threads",
                       "iterations", "real_time", "cpu_time"}


class UsageError(Exception):
    """In a line; exit code 2."""


@dataclass
class Measurement:
    """An engine on a row. Numbers are totals of all pairs; times are of the median repetition, the means of its runs."""
    engine: str
    outcome: str = "done"  # or "over the limit", "out of memory", "crashed", "failed", "unsupported"
    note: str = ""
    digest: str = ""  # of an exact result in canonical form; empty if the engine rounds
    area: str = ""
    numbers: dict = field(default_factory=dict)

    def is_done(self):
        return self.outcome == "done"

    def in_words(self):
        if self.outcome in ("crashed", "failed"):
            return f"{self.outcome}: {self.note}"
        return self.note or self.outcome


@dataclass
class Row:
    """The same input for several engines, and what they did."""
    name: str
    group: str = ""
    what: str = ""
    subject: str = "sums"
    pairs: int = 1
    engines: list = field(default_factory=list)
    words: dict = field(default_factory=dict)  # besides those of the engines, as `numbers`
    numbers: dict = field(default_factory=dict)
    measurements: list = field(default_factory=list)

    def of(self, engine):
        return next((m for m in self.measurements if m.engine == engine), None)

    def done(self, engine):
        found = self.of(engine)
        return found if found and found.is_done() else None

    def exact(self):
        return [m for m in self.measurements if m.is_done() and m.digest]

    def disagreement(self):
        """The exact engines that differ; empty if all agree."""
        names = {}
        for m in self.exact():
            names.setdefault(m.digest, []).append(m.engine)
        return " against ".join(", ".join(names[digest]) for digest in sorted(names)) if len(names) > 1 else ""

    def number(self, path):
        """A number of the row, else of the first exact engine ("sum_holes"); of an engine ("rca.seconds"), also the
        error of its area ("clipper.area_error", "clipper.relative_area_error"); or a quotient of two. Or None."""
        if "/" in path:
            over, under = map(self.number, path.split("/"))
            return over / under if over is not None and under else None
        if path in self.numbers:
            return self.numbers[path]
        engine, dot, name = path.rpartition(".")
        exact = self.exact()[0] if self.exact() else None
        m = self.done(engine) if dot else exact
        if m is None:
            return None
        if name not in ("area_error", "relative_area_error"):
            return m.numbers.get(name)
        if exact is None or not exact.area or not m.area:
            return None
        error = Fraction(m.area) - Fraction(exact.area)
        return float(error if name == "area_error" else error / Fraction(exact.area))

    def faults(self, ours):
        """What is wrong: exact engines that disagree, and one of ours that crashed or failed. Whatever another library
        does is a result; so is exceeding a limit."""
        disagreement = self.disagreement()
        return ([f"{self.name}: {disagreement} disagree"] if disagreement else []) + [
            f"{self.name}: {m.engine} {m.in_words()}" for m in self.measurements
            if m.outcome in ("crashed", "failed") and m.engine in ours]


@dataclass
class Engine:
    name: str
    what: str
    kind: str
    is_ours: bool
    rounds: bool
    is_of_all_rows: bool


class Program:
    """oplus-bench, and oplus-bench-newest if that is beside it: what they can measure."""

    def __init__(self, path=PROGRAM, options=()):
        path = Path(path)
        self.context, self.commands, self.rows, self.engines = {}, {}, [], []
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))  # a library that crashes leaves no file
        if not path.is_file():
            raise UsageError(f"there is no {path}; `bash tests/run --everything` builds it")
        self.add([str(path), *options])
        if (newest := path.with_name(path.name + "-newest")).is_file():
            self.context["newest"] = (path.parents[1] / "newest/versions").read_text().strip()
            self.add([str(newest)])

    def add(self, command):
        listed = subprocess.run([*command, "--list"], capture_output=True, text=True)
        if listed.returncode != 0:
            raise UsageError(listed.stderr.strip())
        there = {row.name: row for row in self.rows}
        for what, *cells in (line.split("\t") for line in listed.stdout.splitlines()):
            if what == "row":
                name, group, words, subject, pairs, engines = cells
                if name in there:
                    there[name].engines += engines.split()
                else:
                    self.rows.append(Row(name, group, words, subject, int(pairs), engines.split()))
            elif what == "engine":
                *words, flags = cells
                self.engines.append(Engine(*words, *(flag == "1" for flag in flags)))
                self.commands[words[0]] = command
            elif what == "peak_mb" and not there:
                self.peak_mb = float(cells[0])  # of a process that idles

    def ours(self):
        return {engine.name for engine in self.engines if engine.is_ours}

    def measure(self, row, engine, limit=0, min_time=0.5, memory_mb=0):
        """Repetitions of `min_time` seconds in all, after one run that does not count. A step (making the pair, a run,
        ...) may take `limit` seconds, and the process memory_mb; 0: unlimited."""
        with tempfile.TemporaryDirectory(prefix="oplus-bench-") as folder:
            out, errors = Path(folder) / "out.json", Path(folder) / "errors"
            options = [f"--benchmark_filter=^{row.name}/{engine}/", f"--benchmark_repetitions={REPETITIONS}",
                       f"--benchmark_min_time={min_time / REPETITIONS}", f"--benchmark_out={out}",
                       f"--limit={limit}", f"--memory={memory_mb}"]

            with errors.open("wb") as to_errors:
                process = subprocess.Popen(self.commands[engine] + options, stdout=subprocess.DEVNULL, stderr=to_errors,
                                           env={**os.environ, "TMPDIR": folder})
                peak = waited_for(process)
            m = Measurement(engine, numbers={"peak_mb": peak})
            said = errors.read_text(errors="replace")
            if process.returncode == -signal.SIGALRM:
                m.outcome, m.note = "over the limit", f"> {plain(limit)} s"
                m.numbers["limit"] = limit
            elif process.returncode and any(words in said for words in ("bad_alloc", "annot allocate memory",
                                                                        "out of memory")):
                m.outcome = "out of memory"
            elif process.returncode < 0:
                m.outcome, m.note = "crashed", f"signal {-process.returncode}"
            elif process.returncode:
                m.outcome, m.note = "failed", f"exit code {process.returncode} {said.strip()[-200:]}".strip()
            else:
                self.read(json.loads(out.read_text(encoding="utf-8", errors="replace")), m)
            return m

    def read(self, found, m):
        """What Google Benchmark wrote: the median repetition."""
        self.context = {**found["context"], **self.context}
        runs = [run for run in found["benchmarks"] if run.get("run_type") == "iteration"]
        errors = [run["error_message"] for run in runs if run.get("error_occurred")]
        if errors or not runs:
            outcome, _, m.note = (errors + ["failed: no result"])[0].partition(": ")
            m.outcome = outcome
            return
        middle = sorted(runs, key=lambda run: run["seconds"])[len(runs) // 2]
        m.numbers = {name: value for name, value in middle.items()
                     if isinstance(value, (int, float)) and name not in OF_GOOGLE_BENCHMARK}
        for name in ("seconds", "seconds_evaluated"):
            if name in m.numbers:
                m.numbers[name + "_least"], m.numbers[name + "_most"] = (
                    least([run[name] for run in runs]) for least in (min, max))
        m.numbers["busy"] = m.numbers.pop("busy_seconds") / m.numbers["seconds"]
        m.numbers["repetitions"] = 1 if m.numbers["seconds"] > LONG_RUN else len(runs)
        for part in middle.get("label", "").split():
            name, _, value = part.partition("=")
            setattr(m, name, value)


def waited_for(process):
    """Waits for it. Returns its largest resident size, in units of 10^6 bytes, as seen twenty times a second: what the
    system says at its end starts with that of the process that started it."""
    peak = 0
    while True:
        try:
            for line in Path(f"/proc/{process.pid}/status").read_text().splitlines():
                if line.startswith("VmHWM:"):
                    peak = int(line.split()[1]) * 1024 / 1e6
        except OSError:
            pass
        try:
            process.wait(0.05)
            return peak
        except subprocess.TimeoutExpired:
            pass
        except BaseException:
            process.kill()
            process.wait()
            raise


def measure(program, row, engines, limit=0, **limits):
    """Measures these of the row's engines, and prints a table at the same time. The limit is that of other libraries;
    oplus gets ten times as much."""
    print(f"{row.name}: {row.what}")
    for engine in (name for name in engines if name in row.engines):
        m = program.measure(row, engine, limit * 10 if engine in program.ours() else limit, **limits)
        row.measurements.append(m)
        columns = columns_of("ms = 1000 *.seconds; MB = 1 *.peak_mb; vertices = *.sum_vertices; holes = *.sum_holes; "
                             "segments = *.segments; ms evaluated = 1000 *.seconds_evaluated; "
                             "% busy = 100 *.busy".replace("*", engine))
        cells = [f"{cell:>9} {heading}" for heading, cell_of in columns if (cell := cell_of(row))]
        print(f"  {engine:16}" + ("".join(cells) if m.is_done() else "  " + m.in_words()), flush=True)
    if row.disagreement():
        print(f"  DISAGREEMENT: {row.disagreement()}")
    for m in row.measurements:
        error = row.number(m.engine + ".relative_area_error")
        if error is not None and not m.digest:
            print(f"  {m.engine}: area off by {power_of_ten(error)} of it, {plain(m.numbers.get('sum_holes', 0))} "
                  f"holes of {plain(row.number('sum_holes') or 0)}")


def setting(context, command):
    """The machine and the command of a run."""
    processor = next((line.split(": ", 1)[1] for line in Path("/proc/cpuinfo").read_text().splitlines()
                      if line.startswith("model name") and ": " in line), "unknown processor")
    describe = ["git", "describe", "--always", "--dirty"]
    commit = subprocess.run(describe, cwd=ROOT, capture_output=True, text=True).stdout if shutil.which("git") else ""
    return {"processor": processor, "cores": os.cpu_count(), "libraries": context.get("libraries", ""),
            "newest": context.get("newest", "not built"),
            "commit": commit.strip(), "command": command}


def report(faults):
    """Exit code."""
    for fault in faults:
        print(f"{Path(sys.argv[0]).name}: {fault}", file=sys.stderr)
    return 1 if faults else 0


def run(main):
    try:
        sys.exit(main())
    except (UsageError, OSError) as wrong:
        print(f"{Path(sys.argv[0]).name}: {wrong}", file=sys.stderr)
        sys.exit(2)


# Numbers as text.

def plain(value):
    return f"{value:.15g}" if math.isfinite(value) and value == math.floor(value) else f"{value:.6g}"


def three_digits(value):
    if value == 0 or not math.isfinite(value):
        return plain(value)
    rounded = f"{value:.2e}"  # may have one more digit: 9.996 is 10.0
    return f"{float(rounded):,.{max(0, 2 - int(rounded.split('e')[1]))}f}"


def power_of_ten(value):
    return "0" if value == 0 else f"{value:.1e}"


# Tables.

def columns_of(words):
    """Columns, separated by "; ": a heading, " = ", a format and a name, such as "T_RC, ms = 1000 rca.time". The name is
    "what", a word of the row, an outcome ("rca.outcome") or a number (Row.number). The format of a number is empty for
    an integer, "e" for a power of ten, otherwise a factor, and three digits of the product are shown. If an engine has
    no number, the first column here has `instead_of_number`, others are empty. Returns headings, and functions of a
    row."""
    columns = []
    for i, column in enumerate(words.split("; ")):
        heading, equals, what = column.partition(" = ")
        if not equals:
            raise ValueError(f"invalid column: {column}")
        form, _, name = what.rpartition(" ")
        columns.append((heading, lambda row, form=form, name=name, i=i: shown(row, form, name, i == 0)))
    return columns


def shown(row, form, name, says_instead):
    engine = name.split(".")[0]
    if name == "what":
        return row.what
    if name.endswith(".outcome"):
        return row.of(engine).in_words() if row.of(engine) else ""
    if name in row.words:
        return {"true": "yes", "false": "no"}.get(row.words[name], row.words[name])
    value = row.number(name)
    if value is None:
        return instead_of_number(row.of(engine)) if says_instead else ""
    if not form:
        return f"{int(value):,}"
    return power_of_ten(value) if form == "e" else three_digits(float(form) * value)


def instead_of_number(m):
    """Empty if nothing was measured, a dash if the row is unsupported, otherwise the outcome."""
    if m is None or m.is_done():
        return ""
    return {"unsupported": "–", "failed": "failed"}.get(m.outcome, m.in_words())


def table_of(rows, lines, names=()):
    """A table in Markdown. Lines are columns; one with * is repeated for each of the names, which replaces *."""
    columns = [column for line in lines.strip().splitlines()
               for name in (names if "*" in line else ("",)) for column in columns_of(line.replace("*", name))]
    return markdown([heading for heading, _ in columns], [[cell_of(row) for _, cell_of in columns] for row in rows])


def markdown(head, rows):
    lines = [head, None, *rows]
    return "\n".join("|" + "---|" * len(head) if cells is None else
                     "| " + " | ".join(cell.replace("|", "/").replace("\n", " ") for cell in cells) + " |"
                     for cells in lines)


def to_csv(rows, columns):
    """The named columns first, even if empty; others in alphabetical order. Each engine has its own, "rca_time" and
    "rca_outcome"; numbers that are the same for all, such as "m" and "sum_holes", have one."""
    common = {"m", "n", "questions", "asked", "holes", "others"}
    lines = []
    for row in rows:
        cells = dict(row.words)
        for m in row.measurements:
            cells[m.engine + "_outcome"] = m.in_words()
            for name, value in m.numbers.items() if m.is_done() else ():
                is_common = name in common or name.startswith("sum_")
                cells[name if is_common else f"{m.engine}_{name}"] = plain(value)
        cells.update((name, plain(value)) for name, value in row.numbers.items())
        lines.append(cells)
    columns = [*columns, *sorted({name for cells in lines for name in cells} - set(columns))]
    text = io.StringIO()
    writer = csv.DictWriter(text, columns, restval="", lineterminator="\n")
    writer.writeheader()
    writer.writerows(lines)
    return text.getvalue()
