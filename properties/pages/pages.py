#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes docs/theorems.md, docs/mutants.md and docs/theorems/: a page for each statement, and the graph of all; docs/testing.md;
in README the table of the thesis's numbered results; and columns "in Coq" of tables in other pages.

They are made from what `oplus-check theorems --json` prints and from what is recorded: docs/theorems/*.json and
pictures/, which `oplus-maintain properties` and `mutants` write with --record, properties/proofs/theorems.json and
smt/results.json. Fails where the statements, their files and the records do not fit each other."""

import argparse
import json
import subprocess
import sys
from pathlib import Path

import defects
from index_pages import graph_in_dot, graph_page, mutants_page, theorems_page, with_numbered_results
from records import InvalidRecord, Records
from statement_page import statement_page
from testing_page import testing_page
from theorems_column import pages_with_theorems

ROOT = Path(__file__).resolve().parents[2]
RECORDED = {"theorems/runs.json", "theorems/kills.json", "theorems/made.tsv", "theorems/graph.svg"}


def all_pages(root, statements, mutants, records):
    """The texts of all pages, by their paths from docs/."""
    pages = {"../README.md": with_numbered_results(records.readme, statements, records.backing),
             "theorems.md": theorems_page(statements, mutants, records),
             "mutants.md": mutants_page(mutants, records.kills, records.made),
             "testing.md": testing_page(root, statements, mutants, records),
             "theorems/graph.md": graph_page(statements, records.backing),
             "theorems/graph.dot": graph_in_dot(statements, records)}
    pages |= pages_with_theorems(root / "docs", records.backing)
    text_of = {text.id: text for text in records.texts}
    for statement in statements:
        pages[f"theorems/{statement['statement']}.md"] = statement_page(
            statement, text_of[statement["statement"]], statements, mutants, records)
    return pages


def pictures(records):
    """What `--record` draws, by the paths from docs/."""
    drawn = [run["statement"] + "-typical" for run in records.runs.values() if "typical" in run]
    drawn += [kill["statement"] + "-shrunk" for kill in records.kills if "shrunk" in kill]
    return {f"theorems/pictures/{name}.svg" for name in drawn}


def superfluous(pages, pictures, docs):
    """The files below docs/theorems/ that nothing makes."""
    files = {path.relative_to(docs).as_posix() for path in (docs / "theorems").rglob("*") if path.is_file()}
    return sorted(files - RECORDED - pages.keys() - pictures)


def defects_of_sources(statements, mutants, records, root):
    return [*defects.defects_of_list(statements, mutants), *defects.defects_of_graph(statements),
            *defects.defects_of_texts(statements, records), *defects.defects_of_files(statements, root),
            *defects.defects_of_records(statements, records), *defects.defects_of_extents(records.theorems)]


def write(pages, pictures, docs):
    (docs / "theorems").mkdir(exist_ok=True)
    for path, text in pages.items():
        (docs / path).write_text(text, encoding="utf-8")
    for path in superfluous(pages, pictures, docs):
        (docs / path).unlink()


def stale(pages, pictures, docs):
    """What is missing or out of date below docs/, a line each."""
    for path, text in pages.items():
        if not (docs / path).is_file():
            yield f"{path}: missing"
        elif (docs / path).read_text(encoding="utf-8") != text:
            yield f"{path}: out of date"
    yield from (f"{path}: missing" for path in sorted(pictures) if not (docs / path).is_file())
    yield from (f"{path}: not generated" for path in superfluous(pages, pictures, docs))
    drawing = docs / "theorems/graph.svg"
    yield from defects.defects_of_drawing(pages["theorems/graph.dot"],
                                          drawing.read_text(encoding="utf-8") if drawing.is_file() else "")


def main(program, root, check):
    """Returns the lines to print and the exit code."""
    answer = subprocess.run([program, "theorems", "--json"], check=True, stdout=subprocess.PIPE)
    listed = json.loads(answer.stdout)
    statements = listed["statements"]
    mutants = {mutant["mutant"]: mutant for mutant in listed["mutants"]}
    try:
        records = Records(root)
    except InvalidRecord as error:
        return [str(error)], 2
    if wrong := defects_of_sources(statements, mutants, records, root):
        return wrong, 1
    try:
        pages, drawn = all_pages(root, statements, mutants, records), pictures(records)
    except InvalidRecord as error:
        return [str(error)], 2
    if not check:
        write(pages, drawn, root / "docs")
        return [f"{len(pages)} files written"], 0
    if wrong := list(stale(pages, drawn, root / "docs")):
        return [*wrong, "python3 -B properties/pages/pages.py writes the pages again, bash docs/renew also what they are made from"], 1
    return [f"{len(statements)} statements, {len(mutants)} mutants, {len(pages)} files up to date"], 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/check/bin/oplus-maintain", help="that lists the statements")
    parser.add_argument("--root", type=Path, default=ROOT, help="the tree of sources; default: this one")
    parser.add_argument("--check", action="store_true", help="write nothing; fail where a page is out of date")
    options = parser.parse_args()
    lines, code = main(options.program, options.root, options.check)
    print("\n".join(lines))
    sys.exit(code)
