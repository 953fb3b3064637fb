# SPDX-License-Identifier: GPL-3.0-or-later
"""Docstrings, stubs, and examples."""

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
    assert all(len(line) <= 110 or "InvalidInput" in line or ">>>" in line or "Fraction" in line
               for line in text.splitlines())


def parameters(function):
    """(name, default) of a stub's parameters, as inspect.signature has them."""
    arguments = function.args
    defaults = [None] * (len(arguments.args) - len(arguments.defaults)) + arguments.defaults
    both = list(zip(arguments.args, defaults)) + list(zip(arguments.kwonlyargs, arguments.kw_defaults))
    return [(argument.arg, ast.literal_eval(default) if default else inspect.Parameter.empty)
            for argument, default in both if argument.arg != "self"]


def signature(value):
    return [(name, parameter.default) for name, parameter in inspect.signature(value).parameters.items()]


def test_stubs_say_what_there_is():
    classes = {node.name: node for node in STUBS if isinstance(node, ast.ClassDef) and node.name[0] != "_"}
    functions = [node for node in STUBS if isinstance(node, ast.FunctionDef)]
    assert {*classes, *(node.name for node in functions)} == set(PUBLIC)
    for function in functions:
        # Of an overload with errors='return', which is not the default, there is no default.
        expected = [(name, "raise" if name == "errors" else default) for name, default in parameters(function)]
        assert signature(PUBLIC[function.name]) == expected, function.name
    for name, node in classes.items():
        if name in ("Arrays", "InvalidInput"):
            continue
        stubs = {member.name: member for member in node.body if isinstance(member, ast.FunctionDef)}
        assert {stub for stub in stubs if stub[0] != "_"} == set(members(PUBLIC[name])), name
        for stub, member in stubs.items():
            value = inspect.getattr_static(PUBLIC[name], stub)
            is_property = any(one.id == "property" for one in member.decorator_list)
            assert is_property == isinstance(value, property), f"{name}.{stub}"
            if not is_property and stub[0] != "_":
                assert signature(getattr(PUBLIC[name], stub)) == parameters(member), f"{name}.{stub}"
    assert [(field.target.id, field.value and ast.literal_eval(field.value)) for field in classes["Arrays"].body] == [
        (name, None) for name in oplus.Arrays._fields]


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
