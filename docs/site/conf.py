# SPDX-License-Identifier: GPL-3.0-or-later
# docs/site/make runs Sphinx with this and sets the variables.
import os
import re
import sys
from pathlib import Path

import furo

ROOT = Path(os.environ["OPLUS_ROOT"])
sys.path.insert(0, str(ROOT / "docs/site"))

project = "oplus"
author = "the authors of oplus"
header = (ROOT / "checked/oplus/version.hpp").read_text(encoding="utf-8")
release = ".".join(re.findall(r"#define OPLUS_VERSION_[A-Z]+ ([0-9]+)", header))
copyright = "MIT for the core, GPL-3.0-or-later for the rest"
extensions = ["myst_parser", "breathe", "sphinx.ext.autodoc", "tree"]

# As on a Git host.
myst_heading_anchors = 6
# Blocks without a language are commands, output, and code of several languages.
highlight_language = "none"

breathe_projects = {"oplus": os.environ["OPLUS_API"] + "/xml"}
breathe_default_project = "oplus"
autodoc_member_order = "bysource"

html_theme = "furo"
# Debian's Furo has its dark colours for those who switch to them, but not for those whose system is dark.
dark = (Path(furo.__file__).parent / "theme/furo/static/styles/furo.css").read_text(encoding="utf-8")
dark = re.search(r'body\[data-theme="dark"\] \{([^{}]*)', dark)[1]
html_theme_options = {"dark_css_variables": dict(re.findall(r"--([\w-]+): (.*?);", dark))}
html_title = f"oplus {release}"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
# Furo's code is dark where the page is.
pygments_style = "default"
pygments_dark_style = "monokai"

# Names of other libraries, and parts of declarations that are no names of ours.
nitpick_ignore_regex = [("cpp:identifier", "oplus|(CGAL|boost|std)(::.*)?|[A-Z]|mpq_class|State|Engine|known"),
                        ("py:class", "numpy.*|fractions.*|.*Like|Any")]
