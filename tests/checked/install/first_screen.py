#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""first_screen.py FOLDER: writes into FOLDER what README tells users to type, as it stands there: install_PACKAGE of
each package, computes (a line each of the table of what can be computed), sum, program.cpp and program.txt, and
session.txt."""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/docs"))
from readme_program import blocks


def section(text, heading):
    return re.search(rf"^## {heading}.*?\n(.*?)(?=^## )", text, re.M | re.S)[1]


def main():
    folder = Path(sys.argv[1])
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    installs = re.findall(r"`(apt install (?:\./[a-z0-9]+_\*\.deb )?\./([a-z0-9-]+)_\*\.deb)`", section(readme, "Install"))
    files = {f"install_{package}": line for line, package in installs}
    assert set(files) == {"install_oplus", "install_liboplus-dev", "install_python3-oplus"}, files
    computes = re.findall(r"^\|.*`(oplus .*?)`", section(readme, "No-fit polygon"), re.M)
    assert len(computes) == 5, computes
    files["computes"] = "\n".join(computes)
    [files["program.cpp"], files["program.txt"]] = blocks(section(readme, "In C"))
    [files["session.txt"]] = blocks(section(readme, "In Python"))
    [files["sum"]] = blocks(section(readme, "On the command line"))
    for name, text in files.items():
        (folder / name).write_text(text.rstrip("\n") + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
