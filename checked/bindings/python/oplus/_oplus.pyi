# SPDX-License-Identifier: MIT
# The module in C++: used by this package alone.
from typing import Any

def __getattr__(name: str) -> Any: ...
