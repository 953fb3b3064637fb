# SPDX-License-Identifier: GPL-3.0-or-later
from cost import append, by_kind, read, report, without_tests, write_kinds
from fixture import TreeTest


class Cost(TreeTest):
    def test_what_is_read(self):
        path = self.write("tests", "1.50 0.25 a test", "2.00 0.00 io/b_test", "Command terminated", "3.00 0.0")
        self.assertEqual(read(path), [(1.75, "a test"), (2.0, "io/b_test")])
        self.assertEqual(read(self.root / "missing"), [])

    def test_dear_tests_are_named_and_refused(self):
        for seconds, everything, named, accepted in [
                (60, [], False, True), (61, [], True, True), (180, [], True, True), (181, [], True, False),
                (181, ["other"], True, False), (181, ["dea."], False, True)]:
            with self.subTest(seconds=seconds, everything=everything):
                lines, is_accepted = report([(100, "check")], [(1, "cheap"), (seconds, "dear")], everything)
                self.assertEqual(is_accepted, accepted)
                self.assertEqual(any(line.startswith("dear: ") for line in lines), named)
                self.assertIn("check 100 s, 2 tests", lines[0])

    def test_a_line_of_everything_that_names_no_test(self):
        self.assertEqual(without_tests(["page.*", "gone"], ["pages", "a"]),
                         ["tests/everything.txt: gone names no test"])

    def test_a_row(self):
        table = self.write("cost.csv", "header")
        append([(1.6, "check"), (2.2, "release")], [(1, "a"), (2.4, "b")], table)
        self.assertRegex(table.read_text(encoding="utf-8"), r"^header\n\d{4}-\d\d-\d\d \w+,\d+,\d+,2,2,3,2,\d{3,},\d{3,}\n$")

    def test_rows_by_kind(self):
        rows = by_kind([(1.4, "a.x"), (1.2, "a/y"), (9, "b.z")], ["a.x", "a/y", "a.w", "b.z"], ["b\\..*", "a\\.w"])
        table = self.root / "tests.csv"
        write_kinds(rows, table)
        self.assertEqual(table.read_text(encoding="utf-8"),
                         "kind,default tests,core-seconds,other tests\na,2,3,1\nb,0,0,1\n")
