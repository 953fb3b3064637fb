# SPDX-License-Identifier: MIT
"""A wheel: what CMake installs as the component python, of the light core. pyproject.toml has the rest."""

import re
from pathlib import Path

from skbuild import setup

[version] = re.findall(r"^project\(oplus VERSION ([0-9.]+)", Path("../../../CMakeLists.txt").read_text(encoding="utf-8"), re.M)
setup(
    version=version,
    packages=["oplus"],
    cmake_source_dir="../../..",
    cmake_args=["-DOPLUS_PYTHON=ON", "-DOPLUS_ENGINES=OFF", "-DOPLUS_TESTS=OFF"],
    cmake_install_target="install-python",
)
