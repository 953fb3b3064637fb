#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""conda_recipe.py RECIPE ARCHIVE WORK: what rattler-build does with a recipe.yaml, of what that of oplus uses: checks
its keys, runs its script on the archive of the sources, and its tests. Installs into WORK/prefix."""

import hashlib
import os
import re
import subprocess
import sys
from pathlib import Path

import yaml

RECIPE, ARCHIVE, WORK = (Path(argument).resolve() for argument in sys.argv[1:])
PREFIX = WORK / "prefix"
# Of the format's schema: the keys that a recipe with one output may have, and those inside them.
KEYS = {"schema_version": (), "context": None, "package": ("name", "version"), "source": ("url", "sha256"),
        "build": ("number", "skip", "script"), "requirements": ("build", "host", "run", "run_exports"), "tests": (),
        "about": ("homepage", "summary", "license", "license_file")}
WORDS = {'compiler("cxx")': "gxx", 'stdlib("c")': "sysroot"}


def filled(value, context):
    """With `${{ ... }}` replaced."""
    if isinstance(value, dict):
        return {key: filled(one, context) for key, one in value.items()}
    if isinstance(value, list):
        return [filled(one, context) for one in value]
    return re.sub(r"\$\{\{ (.*?) \}\}", lambda found: context[found[1]], value) if isinstance(value, str) else value


recipe = yaml.safe_load(RECIPE.read_text(encoding="utf-8"))
assert recipe["schema_version"] == 1 and set(recipe) == set(KEYS), set(recipe) ^ set(KEYS)
for section, keys in KEYS.items():
    if keys:
        assert set(recipe[section]) == set(keys), (section, set(recipe[section]) ^ set(keys))
recipe = filled(recipe, WORDS | recipe["context"])
source = recipe["source"]
assert ARCHIVE.name == f"{recipe['package']['name']}-{recipe['package']['version']}.tar.gz"
assert source["url"].startswith("https://") and source["url"].endswith("/" + ARCHIVE.name), source["url"]
assert hashlib.sha256(ARCHIVE.read_bytes()).hexdigest() == source["sha256"], "the recipe is of another archive"
for where in ("build", "host", "run", "run_exports"):
    for package in recipe["requirements"][where]:
        assert re.fullmatch(r"[a-z0-9-]+( [<>=0-9.]+)?", package), package

sources = WORK / "src"
sources.mkdir(parents=True)
subprocess.run(["tar", "-x", "-f", ARCHIVE, "-C", sources, "--strip-components=1"], check=True)
assert (sources / recipe["about"]["license_file"]).is_file()
subprocess.run(["bash", "-e", "-c", "\n".join(recipe["build"]["script"])], cwd=sources, check=True,
               env=os.environ | {"PREFIX": str(PREFIX), "SRC_DIR": str(sources)}, stdout=subprocess.DEVNULL)
[test] = recipe["tests"]
[contents] = test.values()
assert set(test) == {"package_contents"} and set(contents) == {"include", "lib", "files"}, test
for file in ([f"include/{name}" for name in contents["include"]] + [f"lib/lib{name}.a" for name in contents["lib"]] +
             contents["files"]):
    assert (PREFIX / file).is_file(), file
