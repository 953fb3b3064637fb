#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compiles properties/proofs with Coq in a folder of the build, so that the sources' own stays clean.

Fails where a source is not named in _CoqProject, leaves something unproved, defines a name that another one defines,
or does not compile.
Usage: compiled.py SOURCES BUILD [FOLDER]; with it, what is in that folder of SOURCES is left to another run"""

import shutil
import subprocess
import sys
from pathlib import Path

from sources import defined_twice, unproved

# Written to OCaml, and compiled over the reals, by others.
NOT_OF_THE_LIBRARY = ("*/extraction.v", "over_the_reals/*")


def named(project):
    """The sources that _CoqProject names."""
    return [word for line in project.read_text(encoding="utf-8").splitlines()
            for word in line.split("#")[0].split() if word.endswith(".v")]


def present(folder):
    """The sources in a folder and below."""
    paths = [path.relative_to(folder) for path in folder.rglob("*.v")]
    return sorted(str(path) for path in paths if not any(path.match(pattern) for pattern in NOT_OF_THE_LIBRARY))


def violations(folder):
    """What is wrong before anything is compiled."""
    project, texts = named(folder / "_CoqProject"), {name: (folder / name).read_text(encoding="utf-8")
                                                     for name in present(folder)}
    found = [f"{name}: not in _CoqProject" for name in texts if name not in project]
    found += [f"{name}: in _CoqProject, but missing" for name in project if name not in texts]
    for name, text in texts.items():
        found += unproved(name, text)
    return found + defined_twice(texts)


def bring_up_to_date(folder, build):
    """Copies what has changed, so that make compiles no more than that and what depends on it."""
    build.mkdir(parents=True, exist_ok=True)
    sources = present(folder)
    for old in set(present(build)) - set(sources):
        for compiled in (build / old).parent.glob(Path(old).stem + ".*"):
            compiled.unlink()
    for name in ["_CoqProject", *sources]:
        source, copy = folder / name, build / name
        if not copy.exists() or copy.read_bytes() != source.read_bytes():
            copy.parent.mkdir(exist_ok=True)
            shutil.copyfile(source, copy)


def compile_in(build, sources=()):
    """In the order that coqdep finds."""
    for command in (["coq_makefile", "-f", "_CoqProject", "-o", "Makefile"],
                    ["make", "--no-print-directory", "-j2", *(source + "o" for source in sources)]):
        done = subprocess.run(command, cwd=build)
        if done.returncode != 0:
            return False
    return True


def main():
    folder, build, *later = map(Path, sys.argv[1:])
    found = violations(folder)
    for violation in found:
        print(violation)
    sources = named(folder / "_CoqProject")
    if found or not sources:
        sys.exit(f"{len(sources)} sources, {len(found)} wrong")
    bring_up_to_date(folder, build)
    sources = [name for name in sources if not {*later} & {*Path(name).parents}]
    if not sources or not compile_in(build, sources):
        sys.exit("Coq rejects the proofs")
    print(f"{len(sources)} sources compiled")


if __name__ == "__main__":
    main()
