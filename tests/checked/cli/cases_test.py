# SPDX-License-Identifier: GPL-3.0-or-later
"""cases_test.py OPLUS...: the program, which may be called by an emulator, does what tests/corpus/cases.json says."""

import json
import re
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

CASES = json.loads((Path(__file__).parents[2] / "corpus/cases.json").read_text(encoding="utf-8"))
LAYER = "command line"
OPTIONS = {"grid": "--grid", "side": "--side", "digits": "--digits", "fill": "--fill", "format": "--format"}


class Refused(Exception):
    pass


class Program:
    def __init__(self, command, folder):
        self.command, self.folder, self.notes = command, folder, []

    def run(self, *words):
        """Returns what it prints; keeps what it says."""
        ran = subprocess.run([*self.command, *words], cwd=self.folder, capture_output=True, text=True, check=False)
        # A file is named as in the cases, whatever it is called here.
        said = [re.sub(r"^[pqs](?=:)", "file", line.removeprefix("oplus: ").removesuffix("; add --union to take their union"))
                for line in ran.stderr.splitlines()]
        if ran.returncode == 2:
            assert ran.stdout == "" and len(said) == 1 and ran.stderr.startswith("oplus: "), ran
            raise Refused(said[0])
        assert ran.returncode in (0, 1), ran
        self.notes += said
        return ran.stdout

    def result(self, case, operation):
        """Returns the set or the region of an operation, in the case's format."""
        words = [word for name, option in OPTIONS.items() if name in case for word in (option, case[name])]
        words += [f"--{flag}" for flag in ("union", "open") if flag in case]
        if operation == "read":
            if "refused" in case:
                return self.run("complement", "p", *words)
            # Turned, and back.
            self.run("reflect", "p", "--format", "wkt", "-o", "turned", *(["--union"] if "union" in case else []))
            return self.run("reflect", "turned", *[word for word in words if word != "--union"])
        if operation == "read a set":
            (self.folder / "origin").write_text("POINT (0 0)", encoding="utf-8")
            return self.run("sum", "p", "origin", *words)
        if operation == "disc":
            return self.run("disc", "--radius", case["radius"], "--error", case["error"], "--" + case["disc"], *words)
        if operation == "transform":
            return self.run("transform", "p", *[word for name, values in case["maps"] for word in (f"--{name}", values)], *words)
        return self.run(operation.split()[0], *[name for name in ("p", "q") if name in case], *words)

    def found(self, case, operation):
        if operation == "read a sum":
            (self.folder / "expected").write_text(case.get("is", "POLYGON EMPTY"), encoding="utf-8")
            answer = self.run("compare", "p", "expected")
            return self.with_notes(case, {"is": case.get("is") if answer == "equal\n" else answer})
        if operation == "verify":
            answer = json.loads(self.run("verify", "p", "q", "s", "--json", *(["--open"] if "open" in case else [])))
            return {"reasons": [f"{reason['kind']}: {reason['detail']}" for reason in answer["reasons"]]}
        if operation in ("distance", "depth"):
            answer = json.loads(self.run(operation, "p", "q", "--json"))
            points = answer.get("move" if operation == "depth" else "on_p", []) + answer.get("contact" if operation == "depth" else "on_q", [])
            numbers = [str(Fraction(text)) for text in [answer[f"squared_{operation}"], *points]] if points else []
            return {"answer": numbers[:len(case["answer"])]}
        if "complement is" in case:
            (self.folder / "outside").write_text(self.result({**case, "format": "dat"}, operation), encoding="utf-8")
            return {"complement is": self.run("complement", "outside").rstrip("\n")}
        found = {"is": self.result(case, operation).rstrip("\n")}
        if operation == "repair":
            found["mends"] = [note.removeprefix("file:") for note in self.notes if re.match(r"file:\d", note)]
        return self.with_notes(case, found)

    def with_notes(self, case, found):
        notes = [note for note in self.notes if note.startswith("file: ")]
        return {**found, "notes": notes} if "notes" in case else found


def differences(command, folder, case, operation):
    for name in ("p", "q", "s"):
        if name in case:
            text = case[name] if isinstance(case[name], str) else json.dumps(case[name])
            (folder / name).write_text(text, encoding="utf-8", newline="")
    try:
        found = Program(command, folder).found(case, operation)
    except Refused as refused:
        found = {"refused": str(refused)}
    expected = {name: case[name] for name in ("is", "complement is", "reasons", "mends", "notes", "refused", "answer") if name in case}
    return [] if found == expected else [f"{case['name']}, {operation}: expected {expected}\n  found {found}"]


def main():
    *emulator, program = sys.argv[1:]
    command = [*emulator, Path(program).resolve()]
    all_of_layer = [(case, operation) for case in CASES["cases"] for operation in case["run"]
                    if LAYER in case.get("layers", CASES["layers"][operation])]
    assert len(all_of_layer) > 500
    # No case is run nowhere for a misspelt word.
    named = [layer for one in [*CASES["layers"].values(), *(case.get("layers", []) for case in CASES["cases"])] for layer in one]
    assert {*named} == {"library", "command line", "Python", "page"}, {*named}
    names = [case["name"] for case in CASES["cases"]]
    assert len({*names}) == len(names)
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        for case, operation in all_of_layer:
            wrong += differences(command, Path(folder), case, operation)
    print("\n".join(wrong), f"{len(all_of_layer)} cases, {len(wrong)} wrong", sep="\n")
    sys.exit(bool(wrong))


main()
