# SPDX-License-Identifier: GPL-3.0-or-later
"""What is wrong with the statements and between them, their files, their records and the pages, a line each."""

import re
from graphlib import CycleError, TopologicalSorter

from index_pages import PARTS
from links import missing_findings

KINDS = {"lemma", "theorem", "corollary", "observation", "section", "table", "equation", "definition", "fact", "law",
         "step"}


def defects_of_statement(statement, mutants):
    if statement["kind"] not in KINDS or statement["statement"] == statement["kind"]:
        yield "the id does not start with a kind"
    if not (statement["title"] and statement["says"] and statement["why"]):
        yield "title, statement or why is missing"
    if not statement["cases"] and not statement["enumerated"]:
        yield "it has neither check nor enumeration"
    if bool(statement["cases"]) != bool(statement["sources"]):
        yield "it names families but no number of cases, or the other way round"
    for source in statement["sources"]:
        if source["weight"] <= 0:
            yield f"the weight of family {source['family']} leaves no pair"
    for name, percent in statement["promised_percent"].items():
        if not 1 <= percent <= 100:
            yield f"the promised share of {name} is no percentage"
    if not statement["kills"]:
        yield "it names no mutant that it kills"
    for name in statement["kills"]:
        if name not in mutants:
            yield f"there is no mutant {name}"


def defects_of_list(statements, mutants):
    ids = [statement["statement"] for statement in statements]
    yield from (f"{id}: two statements of this id" for id in sorted({id for id in ids if ids.count(id) > 1}))
    for statement in statements:
        yield from (f"{statement['statement']}: {what}" for what in defects_of_statement(statement, mutants))
    named = {name for statement in statements for name in statement["kills"]}
    for name, mutant in mutants.items():
        # Faults in reading and writing are found by the fuzz targets (docs/fuzz.md).
        if name not in named and not mutant["file"].startswith("reference/io/"):
            yield f"{name}: no statement names this mutant"


def defects_of_graph(statements):
    """A statement that rests on an unknown one or on itself, a cycle."""
    rests_on = {statement["statement"]: statement["rests_on"] for statement in statements}
    for id, below in rests_on.items():
        yield from (f"{id}: rests on an unknown {other}" for other in below if other not in rests_on)
    try:
        TopologicalSorter(rests_on).prepare()
    except CycleError as error:
        yield f"{', '.join(error.args[1][1:])}: rest on each other"


def defects_of_texts(statements, records):
    """Each statement has one text, and each text a statement; the program was built with these texts; the findings that
    they name exist."""
    ids = [text.id for text in records.texts]
    registered = {statement["statement"]: statement for statement in statements}
    yield from (f"{id}: two texts in statements.md" for id in sorted({id for id in ids if ids.count(id) > 1}))
    yield from (f"{id}: no text in statements.md" for id in registered if id not in ids)
    for text in records.texts:
        for name in missing_findings(" ".join([text.says, text.thesis, text.differs, text.why]), records.findings):
            yield f"{text.id}: docs/findings.md has no heading with {name}"
        if text.id not in registered:
            yield f"{text.id}: a text in statements.md, but there is no such statement"
        elif registered[text.id]["says"] != text.says:
            yield f"{text.id}: the program was built from another text"


def defects_of_files(statements, root):
    """Each statement has its file, and each file KIND_*.cpp below properties/statements/ has a statement."""
    files = {statement["file"] for statement in statements}
    for statement in statements:
        if not (root / statement["file"]).is_file():
            yield f"{statement['statement']}: there is no file {statement['file']}"
    for path in sorted((root / "properties/statements").rglob("*.cpp")):
        file = path.relative_to(root).as_posix()
        if re.match("[a-z]+", path.name)[0] in KINDS and file not in files:
            yield f"{file}: no statement is registered from it"


def ends_in_a_negation(formal):
    """Whether the conclusion of a statement in Coq is one."""
    before = None
    while before != formal:
        before, formal = formal, re.sub(r"\([^()]*\)", "()", formal)
    return bool(re.search(r"(?::|,|->)\s*~[^~>]*$", formal))


def defects_of_extents(theorems):
    """What the extents promise and the theorems do not keep. "as printed": the theorem is in as_printed/, where
    statements use the thesis's notions only. "refuted and corrected": one theorem ends in a negation, another one
    says what holds."""
    for theorem in theorems:
        printed = theorem["extent"] == "as printed" and theorem["statement"].partition("-")[0] not in PARTS
        if printed != theorem["file"].startswith("as_printed/"):
            yield f"{theorem['theorem']}: '{theorem['extent']}', but in {theorem['file']}"
    refuted = {}
    for theorem in theorems:
        if theorem["extent"] == "refuted and corrected":
            refuted.setdefault(theorem["statement"], set()).add(ends_in_a_negation(theorem["formal"]))
    yield from (f"{id}: 'refuted and corrected' needs a theorem that ends in a negation, and one that does not"
                for id, kinds in refuted.items() if kinds != {True, False})


def defects_of_records(statements, records):
    ids = {statement["statement"] for statement in statements}
    recorded = {(kill["statement"], kill["mutant"]) for kill in records.kills}
    named = {(statement["statement"], name) for statement in statements for name in statement["kills"]}
    for kill in records.kills:
        if not kill["killed"]:
            yield f"{kill['statement']}: has not killed {kill['mutant']}"
    for statement in statements:
        id, run = statement["statement"], records.runs.get(statement["statement"])
        if run is None:
            yield f"{id}: no run is recorded"
        elif not run["passed"]:
            yield f"{id}: the recorded run has not passed"
        elif statement["cases"] and not run["run"]:
            yield f"{id}: it has no check for the pairs of its families"
    yield from (f"{id}: no kill of {name} is recorded" for id, name in sorted(named - recorded))
    yield from (f"{id}: a kill of {name} is recorded, which it does not name" for id, name in sorted(recorded - named))
    yield from (f"{id}: a run is recorded, but there is no such statement" for id in records.runs if id not in ids)
    backed = ([(theorem["theorem"], theorem["statement"]) for theorem in records.theorems] +
              [(query["id"], query["statement"]) for query in records.queries])
    yield from (f"{name}: is to back {id}, but there is no such statement" for name, id in backed if id not in ids)
    for id, pages in records.citing.items():
        if id not in ids:
            yield f"docs/{pages[0]}.md: links to {id}, but there is no such statement"


def defects_of_drawing(dot, svg, name="theorems/graph"):
    """Each node, in its colour, and each arrow of NAME.dot is drawn in NAME.svg, and nothing else."""
    nodes = re.findall(r'^\d+\[label="([^"]*)"', dot, re.M)
    arrows = re.findall(r"^(\d+)->(\d+)", dot, re.M)
    drawn = [f">{name.replace('-', '&#45;')}</text>" for name in nodes]
    drawn += [f"<title>{one}&#45;&gt;{other}</title>" for one, other in arrows]
    colours = re.findall(r'^(\d+)\[.*fillcolor="([^"]*)"', dot, re.M)
    if (not all(what in svg for what in drawn) or
            not set(colours) <= set(re.findall(r'class="node">\s*<title>(\d+)</title>.*?fill="([^"]*)"', svg, re.S)) or
            (svg.count('class="node"'), svg.count('class="edge"')) != (len(nodes), len(arrows))):
        yield f"{name}.svg: is not the drawing of {name}.dot"
