# SPDX-License-Identifier: MIT
"""A wheel: what CMake installs as the component python, of the light core. pyproject.toml has the rest. It needs the C
library of this system or a newer one, and nothing else, so PEP 600 calls it manylinux."""

import os
import platform
import re
import sys
from pathlib import Path

from skbuild import setup

# glibc 2.36: manylinux_2_36_x86_64.
libc = os.confstr("CS_GNU_LIBC_VERSION").split() if sys.platform == "linux" else [""]
tag = {"plat_name": f"manylinux_{libc[1].replace('.', '_')}_{platform.machine()}"} if libc[0] == "glibc" else {}
header = Path("../../oplus/version.hpp").read_text(encoding="utf-8")
setup(
    version=".".join(re.findall(r"#define OPLUS_VERSION_[A-Z]+ ([0-9]+)", header)),
    packages=["oplus"],
    options={"bdist_wheel": tag},
    cmake_source_dir="../../..",
    cmake_args=["-DOPLUS_PYTHON=ON", "-DOPLUS_ENGINES=OFF", "-DOPLUS_TESTS=OFF"],
    cmake_install_target="install-python",
)
