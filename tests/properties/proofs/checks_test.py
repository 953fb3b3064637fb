# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests that the checks of the proofs find errors."""

import contextlib
import io
import tempfile
import unittest
from pathlib import Path

import checked_again
import compiled
import extracted
import faults
import headlines
import over_the_reals
import sources

RIGHT = "(* True holds. *)\nTheorem right : True.\nProof. exact I. Qed.\n"


class ProofsTest(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.folder = Path(directory.name) / "sources"
        self.build = Path(directory.name) / "build"
        self.folder.mkdir()

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")

    def project(self, *names):
        self.write("_CoqProject", "-R . Oplus\n" + "".join(name + "\n" for name in names))


class Sources(ProofsTest):
    def test_words_in_comments_are_no_gaps(self):
        self.assertEqual(sources.unproved("a.v", "(* Admitted (* admit *) Axiom *)\n" + RIGHT), [])

    def test_gaps(self):
        text = "(* a\n *)\nAxiom a : False.\nLemma b : False. Proof. admit. Admitted.\n"
        self.assertEqual(sources.unproved("a.v", text),
                         ["a.v:3: Axiom", "a.v:4: admit", "a.v:4: Admitted"])

    def test_checks_switched_off(self):
        self.assertEqual(sources.unproved("a.v", "Unset Guard Checking."),
                         ["a.v:1: Unset Guard Checking"])

    def test_a_comment_opened_in_a_string_is_none(self):
        self.assertEqual(sources.unproved("a.v", 'Check "(*". Axiom a : False. (* *)'),
                         ["a.v:1: Axiom"])

    def test_names(self):
        text = ("(* Definition none := 1. *)\nRecord pair := Both { one : nat; other : nat }.\nLemma two : True.\n"
                "Module Inner.\n  Definition t := 1.\nEnd Inner.\nInductive kind := First | Second (n : nat).\n")
        self.assertEqual(sources.defined(text), ["pair", "two", "kind", "Both", "one", "other", "First", "Second"])

    def test_each_name_stands_for_one_thing(self):
        both = {"x/a.v": "Definition one := 1.\n", "y/a.v": "Inductive one_ := one.\n", "y/b.v": "Lemma one' : True.\n"}
        self.assertEqual(sources.defined_twice(both), ["a.v: x/a.v and y/a.v", "one: x/a.v and y/a.v"])
        self.assertEqual(sources.defined_twice({"x/a.v": both["x/a.v"], "y/b.v": both["y/b.v"]}), [])


class Compiled(ProofsTest):
    def test_sources_and_project_agree(self):
        self.write("outside.v", RIGHT)
        self.project("missing.v")
        self.assertEqual(compiled.violations(self.folder),
                         ["outside.v: not in _CoqProject", "missing.v: in _CoqProject, but missing"])

    def test_a_name_defined_twice(self):
        for name in ("a.v", "b.v"):
            self.write(name, RIGHT)
        self.project("a.v", "b.v")
        self.assertEqual(compiled.violations(self.folder), ["right: a.v and b.v"])

    def test_what_is_gone_from_the_sources_is_gone_from_the_build(self):
        self.write("a.v", RIGHT)
        self.write("b.v", RIGHT)
        self.project("a.v", "b.v")
        compiled.bring_up_to_date(self.folder, self.build)
        self.assertTrue(compiled.compile_in(self.build))
        (self.folder / "b.v").unlink()
        self.project("a.v")
        compiled.bring_up_to_date(self.folder, self.build)
        self.assertTrue((self.build / "a.vo").exists())
        self.assertEqual(list(self.build.glob("b.*")), [])

    def test_a_proof_that_is_none(self):
        self.write("a.v", "Theorem wrong : False.\nProof. exact I. Qed.\n")
        self.project("a.v")
        compiled.bring_up_to_date(self.folder, self.build)
        self.assertFalse(compiled.compile_in(self.build))


class Extracted(ProofsTest):
    def test_what_is_proved_may_not_be_replaced(self):
        text = ('From Coq Require Extraction ExtrOcamlBasic.\nExtract Constant plus => "(-)".\n'
                'Extract Inductive nat => int [ "0" "succ" ].\n'
                'Extract Inlined Constant a => "b". (* Extract Constant *)\nExtraction "a.ml" a.\n')
        self.assertEqual(extracted.replaced(text),
                         ["ExtrOcamlBasic", "Extract Constant", "Extract Inductive",
                          "Extract Inlined Constant"])


class Headlines(ProofsTest):
    def entry(self, **changed):
        return dict(zip(headlines.KEYS, ["lemma-1", "whole", "right", "a.v", "True holds.", "all",
                                        "nothing"]),
                    **changed)

    def violations(self, *entries):
        self.write("a.v", RIGHT + "Theorem bare : True.\nProof. exact I. Qed.\n")
        return headlines.violations(entries, self.folder, {"lemma-1"})

    def test_the_list(self):
        self.assertEqual(self.violations(self.entry()), [])
        self.assertEqual(self.violations(self.entry(statement="lemma-2")),
                         ["right: no statement lemma-2 is registered"])
        for wrong in ({"theorem": "wrong"}, {"theorem": "bare"}, {"file": "b.v"}):
            entry = self.entry(**wrong)
            self.assertEqual(self.violations(entry),
                             [f"{entry['theorem']}: not stated in {entry['file']} under a comment"])
        self.assertEqual(self.violations(self.entry(), self.entry()),
                         ["right: listed twice for lemma-1"])
        self.assertIn("needs texts", self.violations(self.entry(gloss=""))[0])
        self.assertIn("needs texts", self.violations({"theorem": "right"})[0])

    def test_what_theorems_rest_on(self):
        self.write("a.v", RIGHT + "Variable gap : False.\n"
                   "Theorem wrong : 1 = 2.\nProof. destruct gap. Qed.\n")
        self.project("a.v")
        compiled.bring_up_to_date(self.folder, self.build)
        self.assertTrue(compiled.compile_in(self.build))
        right, wrong = headlines.assumptions([self.entry(), self.entry(theorem="wrong")], self.build)
        self.assertEqual(right, headlines.CLOSED)
        self.assertIn("gap : False", wrong)
        with contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit):
            headlines.assumptions([self.entry(theorem="unknown")], self.build)


class OverTheReals(ProofsTest):
    def violations(self, text, **texts):
        texts = {f"{folder}/a.v": required for folder, required in texts.items()}
        return over_the_reals.violations(list(texts), over_the_reals.rational_only(text), texts)

    def test_the_list(self):
        self.assertEqual(self.violations("# Why.\nx: computes\n", x="", y=""), [])
        self.assertEqual(self.violations("x/a.v: computes\n", x="", y=""), [])
        self.assertEqual(self.violations("x\n", x=""), ["x: no reason"])
        self.assertEqual(self.violations("y: computes\n", x=""), ["y: no source is or is in it"])

    def test_what_is_about_rational_numbers(self):
        text = "(* Require Qabs. *)\nFrom Coq Require Import\n  List QArith.\nFrom Coq Require Lqa.\n"
        self.assertEqual(self.violations("", x=text), ["x/a.v: requires QArith", "x/a.v: requires Lqa"])
        self.assertEqual(self.violations("x: computes\n", x=text), [])

    def test_axioms(self):
        self.assertEqual(over_the_reals.axioms("Closed under the global context"), set())
        self.assertEqual(over_the_reals.axioms("Axioms:\nA.one : forall P : Prop,\n    two : P\nB.long_name\n  : True\n"),
                         {"A.one", "B.long_name"})


class CheckedAgain(ProofsTest):
    def said(self, text):
        self.write("a.v", text)
        self.project("a.v")
        compiled.bring_up_to_date(self.folder, self.build)
        self.assertTrue(compiled.compile_in(self.build))
        return checked_again.coqchk(self.build, ["Oplus.a"])[1]

    def test_nothing(self):
        self.assertEqual(checked_again.trusted(self.said(RIGHT)), [])

    def test_an_axiom(self):
        self.assertEqual(checked_again.trusted(self.said("Axiom gap : False.\n" + RIGHT)),
                         ["Oplus.a.gap"])

    def test_a_check_switched_off(self):
        text = ("Unset Guard Checking.\nFixpoint wrong (n : nat) : False := wrong n.\n"
                "Set Guard Checking.\n" + RIGHT)
        self.assertEqual(checked_again.trusted(self.said(text)), ["Oplus.a.wrong"])

    def test_silence(self):
        self.assertEqual(len(checked_again.trusted("")), len(checked_again.HEADS))


class Faults(ProofsTest):
    def survivor(self, wrong, where="b.v"):
        self.write("a.v", "Definition one : nat := 1.\nDefinition two : nat := 2.\n")
        self.write("b.v", "From Oplus Require Import a.\nTheorem less : one < two.\n"
                   "Proof. unfold one, two. auto. Qed.\n")
        self.project("a.v", "b.v")
        compiled.bring_up_to_date(self.folder, self.build)
        self.assertTrue(compiled.compile_in(self.build))
        return faults.survivor(self.build, self.folder, ("a fault", "a.v", "nat := 2", wrong, where),
                               faults.required(self.build))

    def test_what_a_proof_finds(self):
        self.assertIsNone(self.survivor("nat := 0"))

    def test_what_none_finds(self):
        self.assertEqual(self.survivor("nat := 3"), "a fault: Coq rejects nothing, not b.v")

    def test_no_definition(self):
        self.assertEqual(self.survivor("nat := true", "a.v"),
                         "a fault: Coq rejects line 2 of a.v, which is no proof, not a.v")

    def test_what_does_not_depend_on_it(self):
        self.assertEqual(faults.way({"a.v": [], "b.v": ["a.v"], "c.v": ["b.v"]}, "c.v", "b.v"), ([], {"a.v", "b.v"}))

    def test_each_fault_is_in_one_part(self):
        parts = [faults.chosen(part) for part in ("few", "proved", "rest")]
        self.assertTrue(all(parts))
        self.assertEqual(sorted(sum(parts, [])), sorted(faults.chosen("")))

    def test_what_is_not_there(self):
        self.assertEqual(faults.survivor(self.build, Path(__file__).parent,
                                         ("a fault", "faults.py", "not" + "hing there", "", "a.v"), {}),
                         "a fault: `nothing there` stands in faults.py 0 times")


if __name__ == "__main__":
    unittest.main()
