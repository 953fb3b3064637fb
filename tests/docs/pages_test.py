#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""pages_test.py OPLUS: what README and the pages of docs/ compute, draw, link to and name."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
sys.path.insert(0, str(ROOT / "properties/pages"))
from links import anchor_of, headings_of

PAGES = {page.name: page.read_text(encoding="utf-8") for page in sorted(DOCS.glob("*.md"))}
README = (ROOT / "README.md").read_text(encoding="utf-8")
COMMAND = re.compile(r"(?<=\n    )(oplus .*?)(?: +# *(.*))?(?=\n)")
# Columns of README's table, and what they are called in that of the ratios in docs/benchmarks.md.
PEERS = {"the faster CGAL, exact": "exact peer", "Clipper2, which rounds": "clipper2"}


def table(text, first):
    """The rows of the table of which the first cell is that, by their first cells: by the heads of their columns."""
    lines = iter(text.splitlines())
    cells = lambda line: [cell.strip() for cell in line.strip("| ").split(" | ")]
    heads = next(cells(line) for line in lines if line.startswith(f"| {first} |"))
    next(lines)
    rows = {}
    for line in lines:
        if not line.startswith("|"):
            return rows
        rows[cells(line)[0]] = dict(zip(heads, cells(line)))
    return rows


class Pages(unittest.TestCase):
    def run_commands(self, page, folder):
        """Runs the commands of a page one after another, as they stand there; yields each, and what it printed."""
        environment = os.environ | {"PATH": f"{PROGRAM.parent}:{os.environ['PATH']}"}
        for command, comment in COMMAND.findall(page):
            ran = subprocess.run(["bash", "-c", command.replace("oplus ", "oplus --quiet ")], cwd=folder, env=environment,
                                 stdin=subprocess.DEVNULL, capture_output=True, text=True)
            # In a pipe, the exit code is that of the last command.
            self.assertTrue(ran.returncode == int(comment.startswith(("not equal", "wrong"))) and "oplus: " not in ran.stderr,
                            f"{command}\n{ran.stderr}")
            yield command, ran.stdout

    def test_readme_computes_what_its_program_prints(self):
        [(_, printed)] = self.run_commands(README, DOCS)
        self.assertIn("\n    " + printed, README)
        self.assertTrue(printed.startswith("POLYGON (("), printed)

    def test_readme_is_short(self):
        self.assertLessEqual(len(README.splitlines()), 120)

    def test_readme_has_figures_of_the_benchmarks(self):
        ratios = table(PAGES["benchmarks.md"], "time / slide")
        times = table(PAGES["benchmarks.md"], "sum, ms")
        figures = table(README, "sum")
        self.assertEqual(len(figures), 3)
        for name, row in figures.items():
            with self.subTest(row=name):
                self.assertEqual(row, {"sum": name, "oplus, ms": times[name]["slide"],
                                       **{head: ratios[name][engine].split(" (")[0] for head, engine in PEERS.items()}})

    def test_five_minutes_draw_readmes_picture(self):
        with tempfile.TemporaryDirectory() as folder:
            commands = list(self.run_commands(PAGES["command_line.md"], folder))
            self.assertEqual(len(commands), 16)
            content = lambda name: (Path(folder) / name).read_bytes()
            self.assertEqual(content("same.wkt"), content("sum.wkt"))
            self.assertTrue(content("picture.svg") == (DOCS / "pictures/room_and_diamond.svg").read_bytes(),
                            "docs/pictures/room_and_diamond.svg is out of date")

    def test_five_minutes_compare(self):
        """The commands of oplus-check, with few cases."""
        commands = re.findall(r"(?<=\n    )oplus-check .*?(?= +#)", PAGES["command_line.md"])
        self.assertEqual(len(commands), 8)
        with tempfile.TemporaryDirectory() as folder:
            mine = Path(folder) / "my-sum"
            mine.write_text('#!/bin/sh\nexec oplus --quiet sum "$1" "$2"\n')
            mine.chmod(0o755)
            environment = os.environ | {"PATH": f"{PROGRAM.parent}:{folder}:{os.environ['PATH']}"}
            for command in commands:
                fewer = re.sub(r"--cases \d+|(?<=conformance)", " --cases 2", command).replace("--vertices 4", "--vertices 3")
                with self.subTest(command=command):
                    ran = subprocess.run(["bash", "-c", fewer], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                                         capture_output=True, text=True)
                    self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)
            self.assertIn("conforms", (Path(folder) / "r.md").read_text())

    def test_draw_their_pictures(self):
        # A command of the command line's page draws README's, under another name.
        drawn = {"docs/pictures/room_and_diamond.svg"}
        for name, page in PAGES.items():
            with tempfile.TemporaryDirectory() as folder, self.subTest(page=name):
                folder = Path(folder)
                (folder / "docs/pictures").mkdir(parents=True)
                (folder / "docs/shapes").symlink_to(DOCS / "shapes")
                for command, _ in self.run_commands(page, folder):
                    for picture in re.findall(r"docs/pictures/\S+\.svg", command):
                        self.assertTrue((folder / picture).read_bytes() == (ROOT / picture).read_bytes(),
                                        f"{picture} is out of date: {command}")
                        drawn.add(picture)
                for shown in re.findall(r"\]\((pictures/[^)]+)\)", page):
                    self.assertIn("docs/" + shown, drawn, "is not drawn on its page")
        self.assertEqual({"docs/pictures/" + path.name for path in (DOCS / "pictures").iterdir()} - drawn, set())

    def test_layouts_print_what_their_page_says(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "docs/pictures").mkdir(parents=True)
            (Path(folder) / "docs/shapes").symlink_to(DOCS / "shapes")
            printed = [text for _, text in self.run_commands(PAGES["layouts.md"], folder) if text]
        self.assertEqual(printed, re.findall(r"```\n(.*?)```\n", PAGES["layouts.md"], re.DOTALL))
        self.assertEqual(len(printed), 4)

    def test_show_a_picture_and_what_algorithms_rest_on(self):
        for name in ["cycles", "collision", "winding", "loops", "rca", "original_convolution"]:
            with self.subTest(page=name):
                page = PAGES[name + ".md"]
                self.assertRegex(page, r"!\[[^\]]+\]\(pictures/[^)]+\.svg\)")
                self.assertRegex(page, r"\]\(theorems/[^)]+\.md\)")
                for part in ["](notation.md)", "## Cost\n", "## What it rests on", "Tests: `", "## Where it is weak\n"]:
                    self.assertIn(part, page)

    def test_link_to_the_page_of_a_statement_not_to_its_source(self):
        """Only the statement's own page links to its source."""
        statements = 0
        for name, page in PAGES.items():
            with self.subTest(page=name):
                self.assertNotRegex(page, r"\]\([^)]*properties/statements/[^)]+\.cpp\)")
                for words, id in re.findall(r"\[([a-z]+-[0-9a-z.-]+)\]\(theorems/([^)]+)\.md\)", page):
                    statements += 1
                    self.assertEqual(words, id)
        self.assertGreater(statements, 100)

    def test_link_to_what_exists(self):
        """Files, folders, and headings of pages."""
        texts = {path: path.read_text(encoding="utf-8")
                 for path in [*ROOT.glob("*.md"), *(ROOT / ".github").glob("*.md"), *DOCS.rglob("*.md")]}
        links = anchors = 0
        for path, text in texts.items():
            for link in re.findall(r"\]\(([^)]+)\)", text):
                if link.startswith("http"):
                    continue
                links += 1
                file, _, anchor = link.partition("#")
                target = Path(os.path.normpath(path.parent / file)) if file else path
                with self.subTest(page=path, link=link):
                    self.assertTrue(target.exists())
                    if anchor and target in texts:
                        anchors += 1
                        self.assertIn(anchor, map(anchor_of, headings_of(texts[target])))
        self.assertGreater(links, 400)
        self.assertGreater(anchors, 10)

    def test_name_files_that_exist(self):
        """Files and folders that are named, without a link."""
        names = 0
        for name, page in PAGES.items():
            for path in re.findall(r"`((?:checked|reference|properties|tests)/[a-z0-9_/.]*)`", page):
                names += 1
                with self.subTest(page=name, path=path):
                    self.assertTrue((ROOT / path).exists())
        self.assertGreater(names, 20)

    def test_are_linked_from_the_readme_and_in_the_contents_of_the_site(self):
        contents = (DOCS / "site/index.md").read_text(encoding="utf-8").splitlines()
        for name in PAGES:
            self.assertIn(f"](docs/{name})", README)
            self.assertIn(name.removesuffix(".md"), contents)


if __name__ == "__main__":
    PROGRAM = Path(sys.argv.pop(1)).resolve()
    unittest.main()
