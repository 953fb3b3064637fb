#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Has the compiled proofs checked by coqchk, a checker apart from the compiler and its tactics, and
fails unless it finds no axiom and no check switched off. Coq's own library is taken as it is.
Usage: checked_again.py BUILD, made by compiled.py"""

import re
import subprocess
import sys
from pathlib import Path

from compiled import named
from sources import module

# Coq's library hides what this module is made of, and coqchk counts what is hidden.
HIDDEN = "Coq.ssr.ssrunder.Under_rel."
# What it says of a context in which nothing is taken on trust.
HEADS = {"Axioms", "Constants/Inductives relying on type-in-type",
         "Constants/Inductives relying on unsafe (co)fixpoints",
         "Inductives whose positivity is assumed"}


def trusted(said):
    """What coqchk's summary says is taken on trust."""
    heads, found = {}, []
    for line in said.splitlines():
        head = re.match(r"\* ([^:]+):(.*)", line)
        if head:
            heads[head.group(1)] = head.group(2).strip()
            found += [head.group(2).strip()] if head.group(1) in HEADS else []
        elif line.startswith("    "):
            found.append(line.strip())
    found += [f"nothing said of: {head}" for head in sorted(HEADS - heads.keys())]
    return [one for one in found
            if one and one != "<none>" and not one.startswith(HIDDEN)]


def coqchk(build, modules):
    """Its exit code, and what it says."""
    command = ["coqchk", "-silent", "-o", "-R", ".", "Oplus"]
    for one in modules:
        command += ["-norec", one]
    done = subprocess.run(command, cwd=build, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True)
    return done.returncode, done.stdout


def main():
    build = Path(sys.argv[1])
    modules = [module(name) for name in named(build / "_CoqProject")]
    code, said = coqchk(build, modules)
    found = trusted(said)
    for one in found:
        print(f"taken on trust: {one}")
    if code != 0 or found or not modules:
        sys.exit(f"coqchk, exit code {code}:\n{said}")
    print(f"{len(modules)} files checked, nothing taken on trust")


if __name__ == "__main__":
    main()
