# SPDX-License-Identifier: GPL-3.0-or-later
from fixture import TreeTest
from layering import violations


class Layering(TreeTest):
    def found(self, name, *included):
        """What is wrong with one file that includes these."""
        path = self.write(name, *(f'#include "{one}"' for one in included))
        found = violations(self.root)
        path.unlink()
        return found

    def assert_forbidden(self, name, included):
        found = self.found(name, included)
        self.assertEqual(len(found), 1, found)
        self.assertTrue(found[0].startswith(f"{name}:1: "), found)
        self.assertIn(f"may not include {included}", found[0])

    def test_what_the_table_allows(self):
        for name, included in [
                ("reference/definitions/a.hpp", "reference/definitions/b.hpp"),
                ("reference/io/a.cpp", "reference/definitions/b.hpp"),
                ("reference/oracle/a.cpp", "reference/definitions/b.hpp"),
                ("checked/arrangement/a.cpp", "reference/io/b.hpp"),
                ("checked/arrangement/a.cpp", "checked/collision/b.hpp"),
                ("checked/cli/a.cpp", "reference/oracle/b.hpp"),
                ("checked/cli/a.cpp", "checked/arrangement/b.hpp"),
                ("checked/cli/a.cpp", "reference/families/b.hpp"),
                ("reference/families/a.cpp", "reference/definitions/b.hpp"),
                ("properties/statements/chapter4/a.cpp", "reference/oracle/b.hpp"),
                ("properties/statements/chapter4/a.cpp", "checked/arrangement/b.hpp"),
                ("properties/statements/chapter4/a.cpp", "reference/families/b.hpp"),
                ("checked/bindings/python/a.cpp", "oplus/oplus.hpp"),
                ("checked/bindings/c/a.cpp", "checked/cycles/b.hpp"),
                ("tests/reference/a_test.cpp", "checked/arrangement/b.hpp"),
                ("tests/reference/a_test.cpp", "tests/corpus/b.hpp")]:
            with self.subTest(name=name, included=included):
                self.assertEqual(self.found(name, included), [])

    def test_what_it_forbids(self):
        for name, included in [
                ("reference/definitions/a.hpp", "reference/io/b.hpp"),
                ("reference/definitions/a.cpp", "reference/oracle/b.hpp"),
                ("reference/definitions/a.cpp", "checked/arrangement/b.hpp"),
                ("reference/io/a.cpp", "reference/oracle/b.hpp"),
                ("reference/io/a.cpp", "reference/families/b.hpp"),
                ("reference/oracle/a.cpp", "reference/io/b.hpp"),
                ("reference/oracle/a.cpp", "checked/collision/b.hpp"),
                ("checked/arrangement/a.cpp", "reference/oracle/b.hpp"),
                ("checked/arrangement/a.cpp", "checked/cli/b.hpp"),
                ("checked/verify/a.cpp", "reference/oracle/b.hpp"),
                ("reference/pictures/a.cpp", "reference/families/b.hpp"),
                ("reference/pictures/a.cpp", "checked/slide/b.hpp"),
                ("docs/findings/a.cpp", "reference/definitions/b.hpp"),
                ("checked/bindings/python/a.cpp", "checked/slide/b.hpp"),
                ("checked/bindings/python/a.cpp", "reference/definitions/b.hpp"),
                ("checked/bindings/c/a.cpp", "checked/cli/b.hpp"),
                ("checked/cli/a.cpp", "checked/bindings/c/b.hpp"),
                ("checked/cli/a.cpp", "properties/runner/b.hpp"),
                ("checked/cli/a.cpp", "tests/corpus/b.hpp"),
                ("reference/families/a.cpp", "reference/oracle/b.hpp"),
                ("reference/families/a.cpp", "checked/slide/b.hpp"),
                ("reference/families/a.cpp", "properties/runner/b.hpp"),
                ("properties/statements/chapter4/a.cpp", "tests/corpus/b.hpp"),
                ("tests/reference/a_test.cpp", "oplus/checked/arrangement/b.hpp")]:
            with self.subTest(name=name, included=included):
                self.assert_forbidden(name, included)

    def test_every_way_to_write_an_include(self):
        for line in ['#include <checked/arrangement/b.hpp>', '  #  include "checked/arrangement/b.hpp"  // why',
                     '#include "reference/../checked/arrangement/b.hpp"', '#include"checked//rca/b.hpp"']:
            with self.subTest(line=line):
                self.write("reference/definitions/a.cpp", "// first", line)
                found = violations(self.root)
                self.assertEqual(len(found), 1, found)
                self.assertTrue(found[0].startswith("reference/definitions/a.cpp:2: "), found)

    def test_names_that_do_not_start_at_the_root(self):
        for included in ["b.hpp", "../checked/arrangement/b.hpp", "definitions/b.hpp"]:
            with self.subTest(included=included):
                found = self.found("reference/definitions/a.cpp", included)
                self.assertEqual(len(found), 1, found)
                self.assertIn("repository root", found[0])

    def test_an_include_that_is_computed(self):
        self.write("reference/definitions/a.cpp", "#include HEADER")
        self.assertIn("computed", violations(self.root)[0])

    def test_a_folder_without_a_rule(self):
        for name in ["reference/a.cpp", "reference/new/a.cpp", "docs/a.cpp", "a.cpp"]:
            with self.subTest(name=name):
                self.assertIn("no rule", self.found(name, "vector")[0])

    def test_libraries_are_no_concern(self):
        self.write("reference/definitions/a.cpp", "#include <CGAL/Arrangement_2.h>",
                   "#include <checkedmath/a.hpp>", '// #include "checked/arrangement/b.hpp"')
        self.assertEqual(violations(self.root), [])

    def test_folders_that_include_each_other(self):
        self.write("checked/arrangement/a.hpp", '#include "checked/collision/a.hpp"')
        self.write("checked/collision/a.hpp", '#include "reference/definitions/a.hpp"')
        self.assertEqual(violations(self.root), [])
        # Through different files, and over a third folder.
        self.write("checked/collision/b.hpp", '#include "checked/cycles/a.hpp"')
        self.write("checked/cycles/a.hpp", '#include "checked/arrangement/b.hpp"')
        found = violations(self.root)
        self.assertEqual(len(found), 1, found)
        self.assertIn("checked/arrangement -> checked/collision -> checked/cycles -> checked/arrangement",
                      found[0])

    def test_the_consumer_is_a_project_of_its_own(self):
        self.write("tests/consumer/a.cpp", "#include <oplus/checked/arrangement/rca.hpp>")
        self.assertEqual(violations(self.root), [])
