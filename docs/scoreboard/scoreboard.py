#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""scoreboard.py --run FOLDER [ENGINE...] | --write | --check: docs/scoreboard.md, which says what `oplus-check
conformance` finds in each library. --run asks the libraries, or only those named, with FOLDER for the reports, records
the results in runs.json, copies the pictures and writes the page; --write writes the page from the record; --check fails unless the page is
that of the record and the pictures are those of the page."""

import json
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

HERE = Path(__file__).resolve().parent
RECORD = HERE / "runs.json"
PAGE = HERE.parent / "scoreboard.md"
ROOT = HERE.parents[1]
BUDGET = 1000  # pairs
PARTS = sorted((ROOT / "tests/data/esicup").glob("*.wkt"))


class Engine(NamedTuple):
    title: str
    called: str
    version: tuple  # a file and the expression that finds the version in it
    command: str = ""  # unless it is the engine's name
    sums_parts: bool = True  # is also asked for the no-fit polygons of parts


def newest(method):
    return f"exec:oplus-peer-newest {method} {{p}} {{q}}"


CGAL = ("/usr/include/CGAL/version.h", r"define CGAL_VERSION (\S+)")
NEWEST = ROOT / "build/release/newest/versions"
NEWEST_CGAL = (NEWEST, r"CGAL (\S+),")
ENGINES = {
    "slide": Engine("oplus, `slide`", "`oplus::minkowski_sum`",
                    (ROOT / "checked/oplus/version.hpp", r"(?s)MAJOR (\d+).*?MINOR (\d+).*?PATCH (\d+)")),
    "cgal-reduced": Engine("CGAL, reduced convolution", "`minkowski_sum_by_reduced_convolution_2`", CGAL),
    "cgal-full": Engine("CGAL, full convolution", "`minkowski_sum_by_full_convolution_2`", CGAL),
    "cgal-vertical": Engine("CGAL, vertical decomposition", "`minkowski_sum_by_decomposition_2`", CGAL,
                            sums_parts=False),
    "cgal-triangulation": Engine("CGAL, triangulation", "`minkowski_sum_by_decomposition_2`", CGAL,
                                 sums_parts=False),
    "cgal-small-side": Engine("CGAL, small side angle bisectors", "`minkowski_sum_by_decomposition_2`", CGAL,
                              sums_parts=False),
    "cgal-reduced-newest": Engine("CGAL, reduced convolution", "`minkowski_sum_by_reduced_convolution_2`", NEWEST_CGAL,
                                  newest("cgal-reduced")),
    "cgal-full-newest": Engine("CGAL, full convolution", "`minkowski_sum_by_full_convolution_2`", NEWEST_CGAL,
                               newest("cgal-full")),
    "cgal-vertical-newest": Engine("CGAL, vertical decomposition", "`minkowski_sum_by_decomposition_2`", NEWEST_CGAL,
                                   newest("cgal-vertical"), sums_parts=False),
    "cgal-triangulation-newest": Engine("CGAL, triangulation", "`minkowski_sum_by_decomposition_2`", NEWEST_CGAL,
                                        newest("cgal-triangulation"), sums_parts=False),
    "cgal-small-side-newest": Engine("CGAL, small side angle bisectors", "`minkowski_sum_by_decomposition_2`",
                                     NEWEST_CGAL, newest("cgal-small-side"), sums_parts=False),
    "clipper": Engine("Clipper 6", "`MinkowskiSum(pattern, paths, …)`",
                      ("/usr/include/polyclipping/clipper.hpp", r'define CLIPPER_VERSION "(\S+)"')),
    "clipper2": Engine("Clipper2", "`MinkowskiSum(pattern, path, …)` for each path, and `Union`",
                       (NEWEST, r"Clipper2 (\S+),"), newest("clipper2")),
    "boost-polygon": Engine("Boost.Polygon", "`convolve_two_polygon_sets`, and the polygon set's union",
                            ("/usr/include/boost/version.hpp", r'define BOOST_LIB_VERSION "(\S+)"')),
}


def cgal(number):
    return f"[CGAL {number}](https://github.com/CGAL/cgal/issues/{number})"


def clipper2(number):
    return f"[Clipper2 {number}](https://github.com/AngusJohnson/Clipper2/issues/{number})"


HOLE_FILTER = (f"{cgal(7304)}, and the cause of {cgal(5839)}; fixed by {cgal(7339)} in CGAL 5.6 "
               "([more](findings.md#cgal-551-the-filter-of-small-holes-uses-iterators-that-are-no-longer-valid)). The "
               "behaviour is undefined, so another run may end in another way.")
UNDEFINED = "crashed: 'std::.*'|out of memory"
LARGE = "none known ([more](findings.md#cgal-551-coordinates-of-10108))."
ROUNDS = "no fault, since it computes with integers ([more](findings.md#clipper-and-boostpolygon-round))."
CLIPPER2 = "[more](findings.md#clipper2-201-a-hole-in-the-sum-of-two-triangles-or-a-polygon-inside-another-one)"
NONE = "none known."
# What the library's own project says about a failure: the kind is an expression.
UPSTREAM = {
    ("cgal-reduced", UNDEFINED): HOLE_FILTER,
    ("cgal-reduced", "crashed: SIGSEGV"): LARGE,
    ("cgal-reduced", "hole lost"):
        f"{cgal(5830)}, fixed by {cgal(7168)} in CGAL 5.6 "
        "([more](findings.md#cgal-551-the-reduced-convolution-loses-a-hole)).",
    ("cgal-full", "crashed: SIGSEGV"):
        f"none known for two polygons. {cgal(8551)} is about a segment and a polygon; its fix does not mend this pair "
        "([more](findings.md#cgal-551-the-full-convolution-crashes-on-small-simple-polygons)).",
    ("cgal-vertical", UNDEFINED): HOLE_FILTER,
    ("cgal-vertical", "crashed: SIGSEGV"): LARGE,
    ("cgal-triangulation", UNDEFINED): HOLE_FILTER,
    ("cgal-triangulation", "crashed: SIGSEGV"): LARGE,
    ("cgal-small-side", "crashed: SIGSEGV"): LARGE,
    ("clipper", "rounded"): ROUNDS,
    ("clipper", "area smaller"):
        "no fault, since it computes with integers: the tip of a notch that is 30 units of the grid wide moves along the "
        "notch, farther than in what is called rounded.",
    ("clipper", "unreadable: an edge goes back along another"):
        "documented: edges of a polygon may touch, unless Clipper is told to be "
        "[StrictlySimple](http://www.angusj.com/delphi/clipper/documentation/Docs/Units/ClipperLib/Classes/Clipper/"
        "Properties/StrictlySimple.htm), which `MinkowskiSum` does not offer. The hole is joined to the outer chain by "
        "an edge that is passed twice; but for rounding the set is right.",
    ("clipper", "unreadable: edges overlap"):
        NONE + " Two of the union's polygons overlap, in a thin triangle. Another union makes them one.",
    ("clipper2", "rounded"): ROUNDS,
    ("clipper2", "hole invented"):
        f"{clipper2(583)}: small polygons beside the right one, explained there by rounding, and {clipper2(1067)}, which "
        f"is open, about unions of thin triangles ({CLIPPER2}).",
    ("clipper2", "unreadable: winding number 2 to the left of an edge"):
        f"the same. A polygon is inside another one and is no hole ({CLIPPER2}).",
    ("boost-polygon", "rounded"): ROUNDS,
    ("boost-polygon", "component lost"): NONE + " The result is empty. The summands are one unit of the grid wide.",
}


def failed(outcome):
    sys.exit(f"scoreboard.py: {outcome}")


def slug(kind):
    return re.sub("[^a-z0-9]+", "-", kind.lower()).strip("-")


def version(engine):
    file, expression = engine.version
    found = re.search(expression, Path(file).read_text(encoding="utf-8"))
    return ".".join(found.groups()).replace("_", ".") if found else failed(f"{file}: no version")


def recorded(report, folder):
    """What of a report is recorded. Copies the pictures from the folder, by whose name they start."""
    failures = {}
    for kind, found in sorted(report["counterexamples"].items()):
        picture = f"{folder.name}-{slug(kind)}.svg"
        shutil.copyfile(folder / next(one for one in found["files"] if one.endswith(".svg")), HERE / picture)
        failures[kind] = {
            "sums": report["all"]["kinds"][kind],
            "in_corpus": sum(one["counts"]["kinds"].get(kind, 0)
                             for one in report["sources"] if one["part"] == "corpus"),
            "of_parts": {one["name"]: one["counts"]["kinds"].get(kind, 0)
                         for one in report["sources"] if one["part"] == "parts"},
            "found_in": found["found_in"],
            "what": found["sum"]["failure"]["what"],
            **found["sum"]["pair"],
            "picture": picture,
        }
    return {"seed": report["campaign"]["seed"], "pairs": report["pairs"], "sums": report["all"]["sums"],
            "failures": failures}


def run(folder, names):
    asked = {"sums": ["--budget", str(BUDGET)],
             "parts": ["--judge", "convex-parts", *(word for file in PARTS for word in ("--parts", str(file)))]}
    reports = {}
    for name in names:
        engine = ENGINES[name]
        for about in ("sums", "parts") if engine.sums_parts else ("sums",):
            out = name if about == "sums" else f"{name}-{about}"
            print(out, flush=True)
            command = ["oplus-check", "conformance", "--engine", engine.command or name, "--seed", "1", *asked[about],
                       "--out", out, "--report", f"{out}.json", "--quiet"]
            code = subprocess.run(command, cwd=folder, stdout=subprocess.DEVNULL, check=False).returncode
            if code not in (0, 1):
                failed(f"{name}: oplus-check exits with {code}")
            reports[about, name] = out
    # What was there stays until all libraries have answered.
    record = json.loads(RECORD.read_text(encoding="utf-8"))
    for (about, name), out in reports.items():
        report = json.loads((folder / f"{out}.json").read_text(encoding="utf-8"))
        record[about][name] = {"version": version(ENGINES[name]), **recorded(report, folder / out)}
    record = {about: {name: runs[name] for name in ENGINES if name in runs} for about, runs in record.items()}
    for old in {picture.name for picture in HERE.glob("*.svg")} - shown(record):
        (HERE / old).unlink()
    RECORD.write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")


def failures_of(record):
    """About what, the engine, the kind, and the failure, in the order of the page."""
    return [(about, name, kind, one) for about, runs in record.items() for name, run_of in runs.items()
            for kind, one in run_of["failures"].items()]


def shown(record):
    """The pictures of the page."""
    return {one["picture"] for *_, one in failures_of(record)}


def summand(wkt):
    if len(wkt) < 120:
        return f"`{wkt}`"
    digits = max(map(len, re.findall("[0-9]+", wkt)))
    return f"a polygon with coordinates of up to {digits} digits (in the record)"


def row(name, run_of):
    sums = run_of["sums"]
    rounded = run_of["failures"].get("rounded", {"sums": 0})["sums"]
    cells = [sums.get("passed", 0), rounded, sums.get("wrong", 0) - rounded, sums.get("crashed", 0),
             sums.get("hung", 0) + sums.get("out of memory", 0), sums.get("unreadable", 0),
             sums.get("refused", 0), sums.get("open unsupported", 0), sums.get("skipped", 0)]
    if sum(cells) != sum(sums.values()):
        failed(f"{name}: an outcome that the table does not have: {', '.join(sums)}")
    return (f"| {ENGINES[name].title} | {run_of['version']} | {ENGINES[name].called} | {run_of['pairs']:,} | "
            + " | ".join(f"{cell:,}" for cell in cells) + " |")


def known(name, kind):
    """The entries of UPSTREAM for a kind of failure; the newest CGAL has those of Debian 12's."""
    return [key for key in UPSTREAM if key[0] == name.removesuffix("-newest") and re.fullmatch(key[1], kind)]


def failure(about, name, kind, one):
    entries = known(name, kind)
    if len(entries) != 1:
        failed(f"UPSTREAM has {len(entries)} entries for {name}, {kind}")
    sums = "1 sum" if one["sums"] == 1 else f"{one['sums']:,} sums"
    of_corpus = f" ({one['in_corpus']:,} in the corpus)" if one["in_corpus"] else ""
    what = one["what"].replace("the first", "the right sum").replace("the second", "the given one")
    engine = ENGINES[name]
    return f"""### {engine.title}{', newest' if name.endswith('-newest') else ''}: {kind}{', no-fit polygons' if about == 'parts' else ''}
{sums}{of_corpus}. The smallest pair was found in `{one['found_in']}`. Shrunk:
P: {summand(one['p'])}, Q: {summand(one['q'])}. Result: {what}.

Upstream: {UPSTREAM[entries[0]]}

![P, Q, their convolution, and the right and the given sum if there is one](scoreboard/{one['picture']})
"""


def by_instance(runs):
    """The failures of each kind in each instance."""
    names = [file.stem for file in PARTS]
    lines = [f"| {ENGINES[name].title} | {run_of['version']} | {kind} | "
             + " | ".join(f"{one['of_parts'].get(instance, 0):,}" for instance in names) + " |"
             for name, run_of in runs.items() for kind, one in run_of["failures"].items()]
    return "\n".join(["| implementation | version | kind | " + " | ".join(names) + " |",
                      "|---|---|---|" + "--:|" * len(names), *lines])


def table(runs):
    head = ("implementation", "version", "calls", "pairs", "right", "rounded", "otherwise wrong", "crashed",
            "hung or out of memory", "unreadable", "refused", "open unsupported", "skipped")
    return "\n".join(["| " + " | ".join(head) + " |", "|---|---|---|" + "--:|" * (len(head) - 3),
                      *(row(name, run_of) for name, run_of in runs.items())])


def page(record):
    found = failures_of(record)
    for one in UPSTREAM:
        if not any(one in known(name, kind) for _, name, kind, _ in found):
            failed(f"UPSTREAM has {one}, which was not found")
    (seed,) = {run_of["seed"] for runs in record.values() for run_of in runs.values()}
    failures = "\n".join(failure(*one) for one in found)
    return f"""# Scoreboard
What [`oplus-check conformance`](conformance.md) finds in oplus and in [other libraries](peers.md).
Written by

    bash docs/scoreboard/make

from [the record](scoreboard/runs.json): seed {seed}, `--budget {BUDGET}` and the corpus for each. Clipper 6, Boost and CGAL 5
are those of Debian 12; the other CGAL and Clipper2 are [the newest of Debian](peers.md#the-newest-libraries), of the day of
the run. CGAL has its exact kernel and `NDEBUG`. What each method supports, and how it is called:
[other libraries](peers.md#libraries).

How to read it:

- Sums are counted, the closed and the open one of each pair. Only oplus computes open sums.
- The judge of all, oplus included, is [the oracle](oracle.md), which is ours. Whether a sum is right can be decided
  without it: by a [certificate](certificates.md), whose checker is extracted from Coq.
- *Refused* (a pair that the method does not support) and *open unsupported* are no faults.
- *Rounded* is no fault in a library that computes with integers and says so: the topology is right and all vertices are
  [close](conformance.md#kinds-of-failure).
- *Unreadable* is a result whose chains are not the boundary of a region; a reader that fills it may still see the
  right set.
- *Skipped*: too large for the oracle, or the law does not apply.
- The corpus contains pairs on which these libraries were found to be wrong [earlier](findings.md#other-libraries).

{table(record["sums"])}

## No-fit polygons of real parts
The sums P ⊕ −Q of all pairs of the parts of {len(PARTS)} [nesting instances](../tests/data/README.md), in both orders, judged by
the sums of convex parts. None has a hole. A library that computes with integers gets each pair multiplied by the common
denominator and by the largest power of two for which 30 bits are enough. Each row is

    oplus-check conformance --engine ENGINE --judge convex-parts --parts tests/data/esicup/albano.wkt --parts ...

{table(record["parts"])}

Where they failed:

{by_instance(record["parts"])}

## Kinds of failure
{failures}"""


def check():
    record = json.loads(RECORD.read_text(encoding="utf-8"))
    if PAGE.read_text(encoding="utf-8") != page(record):
        failed("docs/scoreboard.md is not the page of its record: python3 docs/scoreboard/scoreboard.py --write")
    there = {picture.name for picture in HERE.glob("*.svg")}
    if shown(record) != there:
        failed(f"pictures that are missing or not shown: {', '.join(sorted(shown(record) ^ there))}")


def main(arguments):
    if arguments == ["--check"]:
        return check()
    if len(arguments) >= 2 and arguments[0] == "--run" and set(arguments[2:]) <= set(ENGINES):
        run(Path(arguments[1]).resolve(), arguments[2:] or list(ENGINES))
    elif arguments != ["--write"]:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    PAGE.write_text(page(json.loads(RECORD.read_text(encoding="utf-8"))), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
