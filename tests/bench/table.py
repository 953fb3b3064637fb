#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures Minkowski sums by oplus, CGAL, Clipper and Boost.Polygon, by oplus-bench: each engine on each row in a process
of its own; and compares the results.

Exit code: 0 all exact results are equal, 1 they are not or an engine of oplus crashed or failed, 2 invalid usage.
Another library that crashes or is too slow is a result."""

import argparse
import json
import math
import re
import shlex
import sys
from dataclasses import asdict, dataclass
from itertools import groupby
from pathlib import Path

from measuring import (PROGRAM, REPETITIONS, Engine, Measurement, Program, Row, UsageError, instead_of_number, markdown,
                       measure, plain, report, run, setting, table_of, three_digits)

SUBJECTS = ("sums", "growth", "commands", "certificates", "proved", "distances", "places", "nesting",
            "convolution")  # the sections of the page
PEERS_OF_PARTS = ["cgal-nfp", "cgal-nfp-newest", "clipper-nfp", "clipper2-nfp"]
TEMPLATE = Path(__file__).parent / "pages/benchmarks.md"


@dataclass
class Report:
    """A run: what --json writes."""
    setting: dict
    engines: list
    rows: list

    def to_json(self):
        return json.dumps(asdict(self), indent=1) + "\n"

    @staticmethod
    def read(path):
        """Throws UsageError."""
        try:
            found = json.loads(Path(path).read_text(encoding="utf-8"))
            rows = [Row(**{**row, "measurements": [Measurement(**m) for m in row["measurements"]]})
                    for row in found["rows"]]
            return Report(found["setting"], [Engine(**engine) for engine in found["engines"]], rows)
        except (ValueError, TypeError, KeyError) as wrong:
            raise UsageError(f"{path}: not what --json writes: {wrong}") from None

    def of(self, subject):
        return [row for row in self.rows if row.subject == subject]

    def group(self, name):
        return [row for row in self.rows if row.group == name]

    def named(self, name):
        return [row for row in self.rows if row.name == name]


@dataclass
class Ratio:
    """Of measured numbers. For an engine that was stopped it is a lower bound."""
    value: float
    is_lower_bound: bool = False

    def __str__(self):
        return ("> " if self.is_lower_bound else "") + three_digits(self.value)


def ratio(row, number, engine, base, limit):
    """The engine's number ("seconds" or "peak_mb") divided by that of `base`; None if one of them has no such number.
    An engine that was stopped took at least `limit` seconds."""
    m, of_base = row.of(engine), row.number(f"{base}.{number}")
    if m is None or not of_base:
        return None
    stopped = m.outcome == "over the limit"
    of_engine = limit if stopped and number == "seconds" else m.numbers.get(number)
    return Ratio(of_engine / of_base, stopped) if (stopped or m.is_done()) and of_engine is not None else None


def geometric_mean(ratios):
    """A lower bound if one of them is."""
    return Ratio(math.exp(sum(math.log(one.value) for one in ratios) / len(ratios)),
                 any(one.is_lower_bound for one in ratios))


# Goals: rows of a table, (text, measured, reached).

def goal(text, measured="", reached=None):
    return [text, measured, "not measured" if reached is None else "yes" if reached else "**no**"]


def at_least(least, text, found, row=""):
    """A ratio that should be large, and its row. A lower bound below the goal decides nothing."""
    if found is None:
        return goal(text)
    unknown = found.is_lower_bound and found.value < least
    return goal(text, f"{found}, {row}" if row else str(found), None if unknown else found.value >= least)


def none_is_faster(text, rows, limit):
    """The rows on which another engine takes less time than slide."""
    found = [(row, m.engine, of_m) for row in rows for m in row.measurements if not m.engine.startswith("slide")
             and (of_m := ratio(row, "seconds", m.engine, "slide", limit))]
    faster = "; ".join(f"{row.what}: {engine}, {of_m}" for row, engine, of_m in found
                       if not of_m.is_lower_bound and of_m.value < 1)
    return goal(text, faster or "none", not faster) if found else goal(text)


def at_most(most, text, rows, limit, engine, spare=0, base="slide"):
    """The largest quotient of the times of an engine and of `base`, after `spare` seconds are taken off. One that was
    stopped may be larger."""
    found = [(Ratio(max(of_row.value - spare / row.number(base + ".seconds"), 0), of_row.is_lower_bound), row)
             for row in rows if (of_row := ratio(row, "seconds", engine, base, limit))]
    if not found:
        return goal(text)
    largest, row = max(found, key=lambda one: one[0].value)
    measured = f"{'' if largest.is_lower_bound else 'at most '}{largest}, {row.what}"
    unknown = largest.value <= most and any(of_row.is_lower_bound for of_row, _ in found)
    return goal(text, measured, None if unknown else largest.value <= most)


def no_more(most, text, rows, number, factor=1):
    """The largest of the numbers, multiplied by a factor."""
    found = [(factor * value, row.what) for row in rows if (value := row.number(number))]
    if not found:
        return goal(text)
    largest, what = max(found, key=lambda one: one[0])
    return goal(text, f"at most {three_digits(largest)}, {what}", largest <= most)


def least_ratio(rows, limit, engine, base):
    """And its row."""
    found = [(of_row, row.what) for row in rows if (of_row := ratio(row, "seconds", engine, base, limit))]
    return min(found, key=lambda one: one[0].value) if found else (None, "")


def goals_of(run_report):
    limit, named, group = run_report.setting["limit"], run_report.named, run_report.group

    def beside_cgal(number, name):
        return next((ratio(row, number, "cgal-reduced", "slide", limit) for row in named(name)), None)

    def as_fast(least, what, name):
        return at_least(least, f"{what}: at least {least} times as fast as CGAL's reduced convolution",
                        beside_cgal("seconds", name))

    def little_memory(what, name):
        return at_least(10, f"{what}: at most a tenth of CGAL's memory", beside_cgal("peak_mb", name))

    sums, certificates = run_report.of("sums"), run_report.of("certificates")
    published = [of_row for row in group("published")
                 if (of_row := ratio(row, "seconds", "cgal-reduced", "slide", limit))]
    checked = group("certificates") if all(row.done("oplus-certified") for row in group("certificates")) else []
    small_pairs_a_second = next((Ratio(row.pairs / seconds) for row in named("command_small_pairs")
                                 if (seconds := row.number("oplus-batch.seconds"))), None)
    two_threads = [of_row for row in run_report.of("growth")
                   if (of_row := ratio(row, "seconds", "slide", "slide2", limit))]
    return [
        as_fast(50, "stars of 300 and 100", "star_300_star_100"),
        as_fast(25, "stars of 100 and 100", "star_100_star_100"),
        little_memory("stars of 300 and 100", "star_300_star_100"),
        little_memory("stars of 100 and 100", "star_100_star_100"),
        as_fast(25, "simple polygons of 200 and 100", "simple_200_simple_100"),
        as_fast(8, "fork of 50 teeth and L", "fork_50"),
        none_is_faster("fork of 50 teeth and L: no engine is faster", named("fork_50"), limit),
        at_least(10, "published pairs: at least 10 times, geometric mean",
                 geometric_mean(published) if published else None),
        at_least(3, "published pairs: none less than 3 times",
                 *least_ratio(group("published"), limit, "cgal-reduced", "slide")),
        as_fast(10, "small pairs", "small_pairs"),
        none_is_faster("no row on which another engine is faster", sums, limit),
        no_more(3, "sums without holes: at most 3 µs per segment of the reduced convolution",
                [row for row in run_report.rows if row.group != "hard" and not row.number("slide.sum_holes")],
                "slide.seconds/slide.segments", 1e6),
        no_more(10, "hard pairs: at most 10 µs per segment of the reduced convolution", group("hard"),
                "slide.seconds/slide.segments", 1e6),
        at_most(1.3, "whole command: at most 1.3 times the call, and 10 ms", run_report.of("commands"), limit,
                "oplus-sum", 0.01),
        at_least(20_000, "small pairs, the whole command `oplus batch`: at least 20,000 a second",
                 small_pairs_a_second),
        at_most(2, "open sums: at most twice the time of closed ones", sums, limit, "slide-open"),
        at_most(20, "verify: at most 20 times the time of slide", sums, limit, "verify"),
        at_least(1.8, "two threads: at least 1.8 times one, on the largest sum of the growth",
                 two_threads[-1] if two_threads else None),
        at_least(1, "certificates: checked at least as fast as CGAL's program sums",
                 *least_ratio(checked, limit, "cgal-sum", "oplus-certified")),
        at_most(10, "certificates: made in at most 10 times `oplus sum`, and 0.1 s", certificates, limit,
                "sum-certificate", 0.1, "oplus-sum"),
        no_more(200, "certificates: at most 200 bytes by gzip per segment of the reduced convolution", certificates,
                "sum-certificate.zipped_bytes/slide.segments"),
        no_more(0.3, "the proved program: stars of 30 and 30 in at most 0.3 s", named("proved_star_30_star_30"),
                "oplus-proved.seconds"),
        no_more(5, "the proved program: stars of 60 and 60 in at most 5 s", named("proved_star_60_star_60"),
                "oplus-proved.seconds"),
        at_least(1, "the proved program: stars of 100 and 100 at least as fast as CGAL's full convolution",
                 *least_ratio(named("proved_star_100_star_100"), limit, "cgal-full", "oplus-proved")),
        no_more(500, "distances: at most 500 µs a pair", run_report.of("distances"),
                "distance.seconds/distance.pairs", 1e6),
        no_more(500, "depths of parts of swim: at most 500 µs a pair", named("distances_swim_overlapping"),
                "depth.seconds/depth.pairs", 1e6),
        no_more(1000, "places: at most 1,000 ns each", run_report.of("places"),
                "placements.seconds/placements.places", 1e9)]


# The page.

def ratios(rows, engines, limit, first, number, base="slide"):
    """A line per row, and one of geometric means per group of several rows; rows without a ratio to `base` do not count
    for the means."""
    head = table_of([], first).splitlines()[0].strip("| ").split(" | ")
    lines = []
    for group, of_group in groupby(rows, key=lambda row: row.group):
        of_group = list(of_group)
        found = {engine: [ratio(row, number, engine, base, limit) for row in of_group] for engine in engines}
        for i, row in enumerate(of_group):
            begin = table_of([row], first).splitlines()[2].removeprefix("| ").removesuffix(" |").split(" | ")
            lines.append(begin + [str(found[engine][i]) if found[engine][i] else instead_of_number(row.of(engine))
                                  for engine in engines])
        if len(of_group) > 1:
            means = [geometric_mean(there) if (there := [one for one in found[engine] if one]) else None
                     for engine in engines]
            lines.append([f"*{group}, geometric mean*"] + [""] * (len(head) - 1) +
                         [f"*{mean}*" if mean else "" for mean in means])
    return markdown(head + engines, lines)


def throughput(rows, engines):
    lines = []
    for row in (row for row in rows if row.pairs > 1):
        for engine in engines:
            rates = [three_digits(row.pairs / seconds) if (seconds := row.number(f"{engine}.{number}")) else ""
                     for number in ("seconds", "seconds_evaluated")]
            lines.append([engine, rates[0] or instead_of_number(row.of(engine)), rates[1]])
    return markdown(["engine", "pairs per second", "with coordinates evaluated"], lines)


def remarks(rows):
    """The cells of the tables that are not numbers, with the reasons."""
    found = []
    for row in rows:
        if row.disagreement():
            found.append(f"{row.what}: **{row.disagreement()} disagree**")
        found += [f"{row.what}: {m.engine} {m.in_words()}" for m in row.measurements
                  if m.outcome not in ("done", "over the limit")]
    return "\n".join(f"- {remark}." for remark in found) or "- Every engine computed every row."


def page(run_report, template):
    """{{name}} becomes a text, and {{#name}}, lines of columns, {{/name}} a table."""
    rows, limit = run_report.rows, run_report.setting["limit"]
    sums = run_report.of("sums")
    listed = [engine for engine in run_report.engines if engine.kind == "sums" and engine.is_of_all_rows
              and engine.name != "slide2" and any(row.of(engine.name) for row in sums)]
    engines = [engine.name for engine in listed]
    others = [engine.name for engine in listed if engine.name != "slide"]
    lazy = [name for name in others if any(row.number(name + ".seconds_evaluated") for row in sums)]
    done = [m for row in rows for m in row.measurements if m.is_done()]
    compared = [row for row in rows if len(row.exact()) > 1]

    def where_done(of, *names):
        return [row for row in of if all(row.done(name) for name in names)]

    nesting = run_report.of("nesting")
    texts = {"newest": "", **{name: str(value) for name, value in run_report.setting.items()},
             "limit": plain(limit), "repetitions": str(REPETITIONS), "measured": str(len(done)),
             "busy": str(sum(m.numbers.get("busy", 0) >= 0.95 for m in done)), "compared": str(len(compared)),
             "equal": str(sum(not row.disagreement() for row in compared)), "remarks": remarks(rows),
             "engines": "\n".join(f"- `{engine.name}`: {engine.what}." for engine in listed),
             "goals": markdown(["goal", "measured", "reached"], goals_of(run_report)),
             "throughput": throughput(sums, engines),
             "ratios": ratios(sums, others, limit, "time / slide = what", "seconds"),
             "nesting": ratios(nesting, PEERS_OF_PARTS, limit, "no-fit polygons of all pairs = what; calls alone, ms = "
                               "1000 slide.seconds; oplus batch, ms = 1000 oplus-nfp.seconds", "seconds", "oplus-nfp"),
             "memory": ratios(sums, others, limit, "memory / slide = what; slide, MB = 1 slide.peak_mb", "peak_mb")}
    tables = {"sums": (sums, engines), "lazy_engines": (sums, lazy),
              "rounding_engines": (sums, [engine.name for engine in listed if engine.rounds]),
              "growth": (where_done(run_report.of("growth"), "slide"), ()),
              "commands": (run_report.of("commands"), ()), "certificates": (run_report.of("certificates"), ()),
              "proved": (run_report.of("proved"), ()),
              "distances": (run_report.of("distances"), ()), "places": (run_report.of("places"), ()),
              "nesting_peers": (nesting, PEERS_OF_PARTS),
              "threads": (where_done(rows, "slide", "slide2"), ()),
              "convolutions": (where_done(rows, "traced", "naive"), ())}
    with_tables = re.sub(r"\{\{#(\w+)\}\}\n(.*?)\{\{/\1\}\}",
                         lambda found: table_of(tables[found[1]][0], found[2], tables[found[1]][1]), template,
                         flags=re.DOTALL)
    return re.sub(r"\{\{(\w+)\}\}", lambda found: texts[found[1]], with_tables)


# The command.

def chosen_rows(program, pattern):
    try:
        # Rows with faults are for tests, and experiments have a command: only by name.
        rows = [row for row in program.rows if re.fullmatch(pattern, row.name)
                and (row.subject in SUBJECTS or pattern == row.name)]
    except re.error as wrong:
        raise UsageError(f"--rows: {wrong}") from None
    if not rows:
        raise UsageError(f"no row matches {pattern}")
    return rows


def chosen_engines(program, rows, names):
    offered = list(dict.fromkeys(engine.name for engine in program.engines
                                 if any(engine.name in row.engines for row in rows)))
    for name in names or ():
        if name not in [engine.name for engine in program.engines]:
            raise UsageError(f"unknown engine {name}; --list shows all")
    return [name for name in names or offered]


def measured_report(given, program, command):
    rows = chosen_rows(program, given.rows)
    engines = chosen_engines(program, rows, given.engines and given.engines.split(","))
    run_report = Report({}, program.engines, [])
    for row in rows:
        if not set(row.engines) & set(engines):
            continue
        measure(program, row, engines, limit=given.limit, min_time=given.min_time)
        run_report.rows.append(row)
        run_report.setting = setting(program.context, command, given.limit)
        if given.json:  # an interrupted run keeps what it has measured
            given.json.write_text(run_report.to_json(), encoding="utf-8")
    if not run_report.rows:
        raise UsageError("no row has such an engine")
    return run_report


def positive(text):
    value = float(text)
    if not 0 < value < math.inf:
        raise ValueError
    return value


def command_of(parser, given):
    """The command that measures the same; without its files, which are of one machine only."""
    words = ["python3", "tests/bench/table.py"]
    for name in ("rows", "engines", "limit", "min_time"):
        value = getattr(given, name)
        if value != parser.get_default(name):
            words += ["--" + name.replace("_", "-"), plain(value) if isinstance(value, float) else value]
    return shlex.join(words)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", metavar="REGEX", default=".*", help="only rows whose whole name matches")
    parser.add_argument("--engines", metavar="LIST", help="only these engines, separated by commas")
    parser.add_argument("--limit", type=positive, default=60.0, help="seconds after which a run is stopped (60)")
    parser.add_argument("--min-time", type=float, default=0.5,
                        help="least total seconds of an engine's runs (0.5); a run of more than a second is not repeated")
    parser.add_argument("--list", action="store_true", help="list the rows and the engines")
    parser.add_argument("--json", metavar="FILE", type=Path, help="write the measurements to FILE")
    parser.add_argument("--markdown", metavar="FILE", type=Path, help="write a page like docs/benchmarks.md to FILE")
    parser.add_argument("--from", metavar="FILE", dest="files", nargs="+",
                        help="measure nothing, read what --json wrote")
    parser.add_argument("--program", metavar="FILE", type=Path, default=PROGRAM, help=f"oplus-bench ({PROGRAM})")
    given = parser.parse_args()
    if given.files:
        reports = [Report.read(path) for path in given.files]
        run_report = reports[0]
        for other in reports[1:]:
            run_report.rows += other.rows
    else:
        program = Program(given.program, ["--with-faults"] if given.rows.startswith("faults_") else [])
        if given.list:
            for row in chosen_rows(program, given.rows):
                print(f"{row.name}: {row.what}")
            print("engines")
            for engine in program.engines:
                print(f"  {engine.name}: {engine.what}")
            return 0
        run_report = measured_report(given, program, command_of(parser, given))
    if given.markdown:
        given.markdown.write_text(page(run_report, TEMPLATE.read_text(encoding="utf-8")), encoding="utf-8")
    ours = {engine.name for engine in run_report.engines if engine.is_ours}
    return report([fault for row in run_report.rows for fault in row.faults(ours)])


if __name__ == "__main__":
    run(main)
