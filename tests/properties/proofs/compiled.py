#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiles properties/proofs with Coq in a folder of the build, so that the sources' own stays clean.

Fails where a source is not named in _CoqProject, leaves something unproved, or does not compile.
Usage: compiled.py SOURCES BUILD"""

import shutil
import subprocess
import sys
from pathlib import Path

from sources import unproved


def named(project):
    """The sources that _CoqProject names."""
    return [word for line in project.read_text(encoding="utf-8").splitlines()
            for word in line.split("#")[0].split() if word.endswith(".v")]


def violations(folder):
    """What is wrong before anything is compiled."""
    project, present = named(folder / "_CoqProject"), sorted(p.name for p in folder.glob("*.v"))
    found = [f"{name}: not in _CoqProject" for name in present if name not in project]
    found += [f"{name}: in _CoqProject, but missing" for name in project if name not in present]
    for name in present:
        found += unproved(name, (folder / name).read_text(encoding="utf-8"))
    return found


def bring_up_to_date(folder, build):
    """Copies what has changed, so that make compiles no more than that and what depends on it."""
    build.mkdir(parents=True, exist_ok=True)
    sources = [folder / "_CoqProject", *folder.glob("*.v")]
    for old in build.glob("*.v"):
        if old.name not in [source.name for source in sources]:
            for compiled in build.glob(old.stem + ".*"):
                compiled.unlink()
    for source in sources:
        copy = build / source.name
        if not copy.exists() or copy.read_bytes() != source.read_bytes():
            shutil.copyfile(source, copy)


def compile_in(build):
    for command in (["coq_makefile", "-f", "_CoqProject", "-o", "Makefile"],
                    ["make", "--no-print-directory", "-j2"]):
        done = subprocess.run(command, cwd=build)
        if done.returncode != 0:
            return False
    return True


def main():
    folder, build = map(Path, sys.argv[1:3])
    found = violations(folder)
    for violation in found:
        print(violation)
    sources = named(folder / "_CoqProject")
    if found or not sources:
        sys.exit(f"{len(sources)} sources, {len(found)} wrong")
    bring_up_to_date(folder, build)
    if not compile_in(build):
        sys.exit("Coq rejects the proofs")
    print(f"{len(sources)} sources compiled")


if __name__ == "__main__":
    main()
