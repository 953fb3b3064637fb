# SPDX-License-Identifier: GPL-3.0-or-later
import shutil

import compiled
import formatted
import licence_lines
import mutant_names  # which finds list_mutants
import page_algorithms
import project_files
import public_headers
import tests_by_file
from fixture import TreeTest
from list_mutants import mutants, source
from sources import ROOT, report

MIT, SPDX = (licence_lines.LINE + one for one in (licence_lines.MIT, licence_lines.GPL))


class LicenceLines(TreeTest):
    def test_where_the_line_must_be(self):
        self.write("reference/io/right.cpp", "// " + MIT)
        self.write("reference/io/wrong.cpp", "// " + SPDX)
        self.write("checked/engine.hpp", "// " + MIT)
        self.write("checked/sweep/right.cpp", "// " + SPDX)
        self.write("checked/sweep/wrong.cpp", "// " + MIT)
        self.write("tests/run", "#!/bin/sh", "# " + SPDX)
        self.write("tests/CMakeLists.txt", "# " + SPDX)
        self.write("tests/corpus/some.dat", "data")
        self.write("reference/io/late.cpp", "", "// " + MIT)
        self.write("reference/io/empty.hpp")
        self.write("properties/run", "#!/bin/sh", "echo", "# " + SPDX)
        self.write("CMakeLists.txt", "project(oplus)")
        self.write("properties/proofs/right.v", f"(* {SPDX} *)")
        self.write("properties/proofs/unclosed.v", f"(* {SPDX}", "*)")
        self.write("properties/smt/right.smt2", "; " + SPDX)
        found = licence_lines.violations(self.root, licence_lines.sources(self.root))
        self.assertEqual([line.split(":")[0] for line in found],
                         ["CMakeLists.txt", "checked/sweep/wrong.cpp",
                          "properties/proofs/unclosed.v", "properties/run", "reference/io/empty.hpp",
                          "reference/io/late.cpp", "reference/io/wrong.cpp"])

    def test_what_the_core_includes(self):
        self.write("checked/sweep/a.cpp", "#include <CGAL/a.h>", '#include "checked/slide/a.hpp"')
        self.write("reference/io/a.cpp", "#include <gmpxx.h>", "#include <boost/a.hpp>",
                   '#include "reference/definitions/a.hpp"', '#include "checked/statistics.hpp"')
        self.assertEqual(licence_lines.wrong_includes(self.root), [])
        for line in ["<CGAL/a.h>", '"CGAL/a.h"', "<tbb/a.h>", "<mpfr.h>", '"checked/sweep/a.hpp"',
                     '"checked/engines/engines.hpp"', '"properties/a.hpp"']:
            with self.subTest(line=line):
                self.write("checked/slide/a.hpp", "#include <vector>", "#include " + line)
                self.assertEqual(licence_lines.wrong_includes(self.root),
                                 [f"checked/slide/a.hpp:2: the core may not include {line[1:-1]}"])

    def test_the_texts_of_the_licences(self):
        self.write("LICENSES/MIT.txt")
        self.assertEqual(licence_lines.missing_licences(self.root),
                         ["LICENSES/GPL-3.0-or-later.txt: missing", "LICENSES/MPL-2.0.txt: missing"])
        self.write("LICENSES/GPL-3.0-or-later.txt")
        self.write("LICENSES/MPL-2.0.txt")
        self.assertEqual(licence_lines.missing_licences(self.root), [])

    def test_whose_the_data_is(self):
        self.write("tests/data/README.md", "`c.dat` is named in no table.", "| `a.dat`, `b/b.wkt` | whose | licence |")
        for name in ("a.dat", "b/b.wkt", "c.dat"):
            self.write("tests/data/" + name)
        self.assertEqual(licence_lines.unnamed_data(self.root),
                         ["tests/data/c.dat: no row of tests/data/README.md"])


class Format(TreeTest):
    def test_a_line_out_of_style(self):
        shutil.copy(ROOT / ".clang-format", self.root)
        paths = [self.write("reference/io/right.cpp", "int* right = nullptr;"),
                 self.write("reference/io/wrong.cpp", "int *wrong=nullptr ;")]
        self.assertEqual(formatted.violations(self.root, paths),
                         ["reference/io/wrong.cpp: clang-format would change it"])


class PublicHeaders(TreeTest):
    def setUp(self):
        super().setUp()
        self.write("checked/rca/traits.hpp", "#include <vector>", "#include <CGAL/Arrangement_2.h>")
        self.write("checked/rca/faces.hpp", '#include "checked/rca/traits.hpp"')
        self.write("checked/rca/rca.hpp", "#include <vector>")

    def test_inside_its_folder(self):
        self.write("checked/rca/rca.cpp", '#include "checked/rca/faces.hpp"', "#include <CGAL/a.h>")
        self.write("checked/cli/sum.cpp", '#include "checked/rca/rca.hpp"')
        self.write("tests/checked/rca/faces_test.cpp", '#include "checked/rca/faces.hpp"')
        self.assertEqual(public_headers.violations(self.root), [])

    def test_out_of_its_folder(self):
        for included in ["checked/rca/traits.hpp", "checked/rca/faces.hpp"]:
            for including in ["checked/cli/sum.hpp", "properties/runner/diff.cpp"]:
                with self.subTest(included=included, including=including):
                    path = self.write(including, f'#include "{included}"')
                    self.assertEqual(public_headers.violations(self.root),
                                     [f"{including}:1: {included} brings CGAL out of its folder"])
                    path.unlink()

    def test_a_source_of_the_same_library(self):
        self.write("checked/cli/sum.cpp", '#include "checked/rca/traits.hpp"')
        self.assertEqual(public_headers.violations(self.root), [])


class PageAlgorithms(TreeTest):
    def test_what_the_page_lacks(self):
        self.write(page_algorithms.HEADER, "auto find(const Range& range, const Value& value) {")
        for path in ("checked/slide/a.cpp", "checked/layouts/a.cpp", "checked/sweep/a.cpp"):
            self.write(path, "std::ranges::find(a, b);", "std::find(std::ranges::begin(a), std::ranges::rotate(a));")
        self.assertEqual(list(page_algorithms.violations(self.root)),
                         [f"checked/slide/a.cpp:2: {page_algorithms.HEADER} has no rotate of 1 arguments"])

    def test_as_many_arguments(self):
        self.write(page_algorithms.HEADER, "auto find(const Range& range, const Value& value) {")
        self.write("checked/slide/a.cpp", "std::ranges::find(a, f(b, c)); std::ranges::find(a,", "  [](int i, int j) { g(i, j); }, {});")
        self.assertEqual(list(page_algorithms.violations(self.root)),
                         [f"checked/slide/a.cpp:1: {page_algorithms.HEADER} has no find of 3 arguments"])

    def test_arguments_with_a_default(self):
        self.write(page_algorithms.HEADER, "void sort(Range&& range, Less less = {}, Projection projection = {}) {")
        self.write("checked/slide/a.cpp", "std::ranges::sort(a); std::ranges::sort(a, b); std::ranges::sort(a, {}, c);",
                   "std::ranges::sort(a, b, c, d);")
        self.assertEqual(list(page_algorithms.violations(self.root)),
                         [f"checked/slide/a.cpp:2: {page_algorithms.HEADER} has no sort of 4 arguments"])


class Compiled(TreeTest):
    def test_a_source_that_no_target_has(self):
        self.write("reference/io/in.cpp")
        self.write("reference/io/relative.cpp")
        self.write("properties/chapter9/out.cpp")
        self.write("tests/consumer/own.cpp")
        commands = [{"directory": "/", "file": str(self.root / "reference/io/in.cpp")},
                    {"directory": str(self.root / "build"), "file": "../reference/io/relative.cpp"}]
        self.assertEqual(compiled.violations(self.root, commands),
                         ["properties/chapter9/out.cpp: no target compiles it"])


class TestsByFile(TreeTest):
    def setUp(self):
        super().setUp()
        suite = lambda name, *cases: {"name": name, "testsuite": [
            {"name": case, "file": f"../tests/{file}"} for case, file in cases]}
        self.filters = tests_by_file.filters(
            [suite("Wkt", ("reads", "read_test.cpp"), ("writes", "write_test.cpp")),
             suite("Pairs/Sum", ("is/0", "sum_test.cpp"), ("is/1", "sum_test.cpp")),
             suite("Dat", ("reads", "read_test.cpp"))], self.root / "build")

    def test_each_case_is_in_one_file(self):
        tests = self.root.resolve() / "tests"
        self.assertEqual(self.filters, {tests / "read_test.cpp": {"Wkt.reads", "Dat.*"},
                                        tests / "write_test.cpp": {"Wkt.writes"},
                                        tests / "sum_test.cpp": {"Pairs/Sum.*"}})
        lines = list(tests_by_file.entries(self.filters, tests, "debug.", "/bin/tests", "/build"))
        self.assertEqual(lines[0], "add_test([=[debug.read_test]=] [=[/bin/tests]=] "
                                   "[=[--gtest_filter=Dat.*:Wkt.reads]=])")
        self.assertEqual(len(lines), 6)

    def test_a_file_without_cases(self):
        sources = [self.write("tests/read_test.cpp"), self.write("tests/empty_test.cpp")]
        self.assertEqual(tests_by_file.without_cases(self.filters, sources),
                         [f"{sources[1]}: no case of it is in the program"])


class MutantNames(TreeTest):
    def setUp(self):
        super().setUp()
        self.write("checked/rca/a.cpp", 'if (OPLUS_MUTANT("two", "is " "wrong")',
                   '    || OPLUS_MUTANT("one",', '                    "is wrong, too")) return;')
        self.write("reference/definitions/mutant.hpp", '#define OPLUS_MUTANT(name, ...) false')
        self.with_one = str(self.write("with", "\0one\0"))
        self.without = str(self.write("without", "\0"))

    def violations(self, expected, *binaries):
        return mutant_names.violations(expected, ["one", "two"], list(binaries))

    def test_list(self):
        self.write("reference/io/b.hpp", '// OPLUS_MUTANT("none")', 'if (OPLUS_MUTANT("one")) return;')
        listed = [("one", "is wrong, too", "checked/rca/a.cpp"),
                  ("two", "is wrong", "checked/rca/a.cpp")]
        self.assertEqual(mutants(self.root), listed)
        self.assertIn('"two",\n       "is wrong",', source(listed))

    def test_list_that_cannot_be_made(self):
        for file, code, message in [
                ("reference/b.cpp", 'OPLUS_MUTANT("three")', "does not say what goes wrong"),
                ("reference/b.cpp", 'OPLUS_MUTANT("one", "is right")', "b.cpp and in checked/rca"),
                ("reference/b.cpp", 'OPLUS_MUTANT(name, "is")', "is not a string"),
                ("properties/b.cpp", 'OPLUS_MUTANT("three", "is")', "in reference/ and checked/ only")]:
            with self.subTest(code=code):
                path = self.write(file, code)
                with self.assertRaisesRegex(ValueError, message):
                    mutants(self.root)
                path.unlink()

    def test_absent(self):
        self.assertEqual(self.violations("absent", self.without), [])
        self.assertEqual(self.violations("absent", self.without, self.with_one),
                         [f"{self.with_one} contains the mutant one"])

    def test_present(self):
        self.assertEqual(self.violations("present", self.without, self.with_one),
                         ["no binary contains the mutant two"])


class ProjectFiles(TreeTest):
    WORKFLOW = ("name: Tests", "on: [push]", "permissions:", "  contents: read", "jobs:", "  tests:",
                "    runs-on: ubuntu-latest", "    timeout-minutes: 9", "    steps:", "      - uses: actions/checkout@v4",
                "      - run: bash tests/run -R tree")
    FORM = ("name: Wrong", "description: It is", "body:", "  - type: input", "    id: p", "    attributes:", "      label: P")
    CITATION = ("cff-version: 1.2.0", "message: cite", "type: software", 'title: "oplus: sums"', "version: 0.1.0", "authors: []",
                "license: [MIT]", "keywords: []", "references:", "  - title: Sums")

    VERSIONS = {"CHANGELOG.md": ("# Change log", "## 0.1.0 - unreleased", "## 0.0.9"), "docs/npm.md": ("`oplus-0.1.0.tgz`",),
                "checked/bindings/npm/package.json": ('"version": "0.1.0",',),
                "checked/bindings/npm/oplus.d.ts": ('/** The version of oplus, such as "0.1.0". */',),
                "checked/bindings/c/oplus.h": ('const char* oplus_version(void);  ///< Returns "0.1.0".',)}

    def setUp(self):
        super().setUp()
        self.write("tests/run")
        self.write("LICENSES/MIT.txt")
        self.write("LICENSE", "LICENSES/MIT.txt")
        self.write("README.md", "# oplus: sums", "The theory is from the thesis *Sums* (1900).")
        self.write("checked/oplus/version.hpp", *(f"#define OPLUS_VERSION_{part} {number}  ///< It."
                                                  for part, number in (("MAJOR", 0), ("MINOR", 1), ("PATCH", 0))))
        self.files = {".github/workflows/a.yml": self.WORKFLOW, ".github/ISSUE_TEMPLATE/b.yml": self.FORM,
                      "CITATION.cff": self.CITATION, **self.VERSIONS, ".github/ISSUE_TEMPLATE/config.yml": ("blank_issues_enabled: false",)}
        for name, lines in self.files.items():
            self.write(name, *lines)

    def test_what_is_right(self):
        self.assertEqual(project_files.violations(self.root), [])

    def test_what_is_wrong(self):
        for name, line, changed, message in [
                ("workflows/a.yml", "on: [push]", "on: [push", "expected ',' or ']'"),
                ("workflows/a.yml", "on: [push]", "on: [pushed]", "on: pushed is unknown"),
                ("workflows/a.yml", "    steps:", "    stepz:", "tests: stepz is unknown"),
                ("workflows/a.yml", "    timeout-minutes: 9", "    environment: a", "tests: has no timeout-minutes"),
                ("workflows/a.yml", "      - run: bash tests/run -R tree", "      - run: bash tests/runs", "tests/runs does not exist"),
                ("workflows/a.yml", "      - run: bash tests/run -R tree", "      - run: bash tests/run && make", "is not a script"),
                ("workflows/a.yml", "      - run: bash tests/run -R tree", "      - run: make", "is not a script"),
                ("workflows/a.yml", "      - run: bash tests/run -R tree", "        run: make", "one of run and uses"),
                ("workflows/a.yml", "      - uses: actions/checkout@v4", "      - uses: actions/checkout", "with its version"),
                ("ISSUE_TEMPLATE/b.yml", "  - type: input", "  - type: inputs", "p: label is unknown"),
                ("ISSUE_TEMPLATE/b.yml", "      label: P", "      labels: P", "p: has no label"),
                ("ISSUE_TEMPLATE/b.yml", "body:", "bodies:", "form: has no body"),
                ("ISSUE_TEMPLATE/config.yml", "blank_issues_enabled: false", "blank: false", "blank is unknown"),
                ("CITATION.cff", "version: 0.1.0", "version: 0.2.0", "0.2.0 is not 0.1.0"),
                *((name, *[(line, line.replace("0.1.0", "0.2.0")) for line in lines if "0.1.0" in line][0], "0.2.0 is not 0.1.0")
                  for name, lines in self.VERSIONS.items()),
                ("docs/npm.md", "`oplus-0.1.0.tgz`", "nothing", "none is not 0.1.0"),
                ("CITATION.cff", "  - title: Sums", "  - title: Products", "README has no `Products`"),
                ("CITATION.cff", "license: [MIT]", "license: [BSD]", "LICENSES has no BSD"),
                ("CITATION.cff", "keywords: []", "keyword: []", "keyword is unknown")]:
            name = name if name in self.files else ".github/" + name
            with self.subTest(changed=changed):
                lines = self.files[name]
                self.assertIn(line, lines)
                self.write(name, *(changed if one == line else one for one in lines))
                found = project_files.violations(self.root)
                self.write(name, *lines)
                self.assertTrue(any(one.startswith(name) and message in one for one in found), found)

    def test_a_licence_that_is_not_named(self):
        self.write("LICENSES/BSD.txt")
        self.assertEqual(project_files.violations(self.root), ["LICENSE: does not name BSD.txt"])


class Report(TreeTest):
    def test_exit_code(self):
        for checked, violations, code in [(3, [], 0), (3, ["one"], 1), (0, [], 1)]:
            with self.subTest(checked=checked, violations=violations):
                with self.assertRaises(SystemExit) as exit:
                    report("what", checked, violations)
                self.assertEqual(exit.exception.code, code)
