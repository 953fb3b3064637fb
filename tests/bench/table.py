#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures oplus, CGAL, Clipper, Clipper2 and Boost.Polygon on the same pairs, by oplus-bench and oplus-bench-newest: each
engine on each row in a process of its own, one after another; and compares the results. `bash docs/renew benchmarks`
builds both, measures all, and writes docs/benchmarks.md.

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

import chart
import large
import python_calls
from measuring import (PROGRAM, REPETITIONS, Engine, Measurement, Program, Row, UsageError, instead_of_number,
                       markdown, measure, plain, report, run, setting, table_of, three_digits)

SUBJECTS = ("sums", "growth", "commands", "certificates", "proved", "distances", "places", "nesting")  # the page's sections
SCRIPTS = {"large": large.rows, "calls": python_calls.rows}  # rows by these names are not of oplus-bench
LONGER = {"proved": 3}  # times the limit, as CGAL's full convolution takes longer than the proved program
BASES = ("oplus-nfp", "oplus-batch", "oplus-sum", "slide")  # what others are compared with: the first that a row has
TEMPLATE = Path(__file__).parent / "pages/benchmarks.md"
IN_README = ("star_300_star_100", "fork_50", "small_pairs")


@dataclass
class Ratio:
    """Of measured numbers, with the least and the most that the repetitions allow. For an engine that was stopped it is
    a lower bound."""
    value: float
    is_lower_bound: bool = False
    least: float = None
    most: float = None

    def __str__(self):
        shown = ("> " if self.is_lower_bound else "") + three_digits(self.value)
        spread = [three_digits(x) for x in (self.least, self.most) if x is not None]
        return shown + (f" ({' to '.join(spread)})" if len(set(spread)) > 1 else "")


def ratio(row, engine, base, number="seconds"):
    """The engine's number divided by that of `base`; None if one of them has no such number. Seconds are evaluated if the
    engine leaves coordinates unevaluated, and "seconds_evaluated" are asked for."""
    m, of_base = row.of(engine), row.done(base)
    is_time = number.startswith("seconds")
    under = of_base.numbers if of_base else {}
    below = "seconds" if is_time else number
    if m is None or not under.get(below):
        return None
    if m.outcome == "over the limit":
        over = m.numbers.get("limit" if is_time else number)
        return Ratio(over / under[below], True) if over else None
    number = number if number in m.numbers else below
    if not m.is_done() or number not in m.numbers:
        return None
    value = m.numbers[number]
    least, most = (m.numbers.get(number + end, value) / under.get(below + other_end, under[below])
                   for end, other_end in (("_least", "_most"), ("_most", "_least")))
    return Ratio(value / under[below], False, least, most)


def smallest(ratios):
    return min((one for one in ratios if one), key=lambda one: one.value, default=None)


def geometric_mean(ratios):
    """A lower bound if one of them is; None of none."""
    logarithms = [math.log(one.value) for one in ratios if one]
    if not logarithms:
        return None
    return Ratio(math.exp(sum(logarithms) / len(logarithms)), any(one and one.is_lower_bound for one in ratios))


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

    def peers(self, exact):
        return [engine.name for engine in self.engines if not engine.is_ours and engine.rounds != exact]

    def peers_on(self, row):
        """Of other libraries: engine, ratio of its call, and of that with evaluated coordinates."""
        base = next((name for name in BASES if row.done(name)), "")
        return [(name, found, ratio(row, name, base, "seconds_evaluated"))
                for name in self.peers(True) + self.peers(False) if (found := ratio(row, name, base))]

    def exact_peer(self, row, number):
        """The least ratio of the exact ones."""
        exact, place = self.peers(True), 1 if number == "seconds" else 2
        return smallest(found[place] for found in self.peers_on(row) if found[0] in exact)


# Goals: rows of a table, (text, measured, reached).

def goal(text, bound, found, at_least=False):
    """`found` are ratios and what they are of. All of them must be at most the bound, or at least. A lower bound may
    decide nothing."""
    found = [(value if isinstance(value, Ratio) else Ratio(value), what) for value, what in found if value is not None]
    if not found:
        return [text, "", "not measured"]
    wrong = [one for one in found
             if (not one[0].is_lower_bound and one[0].value < bound if at_least else one[0].value > bound)]
    unknown = [one for one in found if one[0].is_lower_bound and (one[0].value < bound if at_least else True)]
    worst, what = (min if at_least else max)(wrong or found, key=lambda one: one[0].value)
    count = f"; not on {len(wrong)} of {len(found)}" if wrong and len(found) > 1 else ""
    return [text, f"{worst}{', ' if what else ''}{what}{count}", "**no**" if wrong else "not measured" if unknown else "yes"]


def goals_of(run_report):
    of, named = run_report.of, run_report.named
    sums, nesting, certificates = of("sums"), of("nesting"), of("certificates")

    def numbers(rows, path, factor=1):
        return [(factor * value, row.what) for row in rows if (value := row.number(path)) is not None]

    def ratios_to(base, engine, rows):
        return [(ratio(row, engine, base), row.what) for row in rows]

    def beyond(spare, base, engine, rows):
        """After `spare` seconds are taken off."""
        return [(Ratio(max(found.value - spare / row.number(base + ".seconds"), 0), found.is_lower_bound), row.what)
                for row in rows if (found := ratio(row, engine, base))]

    def least(bound, text, found):
        return goal(text, bound, found, at_least=True)

    goals = []
    for rows, what, each, mean in ((sums, "pairs", 3, 15), (nesting, "nesting, whole commands", 10, 15)):
        for number, words in (("seconds_evaluated", ", coordinates evaluated"), ("seconds", ", its call alone")):
            words = words if rows is sums else ""
            exact = [(run_report.exact_peer(row, number), row.what) for row in rows]
            goals += [least(mean, f"{what}: at least {mean} times the faster exact peer, geometric mean{words}",
                            [(geometric_mean([one for one, _ in exact]), "")]),
                      least(each, f"{what}: at least {each} times the faster exact peer on each row{words}", exact)]
            if rows is nesting:
                break
    rounding = run_report.peers(exact=False)
    return goals + [
        least(1, "pairs: no other library is faster",
              [(found, f"{row.what}: {name}") for row in sums for name, found, _ in run_report.peers_on(row)]),
        least(1, "nesting, whole commands: no library that rounds is faster",
              [(found, f"{row.what}: {name}") for row in nesting for name, found, _ in run_report.peers_on(row)
               if name in rounding]),
        goal("sums without holes: at most 1 µs per segment of the reduced convolution", 1,
             numbers([row for row in run_report.rows if row.group != "hard" and not row.number("slide.sum_holes")],
                     "slide.seconds/slide.segments", 1e6)),
        goal("hard pairs: at most 3 µs per segment of the reduced convolution", 3,
             numbers(run_report.group("hard"), "slide.seconds/slide.segments", 1e6)),
        goal("open sums: at most 1.5 times the time of closed ones", 1.5, ratios_to("slide", "slide-open", sums)),
        goal("verify: at most 10 times the time of slide", 10, ratios_to("slide", "verify", sums)),
        goal("whole command: at most 1.3 times the call, and 5 ms", 1.3, beyond(0.005, "slide", "oplus-sum", of("commands"))),
        least(50_000, "small pairs, the whole command `oplus batch`: at least 50,000 a second",
              [(row.pairs / seconds, "") for row in named("command_small_pairs")
               if (seconds := row.number("oplus-batch.seconds"))]),
        goal("two polygons of 10 vertices: at most 3 µs in C++", 3,
             numbers(named("calls_10") + named("calls_convex_10"), "cpp.seconds", 1e6)),
        goal("two polygons of 10 vertices: at most 6 µs in Python, in a batch call", 6,
             numbers(named("calls_10") + named("calls_convex_10"), "batch.seconds", 1e6)),
        least(1.7, "two threads: at least 1.7 times one, from 10,000 vertices on", ratios_to("slide2", "slide", of("growth"))),
        goal("10^6 vertices: at most 1.2 times the time per vertex of 10^5", 1.2,
             numbers(of("large"), "large.seconds/small.seconds", large.SMALL / large.LARGE)),
        goal("10^6 vertices: at most 200 bytes a vertex in sum and verify", 200,
             numbers(named("large_sum") + named("large_verify"), "large.process_mb/large.vertices", 1e6)),
        least(1, "certificates: checked at least as fast as CGAL's program sums",
              ratios_to("oplus-certified", "cgal-sum", certificates)),
        goal("certificates: made in at most 4 times `oplus sum`, and 0.05 s", 4,
             beyond(0.05, "oplus-sum", "sum-certificate", certificates)),
        goal("certificates: at most 100 bytes by gzip per segment of the reduced convolution", 100,
             numbers(certificates, "sum-certificate.zipped_bytes/slide.segments")),
        goal("the proved program: stars of 30 and 30 in at most 0.02 s", 0.02,
             numbers(named("proved_star_30_star_30"), "oplus-proved.seconds")),
        goal("the proved program: stars of 60 and 60 in at most 0.1 s", 0.1,
             numbers(named("proved_star_60_star_60"), "oplus-proved.seconds")),
        least(10, "the proved program: stars of 100 and 100 at least 10 times as fast as CGAL's full convolution",
              ratios_to("oplus-proved", "cgal-full", named("proved_star_100_star_100"))),
        goal("distances: at most 50 µs a pair", 50, numbers(of("distances"), "distance.seconds/distance.pairs", 1e6)),
        goal("depths of parts of swim: at most 250 µs a pair", 250,
             numbers(named("distances_swim_overlapping"), "depth.seconds/depth.pairs", 1e6)),
        goal("places: at most 500 ns each", 500, numbers(of("places"), "placements.seconds/placements.places", 1e9))]


# The page.

def faster(run_report):
    """The rows on which another library takes less time, the most at first."""
    rows = [row for subject in ("sums", "nesting", "commands") for row in run_report.of(subject)]
    found = sorted(((found.value, row.what, name, str(found), str(evaluated)) for row in rows
                    for name, found, evaluated in run_report.peers_on(row) if not found.is_lower_bound and found.value < 1))
    return markdown(["row", "engine", "its time / oplus's", "with coordinates evaluated"],
                    [cells for _, *cells in found]) if found else "None was measured."


def ratios(rows, columns, first, of_row, instead=None):
    """A line per row, and one of geometric means per group of several rows. `of_row` gives a ratio or None."""
    head = table_of([], first).splitlines()[0].strip("| ").split(" | ")
    lines = []
    for group, of_group in groupby(rows, key=lambda row: row.group):
        of_group = list(of_group)
        found = [[of_row(row, column) for column in columns] for row in of_group]
        for row, ratios_there in zip(of_group, found):
            begin = table_of([row], first).splitlines()[2].removeprefix("| ").removesuffix(" |").split(" | ")
            lines.append(begin + [str(one) if one else instead_of_number(row.of(column))
                                  for one, column in zip(ratios_there, columns)])
        if len(of_group) > 1:
            means = [geometric_mean(column) for column in zip(*found)]
            lines.append([f"*{group}, geometric mean*"] + [""] * (len(head) - 1) +
                         [f"*{mean}*" if mean else "" for mean in means])
    return markdown(head + columns, lines)


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
    rows, sums, nesting = run_report.rows, run_report.of("sums"), run_report.of("nesting")
    sections = [[engine for engine in sorted(run_report.engines, key=lambda engine: engine.rounds)
                 if any(row.of(engine.name) for row in of_section)] for of_section in (sums, nesting)]
    listed, of_parts = sections[0], [engine.name for engine in sections[1] if engine.name not in ("slide", "oplus-nfp")]
    engines = [engine.name for engine in listed]
    others = [name for name in engines if name != "slide"]
    lazy = [name for name in others if any(row.number(name + ".seconds_evaluated") for row in sums)]
    done = [m for row in rows for m in row.measurements if m.is_done() and "busy" in m.numbers]
    compared = [row for row in rows if len(row.exact()) > 1]

    def beside(base, number):
        return lambda row, engine: (run_report.exact_peer(row, number) if engine == "exact peer" else
                                    ratio(row, engine, base, number))

    def memory(row, engine):
        found = ratio(row, engine, "slide", "peak_mb")
        return found and Ratio(found.value, found.is_lower_bound)

    texts = {**{name: str(value) for name, value in run_report.setting.items()},
             "repetitions": str(REPETITIONS), "measured": str(len(done)),
             "busy": str(sum(m.numbers["busy"] >= 0.95 for m in done)), "compared": str(len(compared)),
             "equal": str(sum(not row.disagreement() for row in compared)), "remarks": remarks(rows),
             "engines": "\n".join(f"- `{engine.name}`: {engine.what}." for engine in listed),
             "goals": markdown(["goal", "measured", "reached"], goals_of(run_report)), "faster": faster(run_report),
             "ratios": ratios(sums, ["exact peer", *others], "time / slide = what", beside("slide", "seconds")),
             "evaluated": ratios(sums, ["exact peer", *lazy], "time / slide = what", beside("slide", "seconds_evaluated")),
             "nesting": ratios(nesting, ["exact peer", *of_parts], "no-fit polygons of all pairs = what; calls alone, ms = "
                               "1000 slide.seconds; oplus batch, ms = 1000 oplus-nfp.seconds", beside("oplus-nfp", "seconds")),
             "memory": ratios(sums, others, "memory / slide = what; slide, MB = 1 slide.peak_mb", memory)}
    tables = {"sums": (sums, engines), "lazy_engines": (sums, lazy),
              "rounding_engines": (sums, [engine.name for engine in listed if engine.rounds]),
              "nesting_peers": (nesting, of_parts),
              **{subject: (run_report.of(subject), ()) for subject in (*SUBJECTS[1:-1], *SCRIPTS)}}
    with_tables = re.sub(r"\{\{#(\w+)\}\}\n(.*?)\{\{/\1\}\}",
                         lambda found: table_of(tables[found[1]][0], found[2], tables[found[1]][1]), template,
                         flags=re.DOTALL)
    return re.sub(r"\{\{(\w+)\}\}", lambda found: texts[found[1]], with_tables)


def readme(run_report, text):
    """With the ratios of some rows in its table."""
    table = [[row.what, three_digits(1000 * row.number("slide.seconds"))] +
             [str(found or "").split(" (")[0]
              for found in (run_report.exact_peer(row, "seconds"), ratio(row, "clipper2", "slide"))]
             for name in IN_README for row in run_report.named(name) if row.done("slide")]
    head = ["sum", "oplus, ms", "the faster CGAL, exact", "Clipper2, which rounds"]
    return re.sub(r"(?m)^\| sum \| oplus.*\n(\|.*\n)+", lambda _: markdown(head, table) + "\n", text)


# The command.

def chosen_rows(program, pattern):
    try:
        # Rows with faults are for tests, and experiments have a command: only by name.
        rows = [row for row in program.rows if re.fullmatch(pattern, row.name)
                and (row.subject in SUBJECTS or pattern == row.name)]
    except re.error as wrong:
        raise UsageError(f"--rows: {wrong}") from None
    if not rows and not any(re.fullmatch(pattern, name) for name in SCRIPTS):
        raise UsageError(f"no row matches {pattern}")
    return rows


def chosen_engines(program, rows, names):
    for name in names or ():
        if name not in program.commands:
            raise UsageError(f"unknown engine {name}; --list shows all")
    return names or list(dict.fromkeys(engine.name for engine in program.engines
                                       if any(engine.name in row.engines for row in rows)))


def measured_report(given, program, command):
    rows = chosen_rows(program, given.rows)
    engines = chosen_engines(program, rows, given.engines and given.engines.split(","))
    run_report = Report({}, program.engines, [])

    def keep(*measured):
        run_report.rows += measured
        run_report.setting = setting(program.context, command)
        if given.json:  # an interrupted run keeps what it has measured
            given.json.write_text(run_report.to_json(), encoding="utf-8")

    for row in rows:
        if set(row.engines) & set(engines):
            measure(program, row, engines, limit=given.limit * LONGER.get(row.subject, 1), min_time=given.min_time)
            keep(row)
    for name, rows_by in SCRIPTS.items():
        if re.fullmatch(given.rows, name) and not given.engines:
            keep(*rows_by(given.program.parent))
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
    return shlex.join(words) if len(words) > 2 else "bash docs/renew benchmarks"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", metavar="REGEX", default=".*", help="only rows whose whole name matches")
    parser.add_argument("--engines", metavar="LIST", help="only these engines, separated by commas")
    parser.add_argument("--limit", type=positive, default=4.0,
                        help="seconds after which a run of another library is stopped (4); of oplus, after ten times as many")
    parser.add_argument("--min-time", type=float, default=0.2,
                        help="least total seconds of an engine's runs (0.2); a run of more than half a second is not repeated")
    parser.add_argument("--list", action="store_true", help="list the rows and the engines")
    parser.add_argument("--json", metavar="FILE", type=Path, help="write the measurements to FILE")
    parser.add_argument("--page", metavar="FOLDER", type=Path,
                        help="write benchmarks.md and benchmarks/sizes.svg there, and the ratios in README.md beside it")
    parser.add_argument("--from", metavar="FILE", dest="file", help="measure nothing, read what --json wrote")
    parser.add_argument("--program", metavar="FILE", type=Path, default=PROGRAM, help=f"oplus-bench ({PROGRAM})")
    given = parser.parse_args()
    if given.file:
        run_report = Report.read(given.file)
    else:
        program = Program(given.program, ["--with-faults"] if given.rows.startswith("faults_") else [])
        if given.list:
            for row in chosen_rows(program, given.rows):
                print(f"{row.name}: {row.what}")
            print(*SCRIPTS, "engines", sep="\n")
            for engine in program.engines:
                print(f"  {engine.name}: {engine.what}")
            return 0
        run_report = measured_report(given, program, command_of(parser, given))
    if given.page:
        (given.page / "benchmarks").mkdir(exist_ok=True)
        chart.draw(run_report, given.page / "benchmarks/sizes.svg")
        (given.page / "benchmarks.md").write_text(page(run_report, TEMPLATE.read_text(encoding="utf-8")), encoding="utf-8")
        beside = given.page.resolve().parent / "README.md"
        if beside.is_file():
            beside.write_text(readme(run_report, beside.read_text(encoding="utf-8")), encoding="utf-8")
    ours = {engine.name for engine in run_report.engines if engine.is_ours} | {"small", "large"}  # those of large.py
    return report([fault for row in run_report.rows for fault in row.faults(ours)])


if __name__ == "__main__":
    run(main)
