#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""oplus-bench itself, by table.py and experiments.py: all engines compute small rows, in any time, and the exact results
are equal; faults are reported; and each experiment writes its table and plots. OPLUS_BENCH names the program."""

import csv
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).parent
# Those of oplus-bench-newest, which may be built.
NEWEST = {"cgal-reduced-newest", "cgal-full-newest", "cgal-vertical-newest", "clipper2"}
PROGRAM = os.environ.get("OPLUS_BENCH", HERE.parents[1] / "build/release/bin/oplus-bench")


class InAFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def ran(self, script, *options, path=None):
        """The exit code, standard output and error."""
        environment = {**os.environ, "PATH": path or os.environ["PATH"]}
        ended = subprocess.run([sys.executable, "-B", HERE / script, "--program", PROGRAM, *options], cwd=self.folder,
                               env=environment, capture_output=True, text=True)
        return ended.returncode, ended.stdout, ended.stderr


class Table(InAFolder):
    def test_engines_agree(self):
        rows = "(certificate_)?fork_10|comb_20|proved_star_30_star_30"
        code, out, err = self.ran("table.py", "--rows", rows, "--min-time", "0", "--limit", "100000", "--json", "run.json")
        self.assertEqual((code, err), (0, ""), out)
        self.assertNotRegex(out, "crashed|failed|> 100000|DISAGREE")
        # Every engine, but those of other rows.
        self.assertEqual({line.split()[0] for line in out.splitlines() if line.startswith("  ")} - NEWEST -
                         {"clipper:", "clipper2:", "boost-polygon:"},
                         {"slide", "slide-open", "verify", "cgal-reduced", "cgal-full", "cgal-vertical", "clipper",
                          "boost-polygon", "oplus-sum", "sum-certificate", "oplus-certified", "cgal-sum", "oplus-proved"})
        (self.folder / "docs").mkdir(parents=True)
        self.assertEqual(self.ran("table.py", "--from", "run.json", "--page", "docs"), (0, "", ""))
        page = (self.folder / "docs/benchmarks.md").read_text()
        self.assertIn("On 4 of 4 rows", page)
        self.assertIn(f"table.py --rows '{rows}' --limit 100000 --min-time 0\n", page)
        drawn = (self.folder / "docs/benchmarks/sizes.svg").read_text()
        self.assertEqual([words in drawn for words in (">oplus<", ">Boost.Polygon<", ">combs of", ">stars of", "</svg>")],
                         [True, True, True, False, True])
        self.assertNotIn(str(self.folder), page)

    def test_whole_commands(self):
        code, out, err = self.ran("table.py", "--rows", "command_(small_pairs|convex_5000_square_4)", "--min-time", "0",
                                  "--engines", "slide,oplus-sum,oplus-batch,cgal-sum,clipper-sum")
        self.assertEqual((code, err), (0, ""), out)
        self.assertNotRegex(out, "crashed|failed|DISAGREE|not built|> ")
        for engine in ("oplus-batch", "cgal-sum", "clipper-sum"):
            self.assertRegex(out, f"{engine} .* ms")

    def test_no_fit_polygons_of_parts(self):
        code, out, err = self.ran("table.py", "--rows", "nesting_shapes0", "--min-time", "0")
        self.assertEqual((code, err), (0, ""), out)
        self.assertNotRegex(out, "crashed|failed|DISAGREE|> ")
        for engine in ("slide", "oplus-nfp", "cgal-nfp", "clipper-nfp"):
            self.assertRegex(out, f"{engine} .* ms")

    def test_faults(self):
        for expected, words, options in ((0, "crashed: signal 6", ("crash",)), (0, "> 0.25 s", ("hang", "--limit", "0.25")),
                                         (1, "DISAGREEMENT", ("rca,wrong",))):
            code, out, err = self.ran("table.py", "--rows", "faults_fork_10", "--min-time", "0", "--engines", *options)
            self.assertEqual(code, expected, out + err)
            self.assertIn(words, out)

    def test_rows_and_engines_are_listed(self):
        code, out, _ = self.ran("table.py", "--list")
        self.assertEqual(code, 0)
        for words in ("published_fork: published fork, 34 and 31 vertices", "maze_1000000_convex_4: ", "  slide2: "):
            self.assertIn(words, out)
        self.assertNotRegex(out, "faults_|fork-l_")

    def test_invalid_usage(self):
        for option in ("--nonsense", "--limit=-1", "--scale=nan", "--limit=x"):
            ended = subprocess.run([PROGRAM, option], capture_output=True, text=True)
            self.assertEqual((ended.returncode, ended.stdout, ended.stderr.count("\n")), (2, "", 1), ended.stderr)


class Experiments(InAFolder):
    def experiments(self, *options, **how):
        return self.ran("experiments.py", "--scale", "0", *options, **how)

    def column(self, name, column, out="oplus-experiments"):
        with (self.folder / out / f"{name}.csv").open() as file:
            return [row[column] for row in csv.DictReader(file)]

    def written(self):
        return sorted(path.name for path in (self.folder / "oplus-experiments").iterdir())

    def assert_written(self, name, rows, *plots):
        code, out, err = self.experiments("--only", name)
        self.assertEqual((code, err), (0, ""), out)
        self.assertEqual(self.written(), sorted(["index.md", name + ".csv", name + ".md"] +
                                                [plot + end for plot in plots for end in (".gp", ".svg")]))
        out = self.folder / "oplus-experiments"
        index = (out / "index.md").read_text()
        self.assertIn(f"]({name}.md)", index)
        for plot in plots:
            self.assertRegex((out / (plot + ".svg")).read_text(), "(?s)<path.*</svg>")
            self.assertIn(f"({plot}.svg)", index)
        with (out / f"{name}.csv").open() as file:
            table = list(csv.reader(file))
        self.assertEqual(len(table), rows + 1)
        self.assertEqual({len(cells) for cells in table}, {len(set(table[0]))})
        return index

    def test_of_sums(self):
        self.assert_written("convex-star", 1, "figure-6.9", "figure-6.20a")
        self.assertEqual([self.column("convex-star", name) for name in ("m", "n", "same_sum")],
                         [["50"], ["100"], ["true"]])

    def test_star_star(self):
        self.assert_written("star-star", 1, "figure-6.10")

    def test_simple_simple(self):
        self.assert_written("simple-simple", 1, "figure-6.11", "figure-6.12", "figure-6.13", "figure-6.20b")

    def test_fork_l(self):
        self.assert_written("fork-l", 1, "figure-6.14", "figure-6.15", "figure-6.16", "fork-ratio")
        self.assertEqual(self.column("fork-l", "sum_holes"), ["100"])
        self.assertEqual(self.column("fork-l", "rca_hole_tests"), ["100"])

    def test_table_6_1(self):
        index = self.assert_written("table-6.1", 9)
        self.assertIn("3 pairs measured, 6 skipped", index)
        self.assertIn("A_RC is as in the thesis in 3 of them, A_W in 3", index)
        self.assertEqual(self.column("table-6.1", "rca_outcome").count("missing"), 6)

    def test_cycles(self):
        self.assert_written("cycles", 4, "cycles-factor", "cycles-steps")
        self.assertEqual(self.column("cycles", "same_segments"), ["true"] * 4)
        self.assertLess(max(map(float, self.column("cycles", "steps_by_bound"))), 1)

    def test_hole_tests(self):
        self.assert_written("hole-tests", 10, "hole-tests-simple", "hole-tests-fork")
        self.assertEqual(set(self.column("hole-tests", "sweep_outcome")), {"done"})
        self.assertEqual(self.column("hole-tests", "order")[-1].count("<"), 3)
        # rca asks about each hole of the fork; about edges there are both answers.
        self.assertEqual([self.column("hole-tests", name)[-2:] for name in ("questions", "holes")][0][0], "25")
        self.assertNotIn("0", [self.column("hole-tests", name)[-1] for name in ("holes", "others")])

    def test_a_seed_gives_the_same_pairs(self):
        def sizes(out, seed):
            self.experiments("--only", "cycles", "--only", "star-star", "--seed", seed, "--out", out)
            return [self.column(name, column, out) for name, column in
                    (("cycles", "segments"), ("star-star", "rca_edges"), ("star-star", "sum_edges"))]
        first = sizes("one", "3")
        self.assertEqual(first, sizes("two", "3"))
        self.assertNotEqual(first, sizes("three", "4"))

    def test_a_measurement_that_runs_out_of_memory_is_a_row(self):
        code, out, err = self.experiments("--only", "fork-l", "--memory", "1")
        self.assertEqual(code, 0, out + err)
        self.assertEqual(self.column("fork-l", "rca_outcome"), ["out of memory"])
        self.assertEqual(self.column("fork-l", "ratio"), [""])
        self.assertEqual(self.written(), ["fork-l.csv", "fork-l.md", "index.md"])

    def test_without_gnuplot_one_line_says_so(self):
        code, _, err = self.experiments("--only", "fork-l", path="/nowhere")
        self.assertEqual((code, err.count("\n")), (4, 1), err)
        self.assertIn("gnuplot is missing", err)
        self.assertIn("figure-6.14.gp", self.written())
        failing = self.folder / "gnuplot"
        failing.write_text("#!/bin/sh\nexit 1\n")
        failing.chmod(0o755)
        code, _, err = self.experiments("--only", "cycles", path=f"{self.folder}:{os.environ['PATH']}")
        self.assertEqual((code, err), (4, "experiments.py: gnuplot failed on cycles-factor cycles-steps\n"))

    def test_refuses_invalid_usage(self):
        (self.folder / "file").touch()
        for options in ("--only nonsense", "--scale -1", "--scale x", "--scale nan", "--seed x", "--memory -1",
                        "--memory x", "--rows x", "nonsense", "--out file", "--out file/folder"):
            code, out, err = self.experiments(*options.split())
            self.assertEqual((code, out), (2, ""), options)
            self.assertRegex(err, "(?s)experiments.py: [^\n]*\n$")
        self.assertEqual([path.name for path in self.folder.iterdir()], ["file"])


if __name__ == "__main__":
    unittest.main()
