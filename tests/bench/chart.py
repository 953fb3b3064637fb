# SPDX-License-Identifier: GPL-3.0-or-later
"""The times of families of rows against their sizes, as a drawing of four panels, by gnuplot."""

import re
import subprocess

from measuring import UsageError

PANELS = {"stars": ("stars of n and of 100 vertices", "m"),
          "simple polygons": ("simple polygons of n and of 100 vertices", "m"),
          "combs": ("combs of n vertices, small convex polygons", "m"),
          "nesting": ("nesting: no-fit polygons of all pairs of parts", "sum_vertices")}
COLOURS = ["#000000", "#d55e00", "#e69f00", "#0072b2", "#56b4e9", "#009e73"]


def curves(run_report, rows):
    """Of each: its title, and the engines of which the fastest counts, with coordinates evaluated."""
    def of(name, engines, setting="libraries"):
        version = re.search(name.replace(".", r"\.") + r" ([\d.]+)", run_report.setting.get(setting, ""))
        return f"{name} {version[1]}" if version else name, engines

    peers = {engine.name for engine in run_report.engines if not engine.is_ours and not engine.rounds}
    newest = {name for name in peers if name.endswith("newest")}
    return [("oplus", {"slide", "oplus-nfp"} & {"oplus-nfp" if rows[0].of("oplus-nfp") else "slide"}),
            of("CGAL", peers - newest), of("CGAL", newest, "newest"), of("Clipper", {"clipper", "clipper-nfp"}),
            of("Clipper2", {"clipper2", "clipper2-nfp"}, "newest"), of("Boost.Polygon", {"boost-polygon"})]


def points(rows, engines, size):
    """Sizes and least seconds; none where none of the engines was done."""
    found = []
    for row in rows:
        times = [m.numbers.get("seconds_evaluated", m.numbers["seconds"]) for name in engines if (m := row.done(name))]
        if times and (x := row.number(size)):
            found.append((x, min(times)))
    return sorted(found)


def script(run_report, output):
    lines = [f'''set terminal svg size 960,800 background "white" font "sans-serif,12"
set output "{output}"
set multiplot layout 2,2
set logscale xy
set format y "10^{{%T}}"
set format x "10^{{%T}}"
set mxtics 1
set mytics 1
set grid
set key above maxrows 2 reverse Left samplen 2
set ylabel "seconds"''']
    lines += [f'set style line {i} linecolor rgb "{colour}" pointtype 7 pointsize 0.4 linewidth {2 if i == 1 else 1}'
              for i, colour in enumerate(COLOURS, 1)]
    for group, (title, size) in PANELS.items():
        plots, rows = [], run_report.group(group)
        for i, (name, engines) in enumerate(curves(run_report, rows) if rows else (), 1):
            if of_curve := points(rows, engines, size):
                data = f"$data{len(lines)}_{i}"
                lines.append(f"{data} << EOD\n" + "".join(f"{x:g} {y:g}\n" for x, y in of_curve) + "EOD")
                how = "points" if size == "sum_vertices" else "linespoints"
                plots.append(f'{data} with {how} linestyle {i} title "{name}"')
        if plots:
            x = "vertices of all no-fit polygons" if size == "sum_vertices" else "n"
            lines.append(f'set title "{title}"\nset xlabel "{x}"\nplot ' + ", ".join(plots))
    return "\n".join(lines) + "\nunset multiplot\n"


def draw(run_report, output):
    """Throws UsageError."""
    try:
        subprocess.run(["gnuplot"], input=script(run_report, output), text=True, check=True, capture_output=True)
    except FileNotFoundError:
        raise UsageError("gnuplot is missing (package gnuplot-nox)") from None
    except subprocess.CalledProcessError as wrong:
        raise UsageError(f"gnuplot: {wrong.stderr.strip()}") from None
