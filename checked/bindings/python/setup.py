# SPDX-License-Identifier: MIT
"""A wheel: what CMake installs as the component python, of the light core. pyproject.toml has the rest."""

import re
from pathlib import Path

from skbuild import setup

header = Path("../../oplus/version.hpp").read_text(encoding="utf-8")
setup(
    version=".".join(re.findall(r"#define OPLUS_VERSION_[A-Z]+ ([0-9]+)", header)),
    packages=["oplus"],
    cmake_source_dir="../../..",
    cmake_args=["-DOPLUS_PYTHON=ON", "-DOPLUS_ENGINES=OFF", "-DOPLUS_TESTS=OFF"],
    cmake_install_target="install-python",
)
