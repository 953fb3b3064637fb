#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures chapter 6 of the thesis again: tables and plots, by oplus-bench, each engine on each pair in a process of its
own. `rca` is the thesis's RCA, `winding` its CWEIN. T is the time of all stages except the output, as there.

Exit code: 0 everything is written, 1 engines disagree, or an engine of oplus crashed or failed, 2 invalid usage, or a
file that cannot be written, 4 tables are written, but gnuplot is missing or fails."""

import argparse
import math
import os
import shutil
import statistics
import subprocess
import sys
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

from measuring import (PROGRAM, Measurement, Program, Row, UsageError, measure, report, run, setting, table_of,
                       three_digits, to_csv)

# Table 6.1: T_W and T_RC in seconds, A_W and A_RC. Those in tests/data are measured.
TABLE_6_1 = {"cavity": (0.001, 0.002, 161, 81), "chain": (0.025, 0.013, 2868, 801), "comb": (0.006, 0.009, 651, 579),
             "conc_chain": (0.017, 0.004, 3543, 74), "fork": (0.185, 0.322, 22063, 6154),
             "knife": (0.066, 0.028, 9749, 2946), "rand3015": (0.01, 0.005, 2309, 426),
             "random": (0.02, 0.01, 4698, 831), "stars": (0.031, 0.014, 5482, 791)}

STAGES = "\n".join(f"""
Stages of `{engine}` ({of_thesis}) in milliseconds, the share of that time in which a processor was busy, and the number of tests.

{{{{
pair = what
cycles = 1000 {engine}.cycles
arrangement = 1000 {engine}.arrangement
hierarchy = 1000 {engine}.hierarchy
hole test = 1000 {engine}.hole_test
degenerate = 1000 {engine}.degenerate
output = 1000 {engine}.output
busy = 1 {engine}.busy
hole tests = {engine}.hole_tests
point tests = {engine}.point_tests
}}}}""" for engine, of_thesis in (("rca", "RCA"), ("winding", "CWEIN")))

ENGINE_TABLES = """
m and n: vertices of P and Q. RC: `rca`. W: `winding`. A: edges of the arrangement. T: time of all stages except the output.

{{
pair = what
m = m
n = n
holes = sum_holes
A_RC = rca.edges
A_W = winding.edges
T_RC, ms = 1000 rca.time
T_W, ms = 1000 winding.time
T_RC / T_W = 1 ratio
with output = 1 ratio_with_output
peak RC, MB = 1 rca.peak_mb
peak W, MB = 1 winding.peak_mb
same sum = same_sum
RC = rca.outcome
W = winding.outcome
}}
""" + STAGES

TABLE_6_1_PAGE = ENGINE_TABLES + """

Compared with the thesis.

{{
pair = what
A_RC as in the thesis = same_rca_edges
A_W as in the thesis = same_winding_edges
the thesis's T_RC / T_W = 1 thesis_ratio
}}"""

HOLE_TESTS_PAGE = """
Candidates: the questions of `rca`, about faces. Edges: one question per edge of its arrangement. Methods are in the order of their time per question, and of their time for preparing and all questions.

{{
pair = what
m = m
n = n
about = about
questions = questions
measured = asked
holes = holes
others = others
order per question = order
order in all = order_of_all
}}

Microseconds to prepare, and per question, by its answer.

{{
pair = what
about = about
""" + "\n".join(f"{name}: prepare = 1e6 {name}.prepare; hole = 1e6 {name}.hole; other = 1e6 {name}.other"
                for name in ("bvh", "sweep", "naive", "ray")) + "\n}}"

CYCLES_PAGE = """
K: segments of the convolution. Naive: by the definition, 2nm pairs. Times in milliseconds. Without points: the origins of the segments, without coordinates.

{{
family = family
m = m
n = n
K = segments
cycles = cycles
steps = steps
steps / (n+m+K) = 1 steps_by_bound
2nm / steps = 1 pairs_by_steps
naive = 1000 naive.seconds
tracing = 1000 traced.seconds
without points = 1000 without-points.seconds
naive / tracing = 1 factor
naive / without points = 1 no_points_factor
same segments = same_segments
}}"""


# What compares the engines of a row: its words and numbers.

def compare_sums(row):
    rca, winding = row.done("rca"), row.done("winding")
    if row.subject == "table-6.1":
        for engine, edges in (("rca", row.number("rca.edges")), ("winding", row.number("winding.edges"))):
            if edges is not None:
                row.words[f"same_{engine}_edges"] = str(edges == row.numbers[f"thesis_{engine}_edges"]).lower()
    if rca and winding:
        row.words["same_sum"] = str(rca.digest == winding.digest).lower()
        row.numbers["ratio"] = row.number("rca.time/winding.time")
        row.numbers["ratio_with_output"] = ((rca.numbers["time"] + rca.numbers["output"]) /
                                            (winding.numbers["time"] + winding.numbers["output"]))


def compare_cycles(row):
    """Compares the steps with their bound n + m + K, and with the number of pairs that the definition tests."""
    traced = row.done("traced")
    if not traced:
        return
    of = row.numbers
    of.update((name, traced.numbers[name]) for name in ("m", "n", "segments", "cycles", "steps"))
    of["pairs"] = 2 * of["m"] * of["n"]
    of["steps_by_bound"] = of["steps"] / (of["m"] + of["n"] + of["segments"])
    of["pairs_by_steps"] = of["pairs"] / of["steps"]
    for name, engine in (("factor", "traced"), ("no_points_factor", "without-points")):
        if (factor := row.number(f"naive.seconds/{engine}.seconds")) is not None:
            of[name] = factor
    if len(row.exact()) > 1:
        row.words["same_segments"] = str(not row.disagreement()).lower()


def compare_hole_tests(row):
    for name, column in (("order", "question"), ("order_of_all", "all")):
        times = [(time, m.engine) for m in row.measurements if (time := row.number(f"{m.engine}.{column}")) is not None]
        row.words[name] = " < ".join(engine for _, engine in sorted(times))


# The lines of the index.

def points(rows, x, y):
    """The numbers x and y of the rows that have both."""
    return [(row.number(x), row.number(y)) for row in rows
            if row.number(x) is not None and row.number(y) is not None]


@dataclass
class Fit:
    """A polynomial by least squares, as the thesis fits its measurements (Section 6.2.4)."""
    constant: float
    linear: float
    quadratic: float
    r_squared: float

    def formula(self):
        return f"{self.constant:e} + ({self.linear:e})*x + ({self.quadratic:e})*x**2"


def residuals(x, y):
    """y minus its fitted line in x."""
    slope, constant = statistics.linear_regression(x, y)
    return [b - constant - slope * a for a, b in zip(x, y)]


def fitted(degree, of):
    """A line (1) or a parabola (2). None unless there are more different x than coefficients: with fewer, R² is
    always 1."""
    if len({x for x, _ in of}) < degree + 2:
        return None
    x, y = map(list, zip(*of))
    squares = [a * a for a in x]
    # By lines only (Frisch, Waugh and Lovell): the slope of the residuals of y over those of x².
    quadratic = (statistics.linear_regression(residuals(x, squares), residuals(x, y)).slope if degree == 2 else 0.0)
    rest = [b - quadratic * square for b, square in zip(y, squares)]
    linear, constant = statistics.linear_regression(x, rest)
    total = statistics.pvariance(y)
    return Fit(constant, linear, quadratic,
               1 - statistics.pvariance(residuals(x, rest)) / total if total else 1.0)


def ratio_lines(rows):
    """The ratios of rca to winding: the first, the last, and the median."""
    lines = []
    for column, words in (("ratio", ""), ("ratio_with_output", " with output")):
        found = [x for x, _ in points(rows, column, column)]
        if found:
            lines.append(f"T_RC / T_W{words}: {three_digits(found[0])} at the first row, {three_digits(found[-1])} at "
                         f"the last, median {three_digits(statistics.median_high(found))}")
    return lines


def r_squared_line(curve, degree, rows, x, of):
    def r_squared(engine):
        found = fitted(degree, points(rows, x, f"{engine}.{of}"))
        return three_digits(found.r_squared) if found else "too few sizes"
    return f"R² of {curve}: rca {r_squared('rca')}, winding {r_squared('winding')}"


def parabola_lines(rows):
    """The sizes of the arrangements show without a clock whether the work is quadratic."""
    return ratio_lines(rows) + [r_squared_line("a parabola in m through the times", 2, rows, "m", "time"),
                                r_squared_line("one through the arrangements' edges", 2, rows, "m", "edges")]


def line_lines(rows):
    lines = ratio_lines(rows) + [r_squared_line("a line in A_W through the times", 1, rows, "winding.edges", "time")]
    rca, winding = (fitted(1, points(rows, "winding.edges", f"{engine}.time")) for engine in ("rca", "winding"))
    if rca and winding:
        lines.append(f"slope, microseconds per edge of A_W: rca {three_digits(1e6 * rca.linear)}, winding "
                     f"{three_digits(1e6 * winding.linear)}; winding / rca "
                     f"{three_digits(winding.linear / rca.linear)}")
    return lines


def thesis_lines(rows):
    def count(word):
        return sum(row.words.get(word) == "true" for row in rows)
    skipped = sum(not row.engines for row in rows)
    return [f"{len(rows) - skipped} pairs measured, {skipped} skipped: not published",
            f"A_RC is as in the thesis in {count('same_rca_edges')} of them, A_W in {count('same_winding_edges')}"]


def cycle_lines(rows):
    return ["steps / (n + m + K) is at most " +
            three_digits(max((row.numbers.get("steps_by_bound", 0) for row in rows), default=0))]


def hole_test_lines(rows):
    orders = Counter(f"{row.words['about']}: {row.words['order']}" for row in rows if row.words["order"])
    return [f"per question about {order}, {count} pair{'s' * (count != 1)}" for order, count in sorted(orders.items())]


# Plots: scripts of gnuplot.

def plot(name, title, xlabel, ylabel, curves, more="set xrange [0:]\nset yrange [0:]"):
    return f"""# Written by tests/bench/experiments.py; gnuplot {name}.gp writes {name}.svg.
set terminal svg size 720,432 dynamic background "white" font "sans-serif,13"
set output "{name}.svg"
set datafile separator comma
set datafile columnheaders
# Otherwise rows of other series would interrupt the lines.
set datafile missing NaN
set key above
set grid
set style line 1 linecolor rgb "#0072b2" pointtype 7 pointsize 0.5
set style line 2 linecolor rgb "#d55e00" pointtype 7 pointsize 0.5
set style line 3 linecolor rgb "#009e73" pointtype 7 pointsize 0.5
set style line 4 linecolor rgb "#cc79a7" pointtype 7 pointsize 0.5
set style line 5 linecolor rgb "#999999" pointtype 7 pointsize 0.5
set style line 6 linecolor rgb "#e69f00" pointtype 7 pointsize 0.5
set title "{title}"
set xlabel "{xlabel}"
set ylabel "{ylabel}"
{more}
plot {', '.join(curves)}
"""


def line(experiment, x, y, style, title):
    return f'"{experiment}.csv" using "{x}":{y} smooth unique with linespoints linestyle {style} title "{title}"'


def times_with_fit(figure, title, experiment, rows, x, of_x, degree):
    """Times of rca and winding; x is a column of the table, and of_x the number."""
    curves = []
    for style, (engine, words) in enumerate((("rca", "RCA (rca)"), ("winding", "CWEIN (winding)")), 1):
        fit = fitted(degree, points(rows, of_x, engine + ".time"))
        curves += [f'"{experiment}.csv" using "{x}":"{engine}_time" with points linestyle {style} title "{words}"',
                   f'{fit.formula() if fit else "NaN"} with lines linestyle {style} notitle']
    xlabel = "vertices of P" if x == "m" else "edges of the full convolution's arrangement"
    return plot(figure, f"{figure.replace('f', 'F', 1).replace('-', ' ')}: {title}", xlabel, "seconds, without output",
                curves)


def stages(figure, title, experiment, engine):
    # No hierarchy of winding: it only builds one for low-dimensional features.
    names = ["arrangement", "hole_test", "degenerate", "cycles", "output", "hierarchy"][:6 if engine == "rca" else 5]
    return plot(figure, title, "vertices of P", "seconds",
                [line(experiment, "m", f'"{engine}_{name}"', style, name.replace("_", " "))
                 for style, name in enumerate(names, 1)])


def two_lines(figure, title, experiment, ylabel, columns, titles=("RCA (rca)", "CWEIN (winding)")):
    return plot(figure, title, "vertices of P", ylabel,
                [line(experiment, "m", f'"{column}"', style, words)
                 for style, (column, words) in enumerate(zip(columns, titles), 1)])


def peak_memory(figure, title, experiment):
    return two_lines(figure, title, experiment, "peak memory, MB", ("rca_peak_mb", "winding_peak_mb"))


def by_family(name, title, ylabel, column):
    return plot(name, title, "vertices of P", ylabel,
                [line("cycles", "m", f'(of("{family}"))', style, family)
                 for family, style in (("convex", 1), ("simple", 3), ("star", 2), ("fork", 4))],
                f'set logscale xy\nof(family) = strcol("family") eq family ? column("{column}") : NaN')


def question_times(name, title, xlabel, family):
    return plot(name, title, xlabel, "microseconds per question",
                [line("hole-tests", "size", f'(microseconds("{method}"))', style, method)
                 for method, style in (("bvh", 1), ("sweep", 2), ("naive", 5), ("ray", 3))],
                f'set logscale xy\nmicroseconds(method) = strcol("family") eq "{family}" && strcol("about") eq '
                f'"candidates" ? \\\n                       1e6 * column(method."_question") : NaN')


def plots_of(name, rows):
    """Scripts by their names; those of which nothing was measured are left out."""
    has_ratio = any("ratio" in row.numbers for row in rows)
    if name == "convex-star" and has_ratio:
        return {"figure-6.9": times_with_fit("figure-6.9", "convex and star", name, rows, "winding_edges",
                                             "winding.edges", 1),
                "figure-6.20a": peak_memory("figure-6.20a", "Figure 6.20 (a): convex and star", name)}
    if name == "star-star" and has_ratio:
        return {"figure-6.10": times_with_fit("figure-6.10", "star and star", name, rows, "m", "m", 2)}
    if name == "simple-simple" and has_ratio:
        title = "simple and simple"
        return {"figure-6.11": times_with_fit("figure-6.11", title, name, rows, "m", "m", 2),
                "figure-6.12": stages("figure-6.12", f"Figure 6.12: {title}, stages of CWEIN", name, "winding"),
                "figure-6.13": stages("figure-6.13", f"Figure 6.13: {title}, stages of RCA", name, "rca"),
                "figure-6.20b": peak_memory("figure-6.20b", f"Figure 6.20 (b): {title}", name)}
    if name == "fork-l" and has_ratio:
        return {"figure-6.14": two_lines("figure-6.14", "Figure 6.14: fork and L", name, "seconds, without output",
                                         ("rca_time", "winding_time")),
                "figure-6.15": stages("figure-6.15", "Figure 6.15: fork and L, stages of CWEIN", name, "winding"),
                "figure-6.16": stages("figure-6.16", "Figure 6.16: fork and L, stages of RCA", name, "rca"),
                "fork-ratio": two_lines("fork-ratio", "Fork and L: how much slower RCA is", name,
                                        "time of rca / time of winding", ("ratio", "ratio_with_output"),
                                        ("without output", "with output"))}
    if name == "hole-tests":
        asked = {row.words["family"] for row in rows if row.number("bvh.question") is not None}
        every = {"simple": question_times("hole-tests-simple", "Hole tests, simple", "vertices of P", "simple"),
                 "fork": question_times("hole-tests-fork", "Hole tests, fork", "teeth an arm", "fork")}
        return {f"hole-tests-{family}": script for family, script in every.items() if family in asked}
    if name == "cycles":
        every = {"factor": by_family("cycles-factor", "Naive time / tracing time", "naive time / tracing time",
                                     "factor"),
                 "pairs_by_steps": by_family("cycles-steps", "Pairs of the definition / steps", "2nm / steps",
                                             "pairs_by_steps")}
        return {{"factor": "cycles-factor", "pairs_by_steps": "cycles-steps"}[column]: script
                for column, script in every.items() if any(column in row.numbers for row in rows)}
    return {}


# The experiments.

@dataclass
class Experiment:
    what: str
    title: str
    summary: Callable
    columns: list = None  # the first ones of its table
    page: str = ENGINE_TABLES
    compare: Callable = compare_sums


OF_SUMS = ["m", "n", "sum_chains", "sum_holes", "sum_edges", "sum_dangling", "sum_isolated", "same_sum", "ratio",
           "ratio_with_output", "rca_outcome", "winding_outcome"]
OF_SIZES = ["size", "pair", *OF_SUMS]
EXPERIMENTS = {
    "table-6.1": Experiment(
        "Wein's pairs, those that are published (Table 6.1)", "Table 6.1: the published pairs", thesis_lines,
        ["name", "thesis_rca_edges", "thesis_winding_edges", "thesis_rca_time", "thesis_winding_time", "thesis_ratio",
         "same_rca_edges", "same_winding_edges", *OF_SUMS], TABLE_6_1_PAGE),
    "convex-star": Experiment("Convex P grows, Q a star of 100 vertices (Figures 6.9 and 6.20a)",
                              "Convex P, star-shaped Q of 100 vertices", line_lines, OF_SIZES),
    "star-star": Experiment("Star-shaped P grows, Q a star of 100 vertices (Figure 6.10)",
                            "Star-shaped P, star-shaped Q of 100 vertices", parabola_lines, OF_SIZES),
    "simple-simple": Experiment("Simple P grows, Q is simple with 100 vertices (Figures 6.11 to 6.13 and 6.20b)",
                                "Simple P, simple Q of 100 vertices", parabola_lines, OF_SIZES),
    "fork-l": Experiment("A fork grows, Q is an L (Figures 6.14 to 6.16)", "Fork and L", ratio_lines, OF_SIZES),
    "hole-tests": Experiment(
        "The four hole tests on the questions of rca (Section 5.3)", "Hole tests", hole_test_lines,
        ["name", "family", "size", "about", "m", "n", "questions", "asked", "holes", "others", "order", "order_of_all"],
        HOLE_TESTS_PAGE, compare_hole_tests),
    "cycles": Experiment(
        "Cycle tracing and all pairs of an edge and a vertex (Theorem 4.1.10)",
        "Cycle tracing, and all pairs of an edge and a vertex", cycle_lines,
        ["family", "size", "m", "n", "segments", "cycles", "steps", "pairs", "steps_by_bound", "pairs_by_steps",
         "factor", "no_points_factor", "same_segments"], CYCLES_PAGE, compare_cycles)}


def rows_of(program, name):
    """The rows of oplus-bench, with what their names say."""
    rows = [row for row in program.rows if row.subject == name]
    for row in rows:
        parts = row.name.removeprefix(name + "_").split("_")
        if name == "hole-tests":
            row.words = {"name": row.what, "family": parts[0], "about": parts[2]}
            row.numbers = {"size": int(parts[1]) if parts[1].isdigit() else 0}
        elif name != "table-6.1":
            row.words = {"family": parts[0]} if name == "cycles" else {}
            row.numbers = {"size": int(parts[-1]), "pair": 1}
    if name != "table-6.1":
        return rows
    there = {row.what: row for row in rows}
    every = [there.get(pair, Row(f"table-6.1_{pair}", what=pair, subject=name)) for pair in TABLE_6_1]
    for row in every:
        t_w, t_rc, a_w, a_rc = TABLE_6_1[row.what]
        row.words = {"name": row.what}
        row.numbers = {"thesis_rca_edges": a_rc, "thesis_winding_edges": a_w, "thesis_rca_time": t_rc,
                       "thesis_winding_time": t_w, "thesis_ratio": t_rc / t_w}
        if not row.engines:
            row.measurements = [Measurement(engine, "unsupported", "missing") for engine in ("rca", "winding")]
    return every


def page_of(experiment, rows):
    parts = experiment.page.replace("}}", "{{").split("{{")  # words and tables take turns
    return f"# {experiment.title}\n" + "".join(table_of(rows, part) if i % 2 else part
                                               for i, part in enumerate(parts)).rstrip("\n") + "\n"


def draw_all(folder, names):
    """Each NAME.gp writes NAME.svg; says in one line what failed. Whether all are drawn."""
    if names and shutil.which("gnuplot") is None:
        print(f"experiments.py: gnuplot is missing (package gnuplot-nox): {len(names)} plots not drawn; tables and scripts "
              f"are in {folder}", file=sys.stderr)
        return False
    failed = [name for name in names
              if subprocess.run(["gnuplot", name + ".gp"], cwd=folder, capture_output=True).returncode != 0]
    if failed:
        print("experiments.py: gnuplot failed on " + " ".join(failed), file=sys.stderr)
    return not failed


def number(least, most, kind):
    def checked(text):
        value = kind(text)
        if not least <= value <= most:
            raise ValueError
        return value
    checked.__name__ = f"number from {least} to {most}"
    return checked


def main():
    names = "\n".join(f"  {name:14}{experiment.what}" for name, experiment in EXPERIMENTS.items())
    parser = argparse.ArgumentParser(description=__doc__ + "\n\nExperiments:\n" + names,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", metavar="NAME", action="append", choices=EXPERIMENTS,
                        help="one experiment; may be repeated; default: all")
    parser.add_argument("--scale", type=number(0, 1000, float), default=1.0,
                        help="multiplies the largest size of each family; 0: only the smallest (1)")
    parser.add_argument("--seed", type=number(0, 2**53, int), default=1, help="same seed, same pairs (1)")
    parser.add_argument("--memory", type=number(0, 10**9, int), default=8000,
                        help="memory limit of a measurement in MB; 0: unlimited; one that needs more is reported as a "
                             "row (8000)")
    parser.add_argument("--min-time", type=number(0, math.inf, float), default=0, help=argparse.SUPPRESS)
    parser.add_argument("--out", metavar="DIR", type=Path, default=Path("oplus-experiments"),
                        help="folder for tables, plots and index.md (oplus-experiments)")
    parser.add_argument("--program", metavar="FILE", type=Path, default=PROGRAM, help=f"oplus-bench ({PROGRAM})")
    given = parser.parse_args()
    program = Program(given.program, [f"--seed={given.seed}", f"--scale={given.scale}"])
    given.out.mkdir(parents=True, exist_ok=True)
    faults, plots, entries = [], [], []

    def write(name, text):
        (given.out / name).write_text(text, encoding="utf-8")

    for name, experiment in EXPERIMENTS.items():
        if given.only and name not in given.only:
            continue
        rows = rows_of(program, name)
        for row in rows:
            measure(program, row, row.engines, min_time=given.min_time, memory_mb=given.memory)
            experiment.compare(row)
        wrong = [fault for row in rows for fault in row.faults(program.ours())]
        write(name + ".csv", to_csv(rows, experiment.columns))
        write(name + ".md", page_of(experiment, rows))
        drawn = plots_of(name, rows)
        for plot_name, script in drawn.items():
            write(plot_name + ".gp", script)
        entries.append(f"\n## {name}\n{experiment.what}. [Table]({name}.md), [CSV]({name}.csv)\n\n" +
                       "".join(f"- {summary}\n" for summary in experiment.summary(rows)) +
                       "".join(f"- **wrong:** {fault}\n" for fault in wrong) +
                       "".join(f"\n![{plot_name}]({plot_name}.svg)\n" for plot_name in drawn))
        plots += drawn
        faults += wrong
    machine = setting(program.context, "")
    write("index.md", f"# Experiments\n\nWritten by `tests/bench/experiments.py`, seed {given.seed}, scale "
          f"{three_digits(given.scale)}, commit {machine['commit']}. {machine['processor']}, {machine['cores']} cores, of "
          f"which one is used; load {three_digits(os.getloadavg()[0])} at its end. The peak resident memory of a "
          f"process that measures nothing is {three_digits(program.peak_mb)} MB.\n" + "".join(entries))
    all_drawn = draw_all(given.out, plots)
    print(f"index: {given.out / 'index.md'}")
    return report(faults) or (0 if all_drawn else 4)


if __name__ == "__main__":
    run(main)
