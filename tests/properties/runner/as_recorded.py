#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""as_recorded.py PROGRAM RECORD I N: every N-th statement of the program, from the I-th on, does what RECORD
(docs/theorems/runs.json) says. Their pictures are drawn into runs-I/pictures/. All N of these together are all statements;
several tests share them, since all take minutes."""

import difflib
import json
import subprocess
import sys
from pathlib import Path


def lines_of(path):
    """The line of each statement, by its id."""
    return {json.loads(line.rstrip(","))["statement"]: line.rstrip(",")
            for line in Path(path).read_text(encoding="utf-8").splitlines() if line.startswith('{"statement"')}


program, record, i, n = *sys.argv[1:3], int(sys.argv[3]), int(sys.argv[4])
recorded = lines_of(record)
listed = json.loads(subprocess.run([program, "theorems", "--json"], check=True, capture_output=True, text=True).stdout)
ids = [statement["statement"] for statement in listed["statements"]]
if ids != list(recorded):
    sys.exit(f"{record} has other statements than the program: bash docs/renew records them anew")

mine = ids[i - 1::n]
part = Path(f"runs-{i}/runs.json")  # a folder of its own, since a run removes the pictures of the one before
part.parent.mkdir(exist_ok=True)
ran = subprocess.run([program, "properties", "--record", part] + [word for id in mine for word in ("--theorem", id)])
found = lines_of(part)
differences = [line for id in mine
               for line in difflib.unified_diff([recorded[id]], [found.get(id, "not run")], "recorded", "now", lineterm="")]
print("\n".join(differences))
sys.exit(ran.returncode or (1 if differences or len(found) != len(mine) else 0))
