# SPDX-License-Identifier: GPL-3.0-or-later
import coverage
from fixture import TreeTest

SOURCE = ("template <typename T>", "T f(T x) {", "  if constexpr (is_small<T>) return 0;", "  // Why.", "  if (x < 0 ||", "      x > 9)",
          "    x = 1;", "  each([&](T y) {", "    x += y;", "  });", "  return x;", "}", "int g() {",
          '  if (OPLUS_MUTANT("g-is-wrong", "it; is { wrong"))', "    return 1;", "  return 2;", "}", "bool a() = default;")


def function(name, regions, branches=()):
    """Regions are (line, column, last line, column behind, count, kind), branches (line, column, column behind, taken, not)."""
    return {"filenames": [name], "regions": [[*region[:5], 0, 0, region[5]] for region in regions],
            "branches": [[line, column, line, end, taken, not_taken, 0, 0, 4] for line, column, end, taken, not_taken in branches]}


class Coverage(TreeTest):
    def setUp(self):
        super().setUp()
        name = str(self.write("checked/slide/f.hpp", *SOURCE))
        elsewhere = [str(self.write(f"{folder}/f.cpp", "int f();")) for folder in ("checked/cli", "reference/io", "tests/checked/a")]
        comment, body = (4, 1, 4, 1, 0, 2), (2, 10, 12, 2)
        small = [(*body, 5, 0), (3, 32, 3, 40, 5, 0), (5, 3, 11, 11, 0, 0), comment]
        large = [(*body, 2, 0), (3, 32, 3, 40, 0, 0), comment, (6, 14, 7, 5, 0, 3), (7, 5, 7, 10, 0, 0)]
        self.functions = [
            function(name, small, [(5, 7, 12, 0, 0), (6, 7, 12, 0, 0)]),
            function(name, large, [(5, 7, 12, 1, 1), (6, 7, 12, 0, 1)]),
            function(name, [(8, 17, 10, 4, 0, 0)]), function(name, [(13, 9, 17, 2, 3, 0), (14, 55, 15, 5, 0, 3), (15, 5, 15, 13, 0, 0)]),
            function(name, [(18, 1, 18, 20, 0, 0)], [(18, 1, 5, 0, 0)]), *(function(other, [(1, 1, 1, 9, 0, 0)]) for other in elsewhere)]

    def main(self, *reasons, exported=None):
        self.write(coverage.REASONS, "# A comment.", *reasons)
        self.write("docs/coverage.md")
        answer = coverage.main({"data": [{"functions": self.functions if exported is None else exported}]}, self.root)
        return *answer, (self.root / "docs/coverage.md").read_text(encoding="utf-8")

    def test_instances_are_united_and_lambdas_are_not(self):
        wrong, _, counts, page = self.main()
        # Of lines 2 to 17 without the comment, 7, 9, 10 and 15 are not run; line 8 is.
        self.assertEqual(counts, [(11, 15), (3, 4)])
        self.assertIn("| `checked/slide/` | 15 | 11 | 73.3 % | 4 | 3 | 75.0 % |\n| **all** | 15 | 11 |", page)
        no_reason = f"{coverage.REASONS}: no reason for checked/slide/f.hpp, line "
        self.assertEqual(wrong, [no_reason + "7: `x = 1;`", no_reason + "9: `x += y;`", no_reason + "10: `});`",
                                 no_reason + "6: `x > 9` is never true", "73.3 % of lines are covered, fewer than 98 %",
                                 "75.0 % of branches are covered, fewer than 95 %"])
        self.assertIn(f"**{coverage.MUTANT}**\n\n- checked/slide/f.hpp, line 15: `return 1;`\n", page)

    def test_reasons(self):
        wrong, left, _, page = self.main("It is so.", "  checked/slide/f.hpp: x = 1;", "  checked/slide/f.hpp: x > 9", "",
                                         "Or so.", "  checked/slide/f.hpp: x += y;", "  checked/gone.hpp: x")
        self.assertEqual([line for line in wrong if "%" not in line], [])
        self.assertEqual(left, ["checked/gone.hpp: x"])
        self.assertIn("**It is so.**\n\n- checked/slide/f.hpp, line 7: `x = 1;`\n- checked/slide/f.hpp, line 6: `x > 9` is never true\n", page)
        # The second of two lines belongs to the first.
        self.assertIn("**Or so.**\n\n- checked/slide/f.hpp, line 9: `x += y;`\n- checked/slide/f.hpp, line 10: `});`\n", page)

    def test_another_clones_paths(self):
        moved = [entry | {"filenames": [f"/clone/build/coverage/../../{name[len(str(self.root)) + 1:]}" for name in entry["filenames"]]}
                 for entry in self.functions]
        self.assertEqual(self.main(exported=moved), self.main())

    def test_nothing_run(self):
        self.assertEqual(self.main(exported=[])[0], ["no file of the core was run"])
