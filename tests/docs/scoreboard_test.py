#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/scoreboard.md is the page of its record, and shows the pictures that are there."""

import json
import shutil
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "docs/scoreboard"))
import scoreboard


class Scoreboard(unittest.TestCase):
    def setUp(self):
        self.record = json.loads(scoreboard.RECORD.read_text(encoding="utf-8"))
        self.failures = self.record["sums"]["cgal-full"]["failures"]

    def assert_fails(self, words, function, *arguments):
        with self.assertRaises(SystemExit) as failed:
            function(*arguments)
        self.assertIn(words, str(failed.exception))

    def test_page_and_pictures_are_those_of_the_record(self):
        scoreboard.check()

    def test_a_page_of_another_record(self):
        with tempfile.TemporaryDirectory() as folder:
            changed = Path(folder) / "runs.json"
            self.failures["crashed: SIGSEGV"]["sums"] += 1
            changed.write_text(json.dumps(self.record), encoding="utf-8")
            with mock.patch.object(scoreboard, "RECORD", changed):
                self.assert_fails("is not the page of its record", scoreboard.check)

    def test_a_picture_that_is_missing_and_one_that_is_not_shown(self):
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(scoreboard, "HERE", Path(folder)):
            for picture in scoreboard.RECORD.parent.glob("*.svg"):
                shutil.copy(picture, folder)
            scoreboard.check()
            shutil.copy(scoreboard.RECORD, Path(folder) / "more.svg")
            self.assert_fails("not shown: more.svg", scoreboard.check)
            (Path(folder) / "more.svg").unlink()
            (Path(folder) / self.failures["crashed: SIGSEGV"]["picture"]).unlink()
            self.assert_fails("missing or not shown: cgal-full-crashed-sigsegv.svg", scoreboard.check)

    def test_a_kind_of_which_it_is_not_said_what_is_known(self):
        self.failures["hung"] = self.failures["crashed: SIGSEGV"]
        self.assert_fails("0 entries for cgal-full, hung", scoreboard.page, self.record)

    def test_no_fit_polygons_count_by_instance(self):
        holes = self.record["parts"]["clipper2"]["failures"]["hole invented"]
        self.assertEqual(sum(holes["of_parts"].values()), holes["sums"])
        holes["of_parts"]["albano"] = 1234
        self.assertIn("| hole invented | 1,234 |", scoreboard.page(self.record))

    def test_what_is_known_of_a_kind_that_was_not_found(self):
        del self.failures["crashed: SIGSEGV"]
        scoreboard.page(self.record)  # the newest CGAL has it
        del self.record["sums"]["cgal-full-newest"]["failures"]["crashed: SIGSEGV"]
        self.assert_fails("('cgal-full', 'crashed: SIGSEGV'), which was not found", scoreboard.page, self.record)

    def test_an_outcome_that_the_table_lacks(self):
        self.record["sums"]["slide"]["sums"]["lost"] = 1
        self.assert_fails("an outcome that the table does not have", scoreboard.page, self.record)


if __name__ == "__main__":
    unittest.main(verbosity=2)
