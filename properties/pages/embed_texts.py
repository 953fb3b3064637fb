#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""embed_texts.py ROOT FILE: writes what is said and recorded of the statements (statement.hpp) as C++ to FILE."""

import json
import sys
from pathlib import Path

from records import Backing
from texts import texts


def literal(text):
    return json.dumps(text, ensure_ascii=False)


def literals(items):
    return "{" + ", ".join(map(literal, items)) + "}"


def source(root):
    backing = Backing(root)
    entries = "".join(
        f"      {{{literal(text.id)}, {literal(text.title)}, {literal(text.says)}, {literal(text.why)},\n"
        f"       {literals(text.hypotheses)}, {literals(text.rests_on)}, {literal(backing.in_words(text.id))}}},\n"
        for text in texts(root))
    return f"""// SPDX-License-Identifier: GPL-3.0-or-later
// Made by properties/pages/embed_texts.py.
#include "properties/runner/statement.hpp"

namespace oplus {{

const std::vector<StatementText>& statement_texts() {{
  static const std::vector<StatementText> all = {{
{entries}  }};
  return all;
}}

}}  // namespace oplus
"""


if __name__ == "__main__":
    target, made = Path(sys.argv[2]), source(Path(sys.argv[1]))
    if not target.exists() or target.read_text(encoding="utf-8") != made:
        target.write_text(made, encoding="utf-8")
