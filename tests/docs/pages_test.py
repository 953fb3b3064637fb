#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""pages_test.py OPLUS: what README and the pages of docs/ compute, draw, link to and name."""

import os
import re
import subprocess
import sys
import tempfile
import textwrap
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
sys.path.insert(0, str(ROOT / "properties/pages"))
from links import anchor_of, headings_of

PAGES = {page.name: page.read_text(encoding="utf-8") for page in sorted(DOCS.glob("*.md"))}
README = (ROOT / "README.md").read_text(encoding="utf-8")
# Lines that are typed; those after one that starts with $ are what it prints.
COMMAND = re.compile(r"(?<=\n    )(?:(\$ )|(?=oplus(?:-proved)? ))(.*?)(?: +# *(.*))?\n(?(1)((?:    (?!\$ ).*\n)*))")
SHOWN = re.compile(r"\n```\n(.*?\n)```\n", re.DOTALL)
COMPARING = re.compile(r"(?<=\n    )(?:build/release/bin/)?(oplus-(?:check|peer|maintain) .*?)(?: +#.*)?(?=\n)")
# What is not run, and why.
NOT_RUN = {
    "for f in data/records/*.svg; do oplus layout $f; done": "the data is not here",
    "oplus-check merge shard-*.json -o merged.json": "campaigns.shards does",
    "oplus-check conformance --engine 'exec:./own_program {p} {q}' --report own.xml": "conformance.own-program does",
    "oplus-check conformance --engine 'exec:oplus-peer-newest clipper2 {p} {q}'": "newest.peer does",
    "oplus-check smt": "proofs.smt does",
    "oplus-check smt table-4.3-to-4.6 --write questions": "tests/properties/transcripts/smt.txt writes those of another one",
    "oplus-maintain fuzz slide --seconds 600": "fuzz.slide runs the target",
}
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
        """Runs the commands of a page one after another, as they stand there; yields each, and what it printed. Fails where
        the page shows something else than was printed."""
        environment = os.environ | {"PATH": f"{PROGRAM.parent}:{os.environ['PATH']}"}
        outputs = []
        for session, command, comment, after in COMMAND.findall(page):
            if command in NOT_RUN:
                continue
            ran = subprocess.run(["bash", "-c", command], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                                 capture_output=True, text=True)
            # In a pipe, the exit code is that of the last command.
            self.assertEqual(ran.returncode, int(comment.startswith(("not equal", "wrong"))), f"{command}\n{ran.stderr}")
            self.assertNotRegex(ran.stderr, "(?m)^oplus: .*; expected ", command)
            if session:
                self.assertEqual(ran.stdout + ran.stderr, textwrap.dedent(after), command)
            outputs += ["\n" + ran.stdout, "\n" + ran.stderr]
            yield command, ran.stdout
        for shown in SHOWN.findall(page) if outputs else []:
            self.assertTrue(any("\n" + shown in output for output in outputs), f"no command prints\n{shown}")

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

    def test_compare(self):
        """The commands of the other programs, with few cases."""
        commands = {command: name for name, page in PAGES.items() for command in COMPARING.findall(page)
                    if not re.search("…|ENGINE|FILE", command)}
        self.assertGreater(len(commands), 15)
        with tempfile.TemporaryDirectory() as folder:
            mine = Path(folder) / "my-sum"
            mine.write_text('#!/bin/sh\nexec oplus --quiet sum "$1" "$2"\n')
            mine.chmod(0o755)
            (Path(folder) / "parts.wkt").write_text("POLYGON((0 0,2 0,0 2,0 0))\nPOLYGON((0 0,1 0,0 1,0 0))\n")
            environment = os.environ | {"PATH": f"{PROGRAM.parent}:{folder}:{os.environ['PATH']}"}
            for command, name in commands.items():
                if command in NOT_RUN:
                    continue
                fewer = re.sub(r" --(?:cases|budget) \d+", "", command).replace("--vertices 4", "--vertices 3")
                fewer = re.sub("oplus-check (?:diff|conformance)", r"\g<0> --cases 2", fewer)
                with self.subTest(page=name, command=command):
                    ran = subprocess.run(["bash", "-c", fewer], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                                         capture_output=True, text=True)
                    # CGAL's full convolution crashes on some of the corpus.
                    self.assertEqual(ran.returncode, int("conformance --engine cgal-full" in command), ran.stdout + ran.stderr)
            self.assertIn("conforms", (Path(folder) / "r.md").read_text())

    def test_what_is_not_run_is_on_a_page(self):
        typed = {command for page in PAGES.values() for _, command, *_ in COMMAND.findall(page)}
        typed |= {command for page in PAGES.values() for command in COMPARING.findall(page)}
        self.assertEqual(set(NOT_RUN) - typed, set())

    def test_batch_gives_what_its_page_says(self):
        pairs, results = re.search(r"\n\n((?:    .*\n)+)\nin `pairs.txt`.*\n\n((?:    .*\n)+)", PAGES["batch.md"]).groups()
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "pairs.txt").write_text(textwrap.dedent(pairs).replace("⇥", "\t"))
            ran = subprocess.run([PROGRAM, "batch", "pairs.txt"], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                 stderr=subprocess.DEVNULL, text=True)
        self.assertEqual(ran.stdout, textwrap.dedent(results))

    def test_print_what_they_show_and_draw_their_pictures(self):
        # A command of the command line's page draws README's, under another name.
        drawn = {"docs/pictures/room_and_diamond.svg"}
        for name, page in PAGES.items():
            if name == "many_machines.md":  # parallel_test.py
                continue
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
                 for path in [*ROOT.glob("*.md"), *(ROOT / ".github").glob("*.md"), *DOCS.rglob("*.md"),
                              *(path for folder in ("checked", "properties", "tests")
                                for path in (ROOT / folder).rglob("README.md"))]}
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

    def test_call_scripts_that_exist(self):
        scripts = 0
        for name, page in (PAGES | {"README.md": README}).items():
            for path in re.findall(r"\b(?:bash|python3(?: -B)?) ([\w.-]+/[\w./-]+)", page):
                scripts += 1
                with self.subTest(page=name, path=path):
                    self.assertTrue((ROOT / path).is_file())
        self.assertGreater(scripts, 20)

    def test_are_linked_from_the_readme_and_in_the_contents_of_the_site(self):
        contents = (DOCS / "site/index.md").read_text(encoding="utf-8").splitlines()
        for name in PAGES:
            self.assertIn(f"](docs/{name})", README)
            self.assertIn(name.removesuffix(".md"), contents)


if __name__ == "__main__":
    PROGRAM = Path(sys.argv.pop(1)).resolve()
    unittest.main()
