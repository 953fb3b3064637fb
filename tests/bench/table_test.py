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
import chart
import experiments
import large
import measuring
import table
from measuring import Engine, Measurement, Program, Row, UsageError

PEERS = ("cgal-reduced", "cgal-full-newest", "cgal-nfp", "cgal-sum")
ROUNDING = ("clipper", "clipper2", "clipper2-nfp")
ENGINES = [Engine(name, f"what {name} is", "sums", name not in PEERS + ROUNDING, name in ROUNDING, True)
           for name in ("slide", "rca", "verify", "oplus-nfp", *PEERS, *ROUNDING)]


def of(engine, seconds, outcome="done", note="", digest="a", area="2", **numbers):
    return Measurement(engine, outcome, note, digest, area,
                       {"seconds": seconds, "peak_mb": 1, "segments": 1e6, "busy": 1, **numbers})


def stopped(engine, limit=60):
    return Measurement(engine, "over the limit", f"> {limit} s", numbers={"peak_mb": 1, "limit": limit})


def row(name, *measurements, group="", subject="sums"):
    return Row(name, group, name, subject, measurements=list(measurements))


def run_of(*rows):
    setting = {name: name for name in ("processor", "cores", "libraries", "commit", "command")}
    return table.Report({**setting, "newest": "CGAL 6.2.1, Clipper2 2.0.1"}, ENGINES, list(rows))


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
        self.assertEqual([str(table.ratio(one, name, "slide")) for name in ("rca", "cgal-reduced", "clipper", "verify")],
                         ["2.50", "> 30.0", "None", "None"])
        self.assertEqual(str(table.ratio(one, "cgal-reduced", "slide", "peak_mb")), "> 1.00")
        self.assertEqual(str(table.geometric_mean([table.Ratio(2), None, table.Ratio(8, True)])), "> 4.00")
        self.assertIsNone(table.geometric_mean([None]))

    def test_a_ratio_has_the_spread_of_the_repetitions(self):
        spread = row("r", of("slide", 2, seconds_least=1, seconds_most=4),
                     of("rca", 12, seconds_least=8, seconds_most=20, seconds_evaluated=16, seconds_evaluated_most=40))
        self.assertEqual(str(table.ratio(spread, "rca", "slide")), "6.00 (2.00 to 20.0)")
        self.assertEqual(str(table.ratio(spread, "rca", "slide", "seconds_evaluated")), "8.00 (4.00 to 40.0)")
        self.assertEqual(str(table.Ratio(3, False, 3, 3.001)), "3.00")

    def test_the_faster_exact_peer(self):
        report = run_of(row("r", of("slide", 1), of("cgal-reduced", 4, seconds_evaluated=7), of("clipper", 2, digest=""),
                            of("cgal-full-newest", 5, seconds_evaluated=6)), row("s", of("slide", 1), stopped("cgal-reduced")))
        self.assertEqual([str(report.exact_peer(report.rows[0], number)) for number in ("seconds", "seconds_evaluated")],
                         ["4.00", "6.00"])
        self.assertEqual(str(report.exact_peer(report.rows[1], "seconds")), "> 60.0")


class Goals(unittest.TestCase):
    def assert_goal(self, words, measured, reached, *rows):
        found = [cells for cells in table.goals_of(run_of(*rows)) if words in cells[0]]
        self.assertEqual([cells[1:] for cells in found], [[measured, reached]])

    def test_without_a_run(self):
        self.assertEqual({cells[2] for cells in table.goals_of(run_of())}, {"not measured"})

    def test_at_their_bound(self):
        for values, at_least, measured, reached in (
                ((3,), True, "3.00, a", "yes"), ((3, 2.9), True, "2.90, b; not on 1 of 2", "**no**"),
                ((3,), False, "3.00, a", "yes"), ((3, 3.1), False, "3.10, b; not on 1 of 2", "**no**"),
                ((4, table.Ratio(2, True)), True, "> 2.00, b", "not measured"), ((4, table.Ratio(3, True)), True, "> 3.00, b", "yes"),
                ((1, table.Ratio(2, True)), True, "1.00, a; not on 1 of 2", "**no**"),
                ((1, table.Ratio(2, True)), False, "> 2.00, b", "not measured"),
                ((1, table.Ratio(4, True)), False, "> 4.00, b; not on 1 of 2", "**no**"), ((None,), True, "", "not measured")):
            self.assertEqual(table.goal("", 3, list(zip(values, "ab")), at_least)[1:], [measured, reached])

    def test_of_pairs_and_nesting(self):
        pairs = [row("a", of("slide", 1), of("cgal-reduced", 2, seconds_evaluated=10), of("clipper", 0.5, digest="")),
                 row("b", of("slide", 1), of("cgal-reduced", 50))]
        self.assert_goal("pairs: at least 15 times the faster exact peer, geometric mean, its", "10.0", "**no**", *pairs)
        self.assert_goal("pairs: at least 15 times the faster exact peer, geometric mean, coord", "22.4", "yes", *pairs)
        self.assert_goal("pairs: at least 3 times the faster exact peer on each row, its", "2.00, a; not on 1 of 2", "**no**", *pairs)
        self.assert_goal("pairs: no other", "0.500, a: clipper; not on 1 of 3", "**no**", *pairs)
        nesting = [row(name, of("slide", 0.1), of("oplus-nfp", 1), of("cgal-nfp", seconds), of("clipper2-nfp", 3, digest=""),
                       subject="nesting") for name, seconds in (("c", 12), ("d", 27))]
        self.assert_goal("nesting, whole commands: at least 15", "18.0", "yes", *nesting)
        self.assert_goal("nesting, whole commands: at least 10", "12.0, c", "yes", *nesting)
        self.assert_goal("nesting, whole commands: no", "3.00, c: clipper2-nfp", "yes", *nesting)

    def test_per_segment(self):
        for seconds, holes, group, words, measured, reached in (
                (1, 0, "", "without holes", "1.00, r", "yes"), (1.1, 0, "", "without holes", "1.10, r", "**no**"),
                (1.1, 1, "", "without holes", "", "not measured"), (3, 0, "hard", "hard pairs", "3.00, r", "yes"),
                (11, 0, "combs", "hard pairs", "", "not measured"), (11, 0, "hard", "without holes", "", "not measured")):
            self.assert_goal(words, measured, reached, row("r", of("slide", seconds, sum_holes=holes), group=group))

    def test_of_commands_large_regions_and_small_calls(self):
        for command, measured, reached in ((1.305, "1.30, r", "yes"), (1.4, "1.40, r", "**no**")):
            self.assert_goal("whole command: at", measured, reached,
                             row("r", of("slide", 1), of("oplus-sum", command), subject="commands"))
        many = row("command_small_pairs", of("slide", 0.01), of("oplus-batch", 0.05), subject="commands")
        many.pairs = 2000
        self.assert_goal("small pairs, the whole command", "40,000", "**no**", many)
        self.assert_goal("made", "10.0, c", "**no**", row("c", of("oplus-sum", 1), of("sum-certificate", 10.05), subject="certificates"))
        self.assert_goal("checked", "0.500, c", "**no**", row("c", of("cgal-sum", 1), of("oplus-certified", 2), subject="certificates"))
        self.assert_goal("of 10 vertices: at most 6", "5.00, calls_10", "yes", row("calls_10", of("batch", 5e-6), subject="calls"))
        verify = row("large_verify", of("small", 1), of("large", 13, process_mb=300, vertices=1e6), subject="large")
        self.assert_goal("time per vertex", "1.30, large_verify", "**no**", verify)
        self.assert_goal("bytes a vertex", "300, large_verify", "**no**", verify)
        grown = row("g", of("slide", 3), of("slide2", 2), subject="growth")
        self.assert_goal("two threads", "1.50, g", "**no**", grown)


class Drawing(unittest.TestCase):
    def test_has_a_curve_for_each_library_that_was_measured(self):
        report = run_of(*(row(f"star_{n}", of("slide", 1e-6 * n, m=n), of("clipper2", 1e-3 * n, m=n, digest=""),
                              of("cgal-reduced", 0.001, m=n), of("cgal-full-newest", 3, m=n, seconds_evaluated=5),
                              stopped("clipper"), group="stars") for n in (10, 20)))
        script = chart.script(report, "x.svg")
        self.assertEqual(re.findall('linestyle . title "(.*?)"', script), ["oplus", "CGAL", "CGAL 6.2.1", "Clipper2 2.0.1"])
        self.assertIn("<< EOD\n10 5\n20 5\nEOD", script)
        self.assertNotIn("nesting", script)


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
        self.assertIn("| three | 3.00 | 4.00 | 3.00 |  |\n| *g, geometric mean* | *3.00* | *2.00* | *3.00* | *2.00* |",
                      table.page(run_of(*self.REPORT.rows[:1], row("three", of("slide", 1), of("rca", 4), of("cgal-reduced", 3),
                                                                  group="g")), "{{ratios}}"))

    def test_begins_with_what_is_slower(self):
        rows = [row("x", of("slide", 2), of("clipper", 1, digest="")),
                row("y", of("slide", 4), of("cgal-reduced", 1, seconds_evaluated=6), of("cgal-full-newest", 9)),
                row("z", of("oplus-nfp", 2), of("slide", 0.1), of("cgal-nfp", 1.9), subject="nesting"),
                row("slower", of("slide", 2), of("clipper", 2.1, digest=""), stopped("cgal-reduced", 1)),
                row("outside", of("slide", 2), of("clipper", 1), subject="proved")]
        self.assertEqual(table.faster(run_of(*rows)).splitlines()[2:],
                         ["| y | cgal-reduced | 0.250 | 1.50 |", "| x | clipper | 0.500 | 0.500 |", "| z | cgal-nfp | 0.950 | 0.950 |"])
        self.assertEqual(table.faster(self.REPORT), "None was measured.")
        page = table.page(run_of(*rows), table.TEMPLATE.read_text())
        self.assertLess(page.index("| y | cgal-reduced |"), page.index("## Goals"))

    def test_readme_has_three_ratios(self):
        rows = [row(name, of("slide", 0.5), of("cgal-reduced", 2, seconds_most=4), of("clipper2", 1, digest=""))
                for name in table.IN_README]
        text = table.readme(run_of(*rows), "a\n\n| sum | oplus | b |\n|---|---|---|\n| c | d | e |\n\nf\n")
        self.assertEqual(text.splitlines()[:5], ["a", "", "| sum | oplus, ms | the faster CGAL, exact | Clipper2, which rounds |", "|---|---|---|---|",
                                                 "| star_300_star_100 | 500 | 4.00 | 2.00 |"])
        self.assertTrue(text.endswith("2.00 |\n\nf\n"))

    def test_no_fit_polygons_are_compared_with_the_whole_command(self):
        rows = [row(name, of("slide", 0.1), of("oplus-nfp", 0.5), of("cgal-nfp", seconds),
                    of("clipper2-nfp", 0.25, digest="", sum_holes=2), group="nesting", subject="nesting")
                for name, seconds in (("a", 1), ("b", 4))]
        self.assertIn("| a | 100 | 500 | 2.00 | 2.00 | 0.500 |\n| b | 100 | 500 | 8.00 | 8.00 | 0.500 |\n"
                      "| *nesting, geometric mean* |  |  | *4.00* | *4.00* | *0.500* |", table.page(run_of(*rows), "{{nesting}}"))
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
json.dump({"context": {"libraries": "GCC"}, "benchmarks": runs}, open(options["benchmark_out"], "w"))
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
        self.assertEqual(found["slide"].numbers, {"seconds": 0.4, "seconds_least": 0.1, "seconds_most": 0.9,
                                                   "segments": 7, "busy": 2.5, "repetitions": 5})
        self.assertGreater(found["hang"].numbers["peak_mb"], 1)
        self.assertEqual(found["hang"].numbers["limit"], 0.25)

    def test_the_newest_libraries_are_measured_by_their_program(self):
        (self.folder / "bin").mkdir()
        (self.folder / "newest").mkdir()
        (self.folder / "newest/versions").write_text("CGAL 7\n")
        for name, text in (("oplus-bench", FAKE), ("oplus-bench-newest", FAKE.replace("crash hang", "new hang").replace("slide rca new", "new").replace('": 7', '": 8'))):
            (self.folder / "bin" / name).write_text(text)
            (self.folder / "bin" / name).chmod(0o755)
        program = Program(self.folder / "bin/oplus-bench")
        self.assertEqual(program.rows[0].engines.count("new"), 1)
        self.assertEqual([program.measure(program.rows[0], name).numbers["segments"] for name in ("slide", "new")], [7, 8])
        self.assertEqual(program.context["newest"], "CGAL 7")

    def test_oplus_has_ten_times_the_limit(self):
        with mock.patch.object(Program, "measure", return_value=of("x", 1)) as asked, contextlib.redirect_stdout(io.StringIO()):
            program = Program(self.path)
            measuring.measure(program, program.rows[0], ["slide", "crash"], limit=2)
        self.assertEqual([call[0][2] for call in asked.call_args_list], [20, 2])

    def test_a_row_of_the_proved_program_has_more_time(self):
        self.path.write_text(FAKE.replace("tsums", "tproved", 1))
        self.assertIn("> 0.75 s", self.table("--engines", "hang")[1])

    def test_another_library_may_do_what_it_likes(self):
        code, said = self.table("--engines", "slide,rca,crash,hang,greedy,unsupported", "--json",
                                str(self.folder / "run.json"))
        self.assertEqual(code, 0, said)
        self.assertRegex(said, r"slide +400 ms +7 segments +250 % busy\n")
        self.assertIn("crashed: signal 6", said)
        self.assertIn("> 0.25 s", said)
        with mock.patch("chart.draw") as draw:
            code, said = self.table("--from", str(self.folder / "run.json"), "--page", str(self.folder))
        self.assertEqual((code, said, draw.call_args[0][1]), (0, "", self.folder / "benchmarks/sizes.svg"))
        page = (self.folder / "benchmarks.md").read_text()
        self.assertIn("On 1 of 1 rows", page)
        self.assertIn("--engines slide,rca,crash,hang,greedy,unsupported --limit 0.25\n", page)
        self.assertNotIn(str(self.folder), page)

    def test_a_wrong_result_and_a_failure_of_ours_are_faults(self):
        code, said = self.table("--engines", "slide,odd")
        self.assertEqual(code, 1)
        self.assertIn("DISAGREEMENT: odd against slide", said)
        code, said = self.table("--engines", "broken")
        self.assertEqual((code, said.splitlines()[-1]),
                         (1, "table.py: r: broken failed: exit code 1 oplus-bench: no"))

    def test_commands_on_large_regions(self):
        for name, does in (("oplus", "[ $1 = gen ] || [ $1 != verify ]"), ("oplus-certified", "exit 0")):
            (self.folder / name).write_text(f"#!/bin/sh\n{does}\n")
            (self.folder / name).chmod(0o755)
        code, said = self.table("--rows", "large", "--json", str(self.folder / "run.json"))
        self.assertEqual((code, said.splitlines()[-2:]), (1, [f"table.py: large_verify: {size} failed: exit code 1"
                                                              for size in ("small", "large")]))
        rows = table.Report.read(self.folder / "run.json").rows
        self.assertEqual([row.name for row in rows if row.done("large")],
                         ["large_" + name for name in large.COMMANDS if name != "verify"])
        self.assertEqual(rows[0].number("large.vertices/small.vertices"), 10)
        self.assertGreater(rows[0].number("large.process_mb"), 0.1)

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
