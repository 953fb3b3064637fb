# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/testing.md: the text of testing.md beside this file, with figures counted in the sources and the records."""

import re

from records import InvalidRecord, read, rows

# Figures that are numbers of matches: in which files, and of what.
MATCHES = {
    "pairs_with_a_story": ("tests/corpus/pairs.txt", r"^story: "),
    "placements": ("tests/corpus/named_placements.json", r'"contact": '),
    "transcribed": ("tests/**/transcripts/*.txt", r"^\$ "),
    "faults_in_coq": ("tests/properties/proofs/faults.py", r'^    \("'),
    "commands": ("docs/*.md", r"^    (?:\$ )?(?:build/release/bin/)?oplus(?:-check|-proved|-peer|-maintain)? "),
    "faults_by_fuzzing": ("docs/fuzz.md", r"^\| `[a-z-]+`: "),
    "fuzz_targets": ("properties/fuzz/CMakeLists.txt", r"^oplus_fuzz_target\(\w+ \d+\)"),
    "contracts_reference": ("reference/**/*.[ch]pp", r"^ *OPLUS_(?:REQUIRES|ENSURES)\("),
    "contracts_checked": ("checked/**/*.[ch]pp", r"^ *OPLUS_(?:REQUIRES|ENSURES)\("),
    "false_in_the_thesis": ("docs/findings.md",
                            r"^## (?:Theorem|Lemma|Corollary|Observation|Definition|Algorithm|Section|Table)\b"),
}
# Figures that are numbers of files.
FILES = {
    "fuzz_seeds": "properties/fuzz/seeds/*/*",
    "pages": "docs/*.md",
    "examples": "docs/examples/cpp/*.cpp",
    "finding_programs": "docs/findings/*.cpp",
    "nesting_instances": "tests/data/esicup/*.wkt",
}
# The first words of names of tests, and what these tests are.
KINDS = {
    "bench": "that all engines of the measurements start and agree",
    "c": "the C interface, from C, Rust and Lua",
    "campaigns": "a campaign in shards, one of them killed, gives what one run gives",
    "check": "the properties of all statements, the faults that they find, the pages",
    "checked": "unit tests of the algorithms and of the command line",
    "conformance": "somebody's own program is judged",
    "consumer": "projects that find and use what is installed; the core where there is no CGAL",
    "corpus": "named pairs, by each engine",
    "docs": "what pages say, draw, link to and name; the site",
    "example": "the programs of the documentation print what it says",
    "exhaustive": "all pairs of small polygons on a grid of 3 × 3 points",
    "finding": "other libraries are as wrong as we say",
    "fuzz": "the fuzz targets, always with the same random numbers",
    "newest": "the newest CGAL and Clipper2 of Debian",
    "npm": "the npm module, in Node and in a browser",
    "packages": "the packages of Debian, a wheel, the recipes of package managers",
    "page": "the page to draw on, in a browser",
    "platforms": "the core or the program by other compilers, libraries and systems",
    "proofs": "Coq and SMT: proofs, their assumptions, faults in definitions, proved programs beside ours",
    "properties": "unit tests of what makes, runs, shrinks and reports comparisons",
    "python": "the Python package, with Hypothesis; notebooks",
    "reference": "unit tests of the definitions, of the oracle, of reading and writing",
    "release": "the public headers, compiled as users compile them",
    "sanitized": "unit tests of the core with the address and undefined behaviour sanitizers",
    "tree": "layers, licences, format, headers, workflows; that these checks find what they look for",
}


def count(root, pattern):
    files = [path for path in root.glob(pattern) if path.is_file()]
    if not files:
        raise InvalidRecord(f"docs/testing.md: there is no file {pattern}")
    return len(files), "".join(path.read_text(encoding="utf-8", errors="replace") for path in sorted(files))


def matches(root, name, pattern, what):
    number = len(re.findall(what, count(root, pattern)[1], re.M))
    if number == 0:
        raise InvalidRecord(f"docs/testing.md: nothing of {name} is in {pattern}")
    return number


def tests_by_kind(records):
    """The rows of the table of tests by the first words of their names."""
    text = ""
    for row in records:
        if row["kind"] not in KINDS:
            raise InvalidRecord(f"docs/tests.csv: properties/pages/testing_page.py does not say what {row['kind']} is")
        text += (f"| `{row['kind']}` | {KINDS[row['kind']]} | {row['default tests']} | {row['core-seconds']} | "
                 f"{row['other tests']} |\n")
    return text


def own_findings(findings, link=""):
    """How many rows of the table of faults in our own code have this link."""
    section = re.search(r"^## Found in our own code$(.*?)^## ", findings, re.M | re.S)
    rows = re.findall(r"^\| (?!what ).*", section[1] if section else "", re.M)
    return sum(link in row for row in rows)


def failures(scoreboard):
    """Of the other implementations: how many there are, and of how many kinds the failures of each are, added up."""
    kinds = {}
    for name, entry in [entry for part in scoreboard.values() for entry in part.items()]:
        if name != "slide":
            kinds.setdefault(name, set()).update(entry["failures"])
    return len(kinds), sum(map(len, kinds.values()))


def campaigns(root):
    """The reports that are kept in docs/campaigns: how many pairs were compared, and by how many operations."""
    reports = [read(path) for path in sorted((root / "docs/campaigns").glob("*.json"))]
    if not reports or any(report["interrupted"] or report["all"]["disagreed"] for report in reports):
        raise InvalidRecord("docs/campaigns: there is no report, or one has a disagreement or was interrupted")
    ran = {"campaign_sums": 0, "campaign_values": 0}
    for report in reports:
        ran["campaign_sums" if report["campaign"]["operation"] == "sum" else "campaign_values"] += report["all"]["ran"]
    return ran | {"campaign_operations": len({report["campaign"]["operation"] for report in reports} - {"sum"})}


def figures(root, statements, mutants, records):
    found = {name: matches(root, name, *where) for name, where in MATCHES.items()}
    found |= {name: count(root, pattern)[0] for name, pattern in FILES.items()}
    costs, tests = rows(root / "docs/cost.csv")[-1], rows(root / "docs/tests.csv")
    scoreboard = read(root / "docs/scoreboard/runs.json")
    runs = [records.runs[statement["statement"]] for statement in statements]
    builds = sum(int(costs[f"{'core-seconds ' if name == 'check' else ''}of {name}"]) for name in ("check", "release", "fuzz"))
    ours = scoreboard["sums"]["slide"]["sums"]["passed"] + scoreboard["parts"]["slide"]["sums"]["passed"]
    others, kinds = failures(scoreboard)
    if any(part["slide"]["failures"] for part in scoreboard.values()):
        raise InvalidRecord("docs/testing.md: says that no sum of oplus is wrong, the scoreboard's record says otherwise")
    found |= campaigns(root) | {
        "statements": len(statements), "enumerated": sum(run.get("enumerated", 0) for run in runs),
        "random_pairs": sum(run["run"] for run in runs), "mutants": len(mutants), "kills": len(records.kills),
        "made_by_a_script": sum(fault["end"] != "not reached" for fault in records.made),
        "theorems": len(records.theorems), "queries": len(records.queries),
        "cases": len(read(root / "tests/corpus/cases.json")["cases"]),
        "contracts": found["contracts_reference"] + found["contracts_checked"],
        "false_in_ours": own_findings(records.text_of_findings),
        "ours_by_properties": own_findings(records.text_of_findings, "](theorems/"),
        "ours_by_fuzzing": own_findings(records.text_of_findings, "](fuzz.md)"),
        "ours_by_coverage": own_findings(records.text_of_findings, "](coverage.md)"),
        "ours_by_transcripts": own_findings(records.text_of_findings, "transcripts)"), "other_libraries": others, "their_failures": kinds,
        "our_sums": ours, "version": costs["version"], "coq_lines": int(costs["lines of Coq"]),
        "cpp_cases": int(costs["cases in C++"]), "python_cases": int(costs["in Python"]),
        "build_minutes": round(builds / 60),
        "test_minutes": round(int(costs["of tests"]) / 60), "number_of_tests": int(costs["number of tests"]),
        "tests_by_kind": tests_by_kind(tests),
        "other_tests": sum(int(row["other tests"]) for row in tests),
    }
    return {name: f"{value:,}" if isinstance(value, int) else value for name, value in found.items()}


def testing_page(root, statements, mutants, records):
    try:
        text = (root / "properties/pages/testing.md").read_text(encoding="utf-8")
        return text.format_map(figures(root, statements, mutants, records))
    except (KeyError, IndexError, ValueError, OSError) as error:
        raise InvalidRecord(f"docs/testing.md: a record is not as expected: {error!r}") from error
