# SPDX-License-Identifier: GPL-3.0-or-later
import copy
import json
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "properties/pages"))
import embed_texts
import index_pages
import links
import pages
import records
import texts
import theorems_column

TEXT = """# lemma-9.9.9: Edges exist

There are
edges.

Thesis: There may be
edges, says docs/findings.md.

Differs: Edges are no points.

Why: See the definition, and docs/findings.md,
on Lemma 9.9.9.

Hypotheses:
- P is valid, which
  is all
- Q is P

Rests on: fact-a, fact-b
"""
PAIR = {"p": "POLYGON ((0 0, 1 0, 0 1, 0 0))", "q": "POLYGON ((0 0, 2 0, 0 3, 0 0))"}
PAGE = "theorems/lemma-9.9.9.md"
MADE = ("number\tfile\tline at abc\tchange\tend\tby\n1\tchecked/a.cpp\t7\ta < b -> a <= b\tcorpus\ta test\n"
        "2\tchecked/a.cpp\t8\t\"a\" -> left out\tnot reached\t\n3\tchecked/a.cpp\t9\ta || b -> a && b\tthe same result\tb is a\n")
# What docs/testing.md counts in, beside the records.
COUNTED = {
    "tests/corpus/pairs.txt": "story: A.\n", "tests/corpus/named_placements.json": '"contact": ""',
    "tests/properties/proofs/faults.py": '    ("a fault"', "properties/fuzz/CMakeLists.txt": "oplus_fuzz_target(wkt 3)",
    "properties/fuzz/seeds/wkt/a": "", "docs/fuzz.md": "| `a-fault`: it is wrong |\n    oplus a\n", "reference/a.hpp": "OPLUS_REQUIRES(a)",
    "checked/a.cpp": " OPLUS_ENSURES(a)", "docs/examples/cpp/a.cpp": "", "docs/findings/a.cpp": "",
    "tests/data/esicup/a.wkt": "", "tests/corpus/cases.json": '{"cases": [1, 2]}', "tests/a/transcripts/a.txt": "$ oplus\n",
    "docs/cost.csv": "version,lines of Coq,core-seconds of check,of release,of fuzz,of tests,number of tests,cases in C++,in Python\n"
                     "today,2345,60,60,60,120,5,2,1\n",
    "docs/tests.csv": "kind,default tests,core-seconds,other tests\nchecked,5,119,2\n",
    "docs/theorems/made.tsv": MADE,
    **{f"docs/campaigns/{name}.json": json.dumps({"campaign": {"operation": name}, "interrupted": False,
                                                  "all": {"ran": ran, "disagreed": 0}}) for name, ran in (("sum", 30), ("erode", 4))},
    "docs/scoreboard/runs.json": json.dumps({"sums": {"slide": {"sums": {"passed": 7}, "failures": {}},
                                                      "clipper": {"failures": {"rounded": {}, "crashed": {}}}},
                                             "parts": {"slide": {"sums": {"passed": 8}, "failures": {}},
                                                       "clipper": {"failures": {"rounded": {}}}}}),
    "properties/pages/testing.md": "{cpp_cases} cases, {coq_lines} lines, {contracts} contracts, {other_libraries} library, "
                                   "{their_failures} kinds, {our_sums} sums, {false_in_ours} of ours, {ours_by_fuzzing} by fuzzing, "
                                   "{campaign_sums} pairs, {campaign_values} of {campaign_operations} operation\n{tests_by_kind}",
}


def statement(id, rests_on=()):
    return {"statement": id, "title": "Edges exist", "kind": id.split("-")[0], "says": "There are edges.",
            "why": "See the definition, and docs/findings.md, on Lemma 9.9.9.", "hypotheses": ["P is valid"],
            "rests_on": list(rests_on), "kills": ["sign-flipped"], "enumerated": True, "cases": 40,
            "sources": [{"family": "grid", "largest": 5, "weight": 1}], "promised_percent": {"holes": 15},
            "file": "properties/statements/chapter9/lemma_9_9_9.cpp"}


class Pages(unittest.TestCase):
    """One statement that kills one mutant and is cited by two pages."""

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.root = Path(directory.name)
        self.docs = self.root / "docs"
        self.listed = {"statements": [statement("lemma-9.9.9")],
                       "mutants": [{"mutant": "sign-flipped", "what": "a sign is wrong", "file": "reference/a.cpp"}]}
        self.run = {"statement": "lemma-9.9.9", "passed": True, "enumerated": 12, "run": 40, "discarded": 3,
                    "families": {"grid": 40}, "classes": {"holes": 10}, "counts": {"edges": 99}, "typical": PAIR}
        self.kill = {"statement": "lemma-9.9.9", "mutant": "sign-flipped", "killed": True, "by_enumeration": False,
                     "cases": 5, "why": "at (1, 2) it has none", "at": ["1", "2"], "shrunk": PAIR}
        self.theorem = {"statement": "lemma-9.9.9", "extent": "in part", "theorem": "edges_exist", "file": "edges.v",
                        "gloss": "There is one.", "covers": "All.", "not_covered": "Nothing."}
        self.query = {"id": "lemma-9.9.9.sign", "statement": "lemma-9.9.9", "file": "sign.cpp",
                      "hypotheses": {"one": "x is positive"}, "conclusion": "x is not 0",
                      "answers": {"proof": {"z3": "unsat"}, "hypotheses": {"z3": "sat"}, "twin-one": {"z3": "sat"}},
                      "counterexamples": {"one": {"x": "0"}}}
        for path, text in COUNTED.items():
            self.write(path, text)
        self.write("docs/findings.md", "# Findings\n## Lemma 9.9.9: no edges\n## Found in our own code\n\n"
                   "| what was wrong | found by |\n|---|---|\n| a | b |\n| `c` | [d](fuzz.md) |\n\n## The pictures\n| e | f |\n")
        for page in ("rca", "slide"):
            self.write(f"docs/{page}.md", "[lemma-9.9.9](theorems/lemma-9.9.9.md)\n")
        self.write("properties/proofs/edges.v", "Lemma edges_exist_not : True.\nProof. easy. Qed.\n\n"
                   "Theorem edges_exist (a : nat) :\n  a = a.\nProof. easy. Qed.\n")
        self.write("properties/proofs/over_the_reals/rational_only", "# Why.\nedges.v: a counterexample\n")
        self.write("properties/statements/chapter9/statements.md",
                   TEXT.replace("\nRests on: fact-a, fact-b\n", "").replace("\n- Q is P", ""))
        self.write("properties/statements/chapter9/lemma_9_9_9.cpp", "")
        for picture in ("typical", "shrunk"):
            self.write(f"docs/theorems/pictures/lemma-9.9.9-{picture}.svg", "")
        self.draw()
        self.write("README.md", "# Sums\n## 0 of 31 results\n## Install\n")
        self.assertEqual(self.result(check=False), (["7 files written"], 0))

    def draw(self, colour="#bfe3b4"):
        self.write("docs/theorems/graph.svg",
                   f'<g class="node">\n<title>0</title><path fill="{colour}"/>>lemma&#45;9.9.9</text>')

    def write(self, path, text):
        path = self.root / path
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def result(self, check=True):
        self.write("docs/theorems/runs.json", json.dumps({"statements": [self.run]}))
        self.write("docs/theorems/kills.json", json.dumps({"kills": [self.kill]}))
        self.write("properties/proofs/theorems.json", json.dumps([self.theorem]))
        self.write("properties/proofs/smt/results.json", json.dumps({"queries": [self.query]}))
        self.write("listing", "#!/bin/sh\ncat <<'END'\n" + json.dumps(self.listed) + "\nEND\n")
        (self.root / "listing").chmod(0o755)
        return pages.main(self.root / "listing", self.root, check)

    def expect(self, *lines):
        """What is wrong; all is well with none."""
        found, code = self.result()
        self.assertEqual(code, 1 if lines else 0, found)
        if lines:
            self.assertEqual([line for line in found if not line.startswith("python3 -B ")], list(lines))

    def page(self):
        return (self.docs / PAGE).read_text(encoding="utf-8")

    def first(self):
        return self.listed["statements"][0]

    def test_are_up_to_date_once_written(self):
        self.expect()

    def test_that_are_changed_missing_or_superfluous(self):
        (self.docs / "theorems.md").write_text("more")
        (self.docs / PAGE).unlink()
        (self.docs / "theorems/pictures/lemma-9.9.9-shrunk.svg").unlink()
        self.write("docs/theorems/lemma-9.9.8.md", "of no statement")
        self.expect("theorems.md: out of date", PAGE + ": missing",
                    "theorems/pictures/lemma-9.9.9-shrunk.svg: missing", "theorems/lemma-9.9.8.md: not generated")
        self.result(check=False)
        self.assertFalse((self.docs / "theorems/lemma-9.9.8.md").exists())
        self.expect("theorems/pictures/lemma-9.9.9-shrunk.svg: missing")

    def test_change_with_their_sources(self):
        def change(what, *stale):
            before = copy.deepcopy((self.listed, self.run, self.kill, self.theorem, self.query))
            what()
            with self.subTest(stale=stale):
                self.expect(*(path + ": out of date" for path in stale))
            self.listed, self.run, self.kill, self.theorem, self.query = before
        change(lambda: self.first().update(why="Because."), PAGE)
        change(lambda: self.first()["promised_percent"].update(holes=16), PAGE)
        change(lambda: self.first().update(hypotheses=[]), PAGE)
        change(lambda: self.run["counts"].update(edges=98), PAGE)
        change(lambda: self.kill.update(cases=6), "mutants.md", PAGE)
        change(lambda: self.query["counterexamples"]["one"].update(x="-1"), PAGE)
        self.write("properties/proofs/as_printed/lemma.v", "Theorem edges_exist (a : nat) :\n  a = a.\nProof. easy. Qed.\n")
        self.draw("#7cc26a")
        change(lambda: self.theorem.update(extent="as printed", file="as_printed/lemma.v"), "../README.md",
               "theorems.md", "theorems/graph.md", "theorems/graph.dot", PAGE)
        self.expect("theorems/graph.svg: is not the drawing of theorems/graph.dot")
        self.draw()
        self.write("properties/proofs/over_the_reals/rational_only", "edges: computed\n")
        change(lambda: None, PAGE)  # over both numbers
        (self.docs / "rca.md").write_text("")
        change(lambda: None, PAGE)

    def test_show_faults_that_a_script_made(self):
        page = (self.docs / "mutants.md").read_text(encoding="utf-8")
        self.assertIn("No test comes to the places of 1 faults,", page)
        self.assertIn("| corpus | 1 |\n| statements | 0 |\n| comparison | 0 |\n| *all* | 2 |\n\n| not killed then, line at abc |", page)
        self.assertIn("| `checked/a.cpp:9` | `a \\|\\| b -> a && b` | the same result: b is a |\n", page)
        self.write("docs/theorems/made.tsv", MADE.replace("a < b", "b < a"))
        self.expect()  # of one that was killed, only the number is shown
        self.write("docs/theorems/made.tsv", MADE.replace("b is a", "b is not a"))
        self.expect("mutants.md: out of date")
        self.write("docs/theorems/made.tsv", MADE.replace("the same result", "survived"))
        self.assertEqual(self.result(), (["docs/theorems/made.tsv: a fault survived, and nothing says what became of it"], 2))

    def test_show_what_they_rest_on(self):
        for part in ["## The statement of the thesis\nThere may be edges, says [docs/findings.md](../findings.md).\n",
                     "## What is stated here\nThere are edges.\n\n*The difference:* Edges are no points.\n",
                     "[notation](../notation.md)", "Cited by: [rca](../rca.md), [slide](../slide.md).",
                     "[docs/findings.md, on Lemma 9.9.9](../findings.md#lemma-999-no-edges)",
                     "*in part*, over ℚ.\n", "    Theorem edges_exist (a : nat) :\n      a = a.\n", "- x is positive; false without: x = 0\n",
                     "| holes | 10 | 25 % | 15 % |\n", f"    P: {PAIR['p']}\n    Q: {PAIR['q']}\n",
                     "In short: proved by enumeration, 12 cases; machine-checked in part, 1 theorem; proved by SMT in "
                     "local form, 1 query; sampled, 40 pairs.\n"]:
            self.assertIn(part, self.page())

    def test_readme_counts_the_numbered_results(self):
        text = (self.root / "README.md").read_text(encoding="utf-8")
        self.assertTrue(text.startswith("# Sums\n## 0 of 1 results\n"), text)
        self.assertIn("\n| proved in part | 1 | [9.9.9](docs/theorems/lemma-9.9.9.md) |\n\n## Install\n", text)
        self.write("README.md", text.replace("in part | 1", "in part | 2"))
        self.write("docs/rca.md", "| statement | in Coq |\n|---|---|\n| [lemma-9.9.9](theorems/lemma-9.9.9.md) | yes |\n")
        self.expect("../README.md: out of date", "rca.md: out of date")
        self.result(check=False)
        self.write("README.md", "# Sums\n")
        self.assertEqual(self.result(), (["README.md: no section '## N of M results', for the thesis's numbered results"], 2))

    def test_testing_counts(self):
        path = self.docs / "testing.md"
        self.assertEqual(path.read_text(encoding="utf-8"),
                         "2 cases, 2,345 lines, 2 contracts, 1 library, 2 kinds, 15 sums, 2 of ours, 1 by fuzzing, 30 pairs, 4 of 1 operation\n"
                         "| `checked` | unit tests of the algorithms and of the command line | 5 | 119 | 2 |\n")
        self.write("checked/a.cpp", "OPLUS_ENSURES(a)\n OPLUS_REQUIRES(b)")
        self.expect("testing.md: out of date")

    def test_testing_refuses_what_it_cannot_count(self):
        def refused(path, text, what):
            self.write(path, text)
            self.assertEqual(self.result(), ([what], 2))
            self.write(path, COUNTED[path])
        refused("tests/corpus/pairs.txt", "", "docs/testing.md: nothing of pairs_with_a_story is in tests/corpus/pairs.txt")
        refused("docs/tests.csv", COUNTED["docs/tests.csv"].replace("checked", "watched"),
                "docs/tests.csv: properties/pages/testing_page.py does not say what watched is")
        refused("properties/pages/testing.md", "{guesses}",
                "docs/testing.md: a record is not as expected: KeyError('guesses')")
        refused("docs/scoreboard/runs.json", COUNTED["docs/scoreboard/runs.json"].replace("{}}, ", '{"a": {}}}, ', 1),
                "docs/testing.md: says that no sum of oplus is wrong, the scoreboard's record says otherwise")
        erode = COUNTED["docs/campaigns/erode.json"]
        no_campaign = "docs/campaigns: there is no report, or one has a disagreement or was interrupted"
        for wrong in (erode.replace('disagreed": 0', 'disagreed": 1'), erode.replace("false", "true")):
            refused("docs/campaigns/erode.json", wrong, no_campaign)
        for name in ("erode", "sum"):
            self.assertEqual(self.result()[1], 0)
            (self.docs / f"campaigns/{name}.json").unlink()
            self.result(check=False)
        self.assertEqual(self.result(), ([no_campaign], 2))
        self.write("docs/campaigns/erode.json", erode)
        (self.docs / "findings/a.cpp").unlink()
        self.assertEqual(self.result(), (["docs/testing.md: there is no file docs/findings/*.cpp"], 2))

    def test_statement_without_a_mutant(self):
        self.first()["kills"] = []
        self.expect("lemma-9.9.9: it names no mutant that it kills", "sign-flipped: no statement names this mutant",
                    "lemma-9.9.9: a kill of sign-flipped is recorded, which it does not name")
        self.first()["kills"] = ["sign-kept", "sign-flipped"]
        self.expect("lemma-9.9.9: there is no mutant sign-kept", "lemma-9.9.9: no kill of sign-kept is recorded")

    def test_statement_without_a_property(self):
        (self.root / self.first()["file"]).unlink()
        self.write("properties/statements/laws/law_left_out.cpp", "")
        self.write("properties/statements/laws/linear_map.cpp", "")
        self.expect("lemma-9.9.9: there is no file properties/statements/chapter9/lemma_9_9_9.cpp",
                    "properties/statements/laws/law_left_out.cpp: no statement is registered from it")

    def test_statement_without_a_text(self):
        self.write("properties/statements/chapter9/statements.md", TEXT.replace("9.9.9", "9.9.8") * 2)
        self.expect("lemma-9.9.8: two texts in statements.md", "lemma-9.9.9: no text in statements.md",
                    *2 * ["lemma-9.9.8: docs/findings.md has no heading with Lemma 9.9.8",
                          "lemma-9.9.8: a text in statements.md, but there is no such statement"])

    def test_program_with_another_text(self):
        self.first()["says"] = "There are none."
        self.expect("lemma-9.9.9: the program was built from another text")

    def test_entry_that_is_not_sound(self):
        for key, value, what in [("title", "", "title, statement or why is missing"),
                                 ("kind", "guess", "the id does not start with a kind"),
                                 ("sources", [], "it names families but no number of cases, or the other way round"),
                                 ("promised_percent", {"holes": 0}, "the promised share of holes is no percentage")]:
            with self.subTest(key=key):
                before = copy.deepcopy(self.listed)
                self.first()[key] = value
                self.expect("lemma-9.9.9: " + what)
                self.listed = before
        self.first().update(sources=[], cases=0, enumerated=False)
        self.expect("lemma-9.9.9: it has neither check nor enumeration")
        self.first().update(statement("lemma-9.9.9"))
        self.first()["sources"][0]["weight"] = 0
        self.expect("lemma-9.9.9: the weight of family grid leaves no pair")
        self.listed["statements"] = 2 * [statement("lemma-9.9.9")]
        self.expect("lemma-9.9.9: two statements of this id")

    def test_statements_that_rest_on_each_other(self):
        below = lambda **rests_on: [*pages.defects.defects_of_graph([statement(*one) for one in rests_on.items()])]
        self.assertEqual(below(a=[], b=["a"], c=["a"], d=["b", "c"]), [])
        self.assertEqual(below(a=["a"], b=["z"]), ["b: rests on an unknown z", "a: rest on each other"])
        self.assertIn("rest on each other", below(a=["c"], b=["a"], c=["b"], d=["a"])[0])

    def test_records_that_do_not_fit(self):
        self.kill["killed"] = False
        self.expect("lemma-9.9.9: has not killed sign-flipped")
        self.kill["killed"] = True
        self.run["passed"] = False
        self.expect("lemma-9.9.9: the recorded run has not passed")
        self.run.update(passed=True, run=0)
        self.expect("lemma-9.9.9: it has no check for the pairs of its families")
        self.run["statement"] = "lemma-9.9.8"
        self.expect("lemma-9.9.9: no run is recorded",
                    "lemma-9.9.8: a run is recorded, but there is no such statement")
        self.run.update(statement="lemma-9.9.9", run=40)
        self.theorem["statement"] = self.query["statement"] = "lemma-9.9.8"
        self.write("docs/rca.md", "[a](theorems/lemma-9.9.8.md)")
        self.expect("edges_exist: is to back lemma-9.9.8, but there is no such statement",
                    "lemma-9.9.9.sign: is to back lemma-9.9.8, but there is no such statement",
                    "docs/rca.md: links to lemma-9.9.8, but there is no such statement")

    def test_finding_that_is_not_there(self):
        self.write("docs/findings.md", "# Findings\n")
        self.expect("lemma-9.9.9: docs/findings.md has no heading with Lemma 9.9.9")

    def test_record_that_is_not_proved(self):
        def refused(what):
            lines, code = self.result()
            self.assertEqual(code, 2)
            self.assertIn(what, lines[0])
        self.theorem["theorem"] = "corners"
        refused("edges.v: no theorem corners")
        self.theorem["extent"] = "most"
        refused("an extent of 'most'")
        self.theorem.update(extent="in part", theorem="edges_exist")
        for question, answer in [("proof", "none"), ("hypotheses", "unsat"), ("twin-one", "unsat")]:
            before = copy.deepcopy(self.query)
            self.query["answers"][question]["z3"] = answer
            refused(f"lemma-9.9.9.sign: z3 answers {answer} to {question}")
            self.query = before
        del self.query["hypotheses"]
        refused("a record is not as expected: KeyError('hypotheses')")

    def test_extent_that_is_not_so(self):
        self.theorem["extent"] = "as printed"
        self.expect("edges_exist: 'as printed', but in edges.v")
        self.theorem["extent"] = "refuted and corrected"
        self.expect("lemma-9.9.9: 'refuted and corrected' needs a theorem that ends in a negation, and one that does not")

    def test_drawing_of_the_graph(self):
        drawing = ["theorems/graph.svg: is not the drawing of theorems/graph.dot"]
        wrong = lambda svg: [*pages.defects.defects_of_drawing('0[label="a-b", x]\n1[label="c"]\n0->1 ;\n', svg)]
        node = '<g class="node">>{}</text>'.format
        arrow = '<g class="edge"><title>0&#45;&gt;1</title>'
        self.assertEqual(wrong(node("a&#45;b") + node("c") + arrow), [])
        for svg in [node("a&#45;b") + arrow, node("a&#45;b") + node("d") + arrow, node("a&#45;b") + node("c"),
                    node("a&#45;b") + node("c") + 2 * arrow]:
            self.assertEqual(wrong(svg), drawing)


class Strength(unittest.TestCase):
    def test_is_the_strongest_kind_of_backing(self):
        backing = object.__new__(records.Backing)
        backing.runs, backing.theorems, backing.queries = {"a": {"run": 40}}, [], []
        colours = [backing.colour("a")]
        def expect(words):
            self.assertEqual(backing.in_words("a"), words)
            colours.append(backing.colour("a"))
        backing.queries = [{"statement": "a"}, {"statement": "c"}]
        expect("proved by SMT in local form, 1 query; sampled, 40 pairs")
        backing.theorems = [{"statement": "a", "extent": "in part"}, {"statement": "c", "extent": "as printed"}]
        expect("machine-checked in part, 1 theorem; proved by SMT in local form, 1 query; sampled, 40 pairs")
        backing.runs["a"]["enumerated"] = 7
        backing.queries = []
        expect("proved by enumeration, 7 cases; machine-checked in part, 1 theorem; sampled, 40 pairs")
        backing.theorems = 2 * [{"statement": "a", "extent": "refuted and corrected"}]
        expect("machine-checked: refuted and corrected, 2 theorems; proved by enumeration, 7 cases; sampled, 40 pairs")
        backing.theorems = 2 * [{"statement": "a", "extent": "as printed"}]
        expect("machine-checked as printed, 2 theorems; proved by enumeration, 7 cases; sampled, 40 pairs")
        self.assertEqual(len(set(colours)), 6)


class TheoremsColumn(unittest.TestCase):
    ROW = "| 1 | [lemma-9.9.9](theorems/lemma-9.9.9.md) | edges exist | {} |"

    def setUp(self):
        self.backing = object.__new__(records.Backing)
        self.backing.runs, self.backing.queries, self.backing.theorems = {"lemma-9.9.9": {"run": 40}}, [], []

    def column(self):
        page = "\n".join(["| step | statement | says | in Coq |", "|---|---|---|---|", self.ROW.format("old"), "", self.ROW.format("old")])
        lines = theorems_column.with_theorems(page, self.backing).split("\n")
        self.assertEqual(lines[-1], self.ROW.format("old"), "a row of another table")
        before, _, after = self.ROW.partition("{}")
        self.assertTrue(lines[2].startswith(before) and lines[2].endswith(after), lines[2])
        return lines[2][len(before):-len(after)]

    def test_names_the_theorems_that_prove_the_most(self):
        self.assertEqual(self.column(), "no; sampled, 40 pairs")
        theorem = lambda extent, name: {"statement": "lemma-9.9.9", "extent": extent, "theorem": name, "file": "a/b.v"}
        self.backing.theorems = [theorem("in part", "a"), theorem("refuted and corrected", "b")]
        self.assertEqual(self.column(), "refuted and corrected: [`b`](../properties/proofs/a/b.v)")
        self.backing.theorems = [theorem("in part", name) for name in "abcde"]
        self.assertEqual(self.column(), "in part: " + ", ".join(f"[`{name}`](../properties/proofs/a/b.v)" for name in "abc") + ", 2 more")


class NumberedResults(unittest.TestCase):
    def test_are_settled_where_they_are_proved_or_refuted_and_corrected(self):
        backing = object.__new__(records.Backing)
        backing.runs, backing.queries = {}, []
        extents = {"lemma-1.1.1": "as printed", "theorem-1.1.2": "refuted and corrected", "corollary-1.1.3": "in part",
                   "observation-1.1.4": None, "section-1.1": "as printed", "fact-a": "as printed"}
        backing.theorems = [{"statement": id, "extent": extent} for id, extent in extents.items()]
        backing.theorems.insert(0, {"statement": "lemma-1.1.1", "extent": "in part"})
        text = index_pages.with_numbered_results("## 9 of 9 results\n## End", [{"statement": id} for id in extents], backing)
        self.assertTrue(text.startswith("## 2 of 4 results\n"), text)
        self.assertEqual([line for line in text.splitlines() if line.startswith("| ")][1:],
                         ["| proved as printed | 1 | [1.1.1](docs/theorems/lemma-1.1.1.md) |",
                          "| false as printed: refuted, and proved as corrected | 1 | [1.1.2](docs/theorems/theorem-1.1.2.md) |",
                          "| proved in part | 1 | [1.1.3](docs/theorems/corollary-1.1.3.md) |",
                          "| tested, but not proved in Coq | 1 | [1.1.4](docs/theorems/observation-1.1.4.md) |"])


class Refutation(unittest.TestCase):
    def test_ends_in_a_negation_and_stands_beside_what_holds(self):
        def defects(*formals):
            return list(pages.defects.defects_of_extents([
                {"statement": "lemma-9.9.9", "theorem": f"t{i}", "extent": "refuted and corrected", "file": "a.v",
                 "formal": formal} for i, formal in enumerate(formals)]))
        self.assertEqual(defects("Theorem a : ~ False.", "Theorem b : 0 = 0."), [])
        self.assertEqual(defects("Lemma a (p : region) :\n  ~ (forall x, p x).", "Theorem b : ~ False -> 0 = 0."), [])
        self.assertEqual(len(defects("Theorem a : ~ False.")), 1)
        self.assertEqual(len(defects("Theorem b : 0 = 0.")), 1)


class Texts(unittest.TestCase):
    def test_in_paragraphs(self):
        self.assertEqual(texts.text_of(TEXT[2:]), texts.Text(
            "lemma-9.9.9", "Edges exist", "There are edges.", "There may be edges, says docs/findings.md.",
            "Edges are no points.", "See the definition, and docs/findings.md, on Lemma 9.9.9.", ("P is valid, which is all", "Q is P"),
            ("fact-a", "fact-b")))

    def test_as_a_literal(self):
        self.assertEqual(embed_texts.literal('a "b" ⊕'), '"a \\"b\\" ⊕"')


class Words(unittest.TestCase):
    def test_of_a_counterexample(self):
        self.assertEqual(records.in_words({"x": "1/2", "f": True, "v.x": "1", "v.y": "2", "d.t": "3/4", "e.t": "5",
                                           "d.positive": False, "d.slanted": True, "e.positive": True,
                                           "e.slanted": False}),
                         "x = 1/2, f = true, v = (1, 2), d = (3/4, -1), e = (1, 0)")


class Links(unittest.TestCase):
    def test_anchors_are_those_of_github(self):
        self.assertEqual(links.anchor_of("Section 4.2.4: components, `a_b` and m + n"),
                         "section-424-components-a_b-and-m--n")
        self.assertEqual(links.anchor_of("The convolution 𝒞"), "the-convolution-𝒞")

    def test_headings_are_of_all_levels_and_not_in_code(self):
        self.assertEqual(links.headings_of("# One\n#include\n### Two\n```\n# three\n```\n    # four\n"),
                         ["One", "Two"])

    def test_findings_are_linked_by_the_section_named(self):
        headings = ["Findings", "Lemma 2.2.50: another", "Lemmas 2.2.4, Lemma 2.2.5: a case"]
        self.assertEqual(
            links.with_links_to_findings("see docs/findings.md, on Lemma 2.2.5. So (docs/findings.md)", headings),
            "see [docs/findings.md, on Lemma 2.2.5](../findings.md#lemmas-224-lemma-225-a-case). "
            "So ([docs/findings.md](../findings.md))")
        self.assertEqual(links.missing_findings("docs/findings.md, on Lemma 2.2.5, docs/findings.md", headings), [])
        self.assertEqual(links.missing_findings("docs/findings.md, on Lemma 2.2.7, if", headings), ["Lemma 2.2.7"])

    def test_pages_that_link_to_a_statement(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, page in {"rca": "[a](theorems/a.md), [b](theorems/b.md#proof), [c](../c.cpp), `theorems/d.md`",
                               "loops": "[a](theorems/a.md) [again](theorems/a.md)",
                               "theorems": "[a](theorems/a.md)"}.items():
                (Path(folder) / (name + ".md")).write_text(page)
            self.assertEqual(links.citing_pages(Path(folder)), {"a": ["loops", "rca"], "b": ["rca"]})


if __name__ == "__main__":
    unittest.main()
