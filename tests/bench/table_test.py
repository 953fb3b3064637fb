#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""table.py and experiments.py on figures that are known, and on a program that stands for oplus-bench."""

import contextlib
import io
import json
import re
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).parent))
import experiments
import measuring
import table
from measuring import Engine, Measurement, Program, Row, UsageError

ENGINES = [Engine(name, f"what {name} is", "sums", name not in ("cgal-reduced", "clipper"), name == "clipper", True)
           for name in ("slide", "rca", "cgal-reduced", "clipper", "verify")]


def of(engine, seconds, outcome="done", note="", digest="a", area="2", **numbers):
    return Measurement(engine, outcome, note, digest, area,
                       {"seconds": seconds, "peak_mb": 1, "segments": 1e6, "busy": 1, **numbers})


def stopped(engine):
    return of(engine, 0, "over the limit", "> 60 s", "", "")


def row(name, *measurements, group="", subject="sums"):
    return Row(name, group, name, subject, measurements=list(measurements))


def run_of(*rows):
    setting = {name: name for name in ("processor", "cores", "compiler", "libraries", "commit", "command")}
    return table.Report({**setting, "limit": 60}, ENGINES, list(rows))


class Text(unittest.TestCase):
    def test_numbers(self):
        for value, text in ((0, "0"), (9.996, "10.0"), (0.00012345, "0.000123"), (1234.5, "1,230"), (12, "12.0"),
                            (-5, "-5.00"), (1234567, "1,230,000"), (float("inf"), "inf")):
            self.assertEqual(measuring.three_digits(value), text)
        for value, text in ((60.0, "60"), (0.25, "0.25"), (1 / 3, "0.333333"), (1e15, "1e+15")):
            self.assertEqual(measuring.plain(value), text)
        self.assertEqual([measuring.power_of_ten(value) for value in (0, -0.00012)], ["0", "-1.2e-04"])

    def test_a_table_has_numbers_words_and_outcomes(self):
        rows = [row("a|b", of("rca", 0.5, sum_holes=2000)), row("c\nd", of("rca", 0, "out of memory"))]
        rows[0].words["same"] = "true"
        rows[0].numbers["factor"] = 0.00123
        lines = "ms = 1000 rca.seconds; pair = what; again = 1 rca.seconds; holes = sum_holes\n* = *.outcome; same = same"
        self.assertEqual(measuring.table_of(rows, lines + "\nby = 1 rca.seconds/factor; power = e factor", ["rca"]),
                         "| ms | pair | again | holes | rca | same | by | power |\n|---|---|---|---|---|---|---|---|\n"
                         "| 500 | a/b | 0.500 | 2,000 | done | yes | 407 | 1.2e-03 |\n"
                         "| out of memory | c d |  |  | out of memory |  | out of memory |  |")
        self.assertRaises(ValueError, measuring.columns_of, "T: rca.seconds")

    def test_csv_quotes_and_leaves_cells_empty(self):
        rows = [row("one", of("rca", 0.5, m=4, sum_holes=2)), row("two", of("rca", 0, "out of memory"))]
        rows[0].words["name"], rows[1].numbers["count"] = 'a, "b"', 3
        self.assertEqual(measuring.to_csv(rows, ["name", "nothing"]),
                         "name,nothing,count,m,rca_busy,rca_outcome,rca_peak_mb,rca_seconds,rca_segments,sum_holes\n"
                         '"a, ""b""",,,4,1,done,1,0.5,1000000,2\n,,3,,,out of memory,,,,\n')


class Comparison(unittest.TestCase):
    def test_engines_that_disagree(self):
        wrong = row("r", of("slide", 1), of("rca", 1, digest="b"), of("clipper", 1, digest="", area="3"))
        self.assertEqual(wrong.disagreement(), "slide against rca")
        self.assertEqual(wrong.faults({"slide", "rca"}), ["r: slide against rca disagree"])
        self.assertEqual(wrong.number("clipper.relative_area_error"), 0.5)
        self.assertEqual(row("r", of("slide", 1), of("rca", 1)).faults({"slide", "rca"}), [])

    def test_a_crash_is_a_fault_of_ours_only(self):
        crashed = row("r", of("cgal-reduced", 0, "crashed", "signal 11"), of("rca", 0, "failed", "x"), stopped("slide"))
        self.assertEqual(crashed.faults({"slide", "rca"}), ["r: rca failed: x"])

    def test_ratios(self):
        one = row("r", of("slide", 2), of("rca", 5), stopped("cgal-reduced"), of("clipper", 0, "crashed"))
        self.assertEqual([str(table.ratio(one, "seconds", name, "slide", 60)) for name in
                          ("rca", "cgal-reduced", "clipper", "verify")], ["2.50", "> 30.0", "None", "None"])
        self.assertEqual(str(table.geometric_mean([table.Ratio(2), table.Ratio(8, True)])), "> 4.00")


class Goals(unittest.TestCase):
    def assert_goal(self, words, measured, reached, *rows):
        found = [cells for cells in table.goals_of(run_of(*rows)) if words in cells[0]]
        self.assertEqual(found[0][1:], [measured, reached])

    def test_without_a_run(self):
        goals = table.goals_of(run_of())
        self.assertEqual(len(goals), 27)
        self.assertEqual({cells[2] for cells in goals}, {"not measured"})

    def test_at_their_number(self):
        def beside_cgal(name, *measurements):
            return row(name, of("slide", 1), *measurements)
        self.assert_goal("small pairs: at", "10.0", "yes", beside_cgal("small_pairs", of("cgal-reduced", 10)))
        self.assert_goal("small pairs: at", "9.90", "**no**", beside_cgal("small_pairs", of("cgal-reduced", 9.9)))
        stars = "stars of 300 and 100: at least"
        self.assert_goal(stars, "> 60.0", "yes", beside_cgal("star_300_star_100", stopped("cgal-reduced")))
        self.assert_goal(stars, "> 30.0", "not measured",
                         row("star_300_star_100", of("slide", 2), stopped("cgal-reduced")))
        self.assert_goal("no row", "none", "yes", beside_cgal("comb", of("clipper", 1)))
        self.assert_goal("no row", "comb: clipper, 0.500", "**no**", beside_cgal("comb", of("clipper", 0.5)))

    def test_per_segment(self):
        for seconds, holes, group, words, measured, reached in (
                (3, 0, "", "without holes", "at most 3.00, r", "yes"),
                (3.1, 0, "", "without holes", "at most 3.10, r", "**no**"),
                (3.1, 1, "", "without holes", "", "not measured"),
                (10, 0, "hard", "hard pairs", "at most 10.0, r", "yes"),
                (11, 0, "hard", "hard pairs", "at most 11.0, r", "**no**"),
                (11, 0, "combs", "hard pairs", "", "not measured")):
            self.assert_goal(words, measured, reached, row("r", of("slide", seconds, sum_holes=holes), group=group))

    def test_what_is_at_most(self):
        for command, measured, reached in ((1.31, "at most 1.30, r", "yes"), (1.4, "at most 1.39, r", "**no**")):
            self.assert_goal("whole command: at", measured, reached,
                             row("r", of("slide", 1), of("oplus-sum", command), subject="commands"))
        both = row("r", of("slide", 1), of("slide-open", 2.5), of("verify", 19))
        self.assert_goal("open sums", "at most 2.50, r", "**no**", both)
        self.assert_goal("verify", "at most 19.0, r", "yes", both)
        self.assert_goal("verify", "at most 19.0, r", "not measured", both, row("d", of("slide", 6), stopped("verify")))
        self.assert_goal("verify", "> 30.0, d", "**no**", both, row("d", of("slide", 2), stopped("verify")))

    def test_published_pairs_and_certificates(self):
        pairs = [row(name, of("slide", 1), of("cgal-reduced", seconds), group="published")
                 for name, seconds in (("a", 2.5), ("b", 50))]
        self.assert_goal("geometric mean", "11.2", "yes", *pairs)
        self.assert_goal("none less", "2.50, a", "**no**", *pairs)

        def checked(*measurements):
            return row("c", of("cgal-sum", 1), *measurements, group="certificates", subject="certificates")
        self.assert_goal("checked", "0.500, c", "**no**", checked(of("oplus-certified", 2)))
        self.assert_goal("checked", "", "not measured", checked(of("oplus-certified", 1)),
                         checked(of("oplus-certified", 1, "unsupported")))
        self.assert_goal("made", "at most 10.1, c", "**no**",
                         checked(of("oplus-sum", 1), of("sum-certificate", 10.2)))
        self.assert_goal("gzip", "at most 200, c", "yes",
                         checked(of("slide", 1), of("sum-certificate", 1, zipped_bytes=200e6)))

    def test_the_proved_program(self):
        for name, seconds, measured, reached in (("star_30_star_30", 0.3, "at most 0.300, proved_star_30_star_30", "yes"),
                                                 ("star_30_star_30", 0.31, "at most 0.310, proved_star_30_star_30", "**no**"),
                                                 ("star_60_star_60", 5.1, "at most 5.10, proved_star_60_star_60", "**no**")):
            self.assert_goal(f"stars of {name[5:7]} and {name[5:7]} in", measured, reached,
                             row("proved_" + name, of("oplus-proved", seconds), subject="proved"))
        for other, measured, reached in ((of("cgal-full", 4), "2.00, proved_star_100_star_100", "yes"),
                                         (of("cgal-full", 1), "0.500, proved_star_100_star_100", "**no**"),
                                         (stopped("cgal-full"), "> 30.0, proved_star_100_star_100", "yes")):
            self.assert_goal("CGAL's full", measured, reached,
                             row("proved_star_100_star_100", of("oplus-proved", 2), other, subject="proved"))


class Page(unittest.TestCase):
    REPORT = run_of(row("two squares", of("slide", 0.5, sum_holes=0), of("rca", 0.5, digest="b"),
                        of("cgal-reduced", 0, "crashed", "signal 11"), of("clipper", 1, digest="", area="3"), group="g"),
                    row("three", of("slide", 1), of("rca", 4), group="g"))

    def test_names_what_went_wrong(self):
        self.assertEqual(table.page(self.REPORT, "{{equal}} of {{compared}}\n{{remarks}}"),
                         "1 of 2\n- two squares: **slide against rca disagree**.\n"
                         "- two squares: cgal-reduced crashed: signal 11.")

    def test_has_means_of_groups(self):
        self.assertIn("| two squares | 1.00 | 1.00 | crashed: signal 11 | 1.00 |\n| three | 1.00 | 1.00 |  |  |\n"
                      "| *g, geometric mean* |  | *1.00* |  | *1.00* |", table.page(self.REPORT, "{{memory}}"))
        self.assertIn("| three | 4.00 |  |  |\n| *g, geometric mean* | *2.00* |  | *2.00* |",
                      table.page(self.REPORT, "{{ratios}}"))

    def test_no_fit_polygons_are_compared_with_the_whole_command(self):
        rows = [row(name, of("slide", 0.1), of("oplus-nfp", 0.5), of("cgal-nfp", seconds),
                    of("clipper2-nfp", 0.25, digest="", sum_holes=2), group="nesting", subject="nesting")
                for name, seconds in (("a", 1), ("b", 4))]
        self.assertIn("| a | 100 | 500 | 2.00 |  |  | 0.500 |\n| b | 100 | 500 | 8.00 |  |  | 0.500 |\n"
                      "| *nesting, geometric mean* |  |  | *4.00* |  |  | *0.500* |", table.page(run_of(*rows), "{{nesting}}"))
        self.assertIn("| clipper2-nfp, holes | MB |", table.page(run_of(*rows), table.TEMPLATE.read_text()))

    def test_every_name_is_known(self):
        template = table.TEMPLATE.read_text(encoding="utf-8")
        self.assertNotRegex(table.page(self.REPORT, template), r"\{\{|\n\n\n")
        self.assertNotIn("{{", table.page(run_of(), template))
        self.assertIn("| two squares | 0 | 1.0e+00 | 5.0e-01 |", table.page(self.REPORT, template))
        self.assertRaises(KeyError, table.page, self.REPORT, "{{nothing}}")

    def test_is_of_what_json_says(self):
        with tempfile.NamedTemporaryFile("w+", suffix=".json") as file:
            file.write(self.REPORT.to_json())
            file.flush()
            self.assertEqual(table.Report.read(file.name), self.REPORT)
            file.write("x")
            file.flush()
            self.assertRaises(UsageError, table.Report.read, file.name)


FAKE = """#!/usr/bin/env python3
import json, os, re, signal, sys, time
options = dict(option.lstrip("-").split("=", 1) for option in sys.argv[1:] if "=" in option)
if "--list" in sys.argv:
    print("row\\tr\\tg\\tone row\\tsums\\t1\\tslide rca crash hang greedy odd unsupported broken")
    for name in "slide rca crash hang greedy odd unsupported broken".split():
        print(f"engine\\t{name}\\twhat\\tsums\\t{int(name in ('slide', 'rca', 'broken'))}01")
    sys.exit()
engine = re.fullmatch("\\\\^r/(.*)/", options["benchmark_filter"])[1]
if engine == "crash":
    os.abort()
if engine == "hang":
    signal.setitimer(signal.ITIMER_REAL, float(options["limit"]))
    time.sleep(60)
if engine == "greedy":
    sys.exit("terminate called after throwing an instance of 'std::bad_alloc'")
if engine == "broken":
    sys.exit("oplus-bench: no")
run = {"run_type": "iteration", "real_time": 1, "iterations": 1, "segments": 7, "busy_seconds": 1,
       "label": "digest=" + ("1" if engine == "odd" else "2") + " area=3/2"}
runs = [{**run, "seconds": seconds} for seconds in (0.5, 0.1, 0.2, 0.9, 0.4)] + [{"run_type": "aggregate"}]
if engine == "unsupported":
    runs = [{"run_type": "iteration", "error_occurred": True, "error_message": "unsupported: no holes"}]
json.dump({"context": {"compiler": "GCC"}, "benchmarks": runs}, open(options["benchmark_out"], "w"))
"""


class AProgram(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.path = self.folder / "oplus-bench"
        self.path.write_text(FAKE)
        self.path.chmod(0o755)

    def table(self, *options):
        """The exit code and all output."""
        said = io.StringIO()
        arguments = ["table.py", "--program", str(self.path), "--limit", "0.25", *options]
        with mock.patch("sys.argv", arguments), contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            with self.assertRaises(SystemExit) as ended:
                measuring.run(table.main)
        return ended.exception.code, said.getvalue()

    def test_outcomes(self):
        program = Program(self.path)
        found = {name: program.measure(program.rows[0], name, limit=0.25) for name in program.rows[0].engines}
        self.assertEqual({name: m.in_words() for name, m in found.items()},
                         {"slide": "done", "rca": "done", "odd": "done", "crash": "crashed: signal 6",
                          "hang": "> 0.25 s", "greedy": "out of memory", "unsupported": "no holes",
                          "broken": "failed: exit code 1 oplus-bench: no"})
        self.assertEqual((found["slide"].digest, found["slide"].area), ("2", "3/2"))
        self.assertEqual(found["slide"].numbers, {"seconds": 0.4, "segments": 7, "busy": 2.5, "repetitions": 5})
        self.assertGreater(found["hang"].numbers["peak_mb"], 1)

    def test_another_library_may_do_what_it_likes(self):
        code, said = self.table("--engines", "slide,rca,crash,hang,greedy,unsupported", "--json",
                                str(self.folder / "run.json"))
        self.assertEqual(code, 0, said)
        self.assertRegex(said, r"slide +400 ms +7 segments +250 % busy\n")
        self.assertIn("crashed: signal 6", said)
        self.assertIn("> 0.25 s", said)
        code, said = self.table("--from", str(self.folder / "run.json"), "--markdown", str(self.folder / "page.md"))
        self.assertEqual((code, said), (0, ""))
        page = (self.folder / "page.md").read_text()
        self.assertIn("On 1 of 1 rows", page)
        self.assertIn("--engines slide,rca,crash,hang,greedy,unsupported --limit 0.25 --markdown docs/benchmarks.md", page)
        self.assertNotIn(str(self.folder), page)

    def test_a_wrong_result_and_a_failure_of_ours_are_faults(self):
        code, said = self.table("--engines", "slide,odd")
        self.assertEqual(code, 1)
        self.assertIn("DISAGREEMENT: odd against slide", said)
        code, said = self.table("--engines", "broken")
        self.assertEqual((code, said.splitlines()[-1]),
                         (1, "table.py: r: broken failed: exit code 1 oplus-bench: no"))

    def test_refuses_invalid_usage_in_one_line(self):
        for options, words in ((["--engines", "fast"], "unknown engine fast"), (["--rows", "x"], "no row matches x"),
                               (["--rows", "("], "--rows: "), (["--program", "/nowhere"], "there is no /nowhere"),
                               (["--from", str(self.path)], "not what --json writes")):
            code, said = self.table(*options)
            self.assertEqual((code, said.count("\n")), (2, 1), said)
            self.assertIn(words, said)
        self.assertEqual(self.table("--limit", "0")[0], 2)


class Experiments(unittest.TestCase):
    def test_curves(self):
        points = [(x, 1 + 2 * x + 3 * x * x) for x in (0, 1, 2, 5, 7)]
        fit = experiments.fitted(2, points)
        self.assertEqual(fit.formula(), "1.000000e+00 + (2.000000e+00)*x + (3.000000e+00)*x**2")
        self.assertAlmostEqual(fit.r_squared, 1)
        self.assertIsNone(experiments.fitted(2, points[:3]))
        self.assertEqual(experiments.fitted(1, [(0, 4), (1, 4), (2, 4)]).r_squared, 1)
        self.assertAlmostEqual(experiments.fitted(1, [(0, 0), (1, 1), (2, 0)]).r_squared, 0)

    def test_pages_have_every_number(self):
        for name, experiment in experiments.EXPERIMENTS.items():
            page = experiments.page_of(experiment, [Row(name, words={"family": "convex"})])
            self.assertTrue(page.startswith("# "))
            self.assertNotRegex(page, r"\{|\n\n\n")
            self.assertEqual(len(re.findall(r"(?m)^\|---", page)), experiment.page.count("{{"))


if __name__ == "__main__":
    unittest.main()
