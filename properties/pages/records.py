# SPDX-License-Identifier: GPL-3.0-or-later
"""What is recorded of statements: runs, kills, theorems of Coq, answers of SMT solvers; and how strongly that
backs them."""

import csv
import json
import re

from links import citing_pages, headings_of
from texts import texts

# From the strongest to the weakest: how a statement is backed, the colour of its node for Graphviz, in words.
LOOKS = [("machine-checked as printed", "#7cc26a", "green"),
         ("machine-checked: refuted and corrected", "#8fd0c6", "blue green"),
         ("proved by enumeration", "#bfe3b4", "light green"),
         ("machine-checked in part", "#fff2a8", "yellow"),
         ("proved by SMT in local form", "#fbd9b0", "orange"),
         ("sampled", "#e8eef7", "blue")]

# How much of a statement a theorem proves.
EXTENTS = ("as printed", "refuted and corrected", "in part")


class InvalidRecord(Exception):
    pass


def formal_statement(coq, name):
    """From the line "Theorem NAME" (or Lemma, Corollary) up to the line before "Proof", or None."""
    found = re.search(rf"^(?:Theorem|Lemma|Corollary) {name}\b.*?(?=\nProof)", coq, re.M | re.S)
    return found and found[0]


def with_formal_statements(theorems, proofs):
    """The entries of theorems.json, each with its statement in Coq as "formal", and as "numbers" those that it is
    compiled over."""
    listed = (proofs / "over_the_reals/rational_only").read_text(encoding="utf-8").splitlines()
    rational_only = {line.partition(":")[0] for line in listed}
    for theorem in theorems:
        folder = theorem["file"].partition("/")[0]
        theorem["numbers"] = "ℚ" if {theorem["file"], folder} & rational_only else "ℚ and ℝ"
        if theorem["extent"] not in EXTENTS:
            raise InvalidRecord(f"{theorem['theorem']}: an extent of '{theorem['extent']}'")
        file = proofs / theorem["file"]
        theorem["formal"] = formal_statement(file.read_text(encoding="utf-8"), theorem["theorem"])
        if not theorem["formal"]:
            raise InvalidRecord(f"{file}: no theorem {theorem['theorem']}")
    return theorems


def in_words(counterexample):
    """Numbers and flags by their values, vectors and directions as vectors."""
    words = []
    for key, value in counterexample.items():
        name, _, part = key.partition(".")
        if not part:
            words.append(f"{name} = {value if isinstance(value, str) else json.dumps(value)}")
        elif part == "x":
            words.append(f"{name} = ({value}, {counterexample[name + '.y']})")
        elif part == "slanted":
            one = "1" if counterexample[name + ".positive"] else "-1"
            x, y = (counterexample[name + ".t"], one) if value else (one, "0")
            words.append(f"{name} = ({x}, {y})")
    return ", ".join(words)


def with_expected_answers(queries):
    """The entries of results.json, which `oplus-check smt --record` wrote."""
    for query in queries:
        for question in ["proof", "hypotheses", *("twin-" + name for name in query["hypotheses"])]:
            for solver, answer in query["answers"][question].items():
                if answer != ("unsat" if question == "proof" else "sat"):
                    raise InvalidRecord(f"{query['id']}: {solver} answers {answer} to {question}")
    return queries


def read(path):
    return json.loads(path.read_text(encoding="utf-8"))


def rows(path, **form):
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file, **form))


class Backing:
    """How strongly each statement is backed."""

    def __init__(self, root):
        proofs = root / "properties/proofs"
        self.runs = {run["statement"]: run for run in read(root / "docs/theorems/runs.json")["statements"]}
        self.theorems = read(proofs / "theorems.json")
        self.queries = read(proofs / "smt/results.json")["queries"]

    def theorems_of(self, statement, extent):
        return sum(t["statement"] == statement and t["extent"] == extent for t in self.theorems)

    def amounts(self, statement):
        """How many theorems, cases, queries or pairs, for each of LOOKS."""
        run = self.runs.get(statement, {})
        return [(self.theorems_of(statement, "as printed"), "theorem", "theorems"),
                (self.theorems_of(statement, "refuted and corrected"), "theorem", "theorems"),
                (run.get("enumerated", 0), "cases", "cases"),
                (self.theorems_of(statement, "in part"), "theorem", "theorems"),
                (sum(query["statement"] == statement for query in self.queries), "query", "queries"),
                (run.get("run", 0), "pairs", "pairs")]

    def in_words(self, statement):
        """All ways, with numbers: "machine-checked as printed, 2 theorems; sampled, 1500 pairs"."""
        return "; ".join(f"{look[0]}, {number} {one if number == 1 else many}"
                         for look, (number, one, many) in zip(LOOKS, self.amounts(statement)) if number)

    def colour(self, statement):
        """The colour of its node in the graph: that of its strongest backing."""
        return next((look[1] for look, amount in zip(LOOKS, self.amounts(statement)) if amount[0]), LOOKS[-1][1])


class Records:
    """All that is recorded, in the form of the JSON files, and what other pages say. Raises InvalidRecord."""

    def __init__(self, root):
        docs, proofs = root / "docs", root / "properties/proofs"
        try:
            self.backing = Backing(root)
            self.runs = self.backing.runs
            self.kills = read(docs / "theorems/kills.json")["kills"]
            self.made = rows(docs / "theorems/made.tsv", delimiter="\t", quoting=csv.QUOTE_NONE)
            self.theorems = with_formal_statements(self.backing.theorems, proofs)
            self.queries = with_expected_answers(self.backing.queries)
            self.texts = texts(root)
            self.citing = citing_pages(docs)
            self.readme = (root / "README.md").read_text(encoding="utf-8")
            self.text_of_findings = (docs / "findings.md").read_text(encoding="utf-8")
            self.findings = headings_of(self.text_of_findings)
        except (KeyError, TypeError, ValueError, OSError) as error:
            raise InvalidRecord(f"a record is not as expected: {error!r}") from error
