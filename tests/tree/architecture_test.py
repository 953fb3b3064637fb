# SPDX-License-Identifier: GPL-3.0-or-later
from architecture import in_dot, included_folders, violations, without_detours
from fixture import TreeTest

DRAWN = ('<g class="node">>a</text>', '<g class="node">>b</text>', '<g class="node">>c</text>',
         '<g class="edge"><title>1&#45;&gt;0</title>', '<g class="edge"><title>2&#45;&gt;1</title>')


class Architecture(TreeTest):
    """c includes a and b, b includes a: no arrow leads from c to a, since one comes there by b."""

    def setUp(self):
        super().setUp()
        self.write("checked/a/a.hpp", "#include <vector>", "#include <oplus/none.hpp>")
        self.write("checked/b/b.cpp", '#include "checked/a/a.hpp"', '#include "checked/one.hpp"')
        self.write("checked/c/c.cpp", '#include "checked/a/a.hpp"', '#include "checked/b/b.hpp"')
        self.write("checked/one.hpp", '#include "checked/a/a.hpp"')
        self.write("tests/a_test.cpp", '#include "checked/c/c.hpp"')
        self.write("docs/architecture.md", "`checked/a/` `checked/b/` `checked/c/`")
        self.write("docs/architecture.svg", *DRAWN)
        graph = included_folders(self.root)
        del graph["checked/a"]  # which includes oplus/, a folder that is not there
        self.graph = graph | {"checked/a": set()}

    def test_arrows(self):
        self.assertEqual(self.graph, {"checked/a": set(), "checked/b": {"checked/a"}, "checked/c": {"checked/a", "checked/b"}})
        self.assertEqual(without_detours(self.graph), [("checked/b", "checked/a"), ("checked/c", "checked/b")])
        self.assertTrue(in_dot(self.graph).endswith("1->0 ;\n2->1 ;\n}\n"))

    def test_what_users_include_is_in_the_folder_of_that_name(self):
        self.assertEqual(included_folders(self.root)["checked/a"], {"checked/oplus"})

    def test_what_is_out_of_date(self):
        self.write("checked/a/a.hpp")
        self.write("docs/architecture.dot", in_dot(included_folders(self.root)).removesuffix("\n"))
        self.assertEqual(list(violations(self.root)), [])
        self.write("docs/architecture.svg", *DRAWN[1:])
        self.assertEqual(list(violations(self.root)), ["docs/architecture.svg: is not the drawing of architecture.dot"])
        self.write("docs/architecture.svg", *DRAWN)
        self.write("docs/architecture.md", "`checked/a/` `checked/b/`")
        self.write("checked/c/c.cpp", '#include "checked/a/a.hpp"')
        self.assertEqual([one.partition(";")[0] for one in violations(self.root)],
                         ["docs/architecture.dot: out of date", "docs/architecture.svg: is not the drawing of architecture.dot",
                          "docs/architecture.md: has no row for checked/c/"])
