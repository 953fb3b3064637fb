# SPDX-License-Identifier: GPL-3.0-or-later
"""Docstrings, stubs by mypy, and examples."""

import ast
import doctest
import inspect
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import oplus

ROOT = Path(__file__).resolve().parents[4]
PUBLIC = {name: getattr(oplus, name) for name in oplus.__all__}
STUBS = ast.parse((ROOT / "checked/bindings/python/oplus/__init__.pyi").read_text(encoding="utf-8")).body


def members(value):
    return {name: member for name, member in vars(value).items() if not name.startswith("_")}


def documented():
    """Yields names and docstrings of the module, and of all that is public."""
    yield "oplus", oplus.__doc__
    for name, value in PUBLIC.items():
        yield name, value.__doc__
        if inspect.isclass(value) and value not in (oplus.Arrays, oplus.InvalidInput):
            for member, what in members(value).items():
                yield f"{name}.{member}", what.__doc__


@pytest.mark.parametrize("name, text", documented(), ids=lambda text: text.split("\n")[0])
def test_docstrings(name, text):
    assert text and text.strip()
    owner = name.split(".")[0]
    # Small values that others return.
    assert ">>>" in text or owner in ("Rounded", "Reason", "Verdict", "InvalidInput")
    examples = doctest.DocTestParser().get_doctest(text, {"oplus": oplus}, name, None, None)
    report = []
    outcome = doctest.DocTestRunner(verbose=False).run(examples, out=report.append)
    assert outcome.failed == 0, "".join(report)
    assert all(len(line) <= 116 or "InvalidInput" in line or ">>>" in line or "Fraction" in line
               for line in inspect.cleandoc(text).splitlines())


# What mypy needs to know of a package: that its own files are not to be judged but by their stubs.
MYPY = "[mypy]\nignore_missing_imports = True\n" + "".join(
    f"[mypy-oplus.{file.stem}]\nignore_errors = True\n" for file in Path(oplus.__file__).parent.glob("_[a-z]*.py"))
# Of pybind11's metaclass no stub says anything.
ALLOWED = "oplus\\.(Region|PlanarSet)\noplus\\._.*\n"


def run_mypy(folder, program, *arguments):
    package = str(Path(oplus.__file__).parents[1])
    (folder / "mypy.ini").write_text(MYPY, encoding="utf-8")
    (folder / "allowed").write_text(ALLOWED, encoding="utf-8")
    return subprocess.run([program, *arguments], cwd=folder, capture_output=True, text=True, timeout=300, check=False,
                          env={**os.environ, "PYTHONPATH": package, "MYPYPATH": package})


def test_stubs_say_what_there_is(tmp_path):
    ran = run_mypy(tmp_path, "stubtest", "oplus", "--mypy-config-file", "mypy.ini", "--allowlist", "allowed",
                   "--ignore-missing-stub")
    assert ran.returncode == 0, ran.stdout + ran.stderr
    names = {node.name for node in STUBS if isinstance(node, (ast.ClassDef, ast.FunctionDef)) and node.name[0] != "_"}
    assert names == set(PUBLIC)
    for value, stub in ((oplus.Region, ["_Both"]), (oplus.PlanarSet, ["_Both", "PlanarSet"])):
        stubs = {member.name for node in STUBS if getattr(node, "name", "") in stub
                 for member in node.body if isinstance(member, ast.FunctionDef)}
        assert {name for name in stubs if name[0] != "_"} == set(members(value))


# Each line: what is right, and what is not.
TYPED = """
import oplus
from fractions import Fraction
region = oplus.Region([[0, 0], [1, 0], ["1/2", Fraction(1, 3)]])
area: Fraction = (region + region - region).area
moved: oplus.PlanarSet = oplus.nfp(region, "POINT (0 0)").translated(1, 2)
parts: list[oplus.Region] = list(moved)
results: list[oplus.PlanarSet] = oplus.batch("sum", [region], [region], progress=lambda done, total: print(done, total))
oplus.minkowski_sum(region, region, with_origins=True).origins[0][0][1][0] + 1
area.nothing
oplus.nfp(region)
oplus.minkowski_sum(region, region, boundary="half")
text: str = region.bounds
region.area = 5
"""


def test_types_of_calls(tmp_path):
    (tmp_path / "typed.py").write_text(TYPED, encoding="utf-8")
    ran = run_mypy(tmp_path, "mypy", "--strict", "--config-file", "mypy.ini", "typed.py")
    lines = [int(line.split(":")[1]) for line in ran.stdout.splitlines() if line.startswith("typed.py:") and ": error:" in line]
    assert sorted(set(lines)) == list(range(10, 15)), ran.stdout + ran.stderr


def test_version():
    header = (ROOT / "checked/oplus/version.hpp").read_text(encoding="utf-8")
    assert oplus.__version__ == ".".join(re.findall(r"#define OPLUS_VERSION_[A-Z]+ ([0-9]+)", header))


@pytest.mark.parametrize("name, least", [("README.md", 4), ("docs/python.md", 10), ("docs/from_shapely.md", 10)])
def test_a_page(name, least):
    """Its sessions print what they say."""
    page = (ROOT / name).read_text(encoding="utf-8")
    examples = doctest.DocTestParser().get_doctest(page, {}, name, None, None)
    assert len(examples.examples) >= least
    report = []
    outcome = doctest.DocTestRunner(verbose=False).run(examples, out=report.append)
    assert outcome.failed == 0, "".join(report)


def test_two_threads_at_first_use():
    # Neither fractions nor numpy is imported under a lock that the other thread waits for with Python's own.
    program = """
import threading
import oplus
start = threading.Barrier(2)
def first():
    start.wait()
    assert oplus.Region([[0, 0], [1, 0], [1, 1], [0, 1]]).area == 1
threads = [threading.Thread(target=first) for _ in range(2)]
for thread in threads: thread.start()
for thread in threads: thread.join()
print("done")
"""
    ran = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60)
    assert (ran.stdout, ran.stderr) == ("done\n", "")
