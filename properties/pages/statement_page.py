# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/theorems/ID.md."""

from links import with_links_to_findings
from records import in_words

PICTURE = "![P, Q, and their convolution and open sum](pictures/{})\n"


def link_to_source(file):
    return f"[`{file}`](../../{file})"


def list_of_statements(ids, none):
    return ", ".join(f"[{id}]({id}.md)" for id in ids) or none


def source_of_theory(statement):
    kind, _, number = statement["statement"].partition("-")
    return {"fact": "A fact that is not in the thesis",
            "step": "A step of [slide](../slide.md), not in the thesis",
            "law": "A law of the sum that every engine must obey, not in the thesis",
            }.get(kind, f"{kind.capitalize()} {number} of the thesis")


def tally(title, counts, of=0, promises={}):
    if not counts:
        return ""
    text = f"\n| {title} | number |" + (" share | promised |\n|---|---:|---:|---:|\n" if of else "\n|---|---:|\n")
    for name, count in counts.items():
        text += f"| {name} | {count} |"
        if of:
            text += f" {100 * count // of} % | {promises[name]} % |" if name in promises else \
                    f" {100 * count // of} % |  |"
        text += "\n"
    return text


def recorded_run(statement, run):
    text = f"\n## A recorded run\n    oplus-check properties --theorem {statement['statement']}\n"
    if "enumerated" in run:
        text += f"\nProved by enumeration, {run['enumerated']} cases.\n"
    if statement["cases"]:
        text += (f"\n{run['run']} pairs hold, {run['discarded']} were discarded, none failed.\n" +
                 tally("family", run["families"], run["run"]) +
                 tally("pairs with", run["classes"], run["run"], statement["promised_percent"]) +
                 tally("looked at", run["counts"]))
    return text


def proofs(theorems, backing):
    text = f"## What is proved, and what is tested\nIn short: {backing}.\n"
    if not theorems:
        return text + "Nothing of it is proved by Coq.\n\n"
    text += ("`ctest -L proofs` checks the proofs again, and that they use no axioms, over ℝ none but "
             "[its own](../proofs.md#over-the-real-numbers).\n")
    for theorem in theorems:
        formal = theorem["formal"].replace("\n", "\n    ")
        text += (f"\n`{theorem['theorem']}`, {link_to_source('properties/proofs/' + theorem['file'])}, "
                 f"*{theorem['extent']}*, over {theorem['numbers']}.\n{theorem['gloss']}\n\n    {formal}\n\n"
                 f"- covered: {theorem['covers']}\n- not covered: {theorem['not_covered']}\n")
    return text + "\n"


def answers(queries):
    if not queries:
        return ""
    text = ("\n## Proved by Z3 and cvc5\nEach query is proved for all real numbers by both solvers: see [proofs by "
            "SMT](../smt.md). Behind each hypothesis stands Z3's counterexample to the statement without it, which "
            "is also one by the definitions.\n")
    for query in queries:
        text += f"\n`{query['id']}`, {link_to_source(query['file'])}: if\n"
        for name, says in query["hypotheses"].items():
            text += f"- {says}; false without: {in_words(query['counterexamples'][name])}\n"
        text += f"\nthen {query['conclusion']}.\n"
    return text


def found_by(kill, enumeration):
    return enumeration if kill["by_enumeration"] else f"case {kill['cases']}"


def kill_table(kills, mutants):
    text = ("\n## Faults that it finds\nEach changes one line of the code, in builds of the preset `check` only.\n\n"
            "| mutant | what goes wrong | where | found by |\n|---|---|---|---|\n")
    for kill in kills:
        mutant = mutants[kill["mutant"]]
        text += (f"| `{mutant['mutant']}` | {mutant['what']} | {link_to_source(mutant['file'])} | "
                 f"{found_by(kill, 'the enumeration')} |\n")
    return text


def counterexample(statement, kills):
    shown = next((kill for kill in kills if "shrunk" in kill), None)
    if not shown:
        return ""
    return (f"\n## A shrunk counterexample\nWith the fault `{shown['mutant']}` the statement fails on this pair, and on "
            f"no smaller one; without the fault it holds.\nWhat is seen: {shown['why']}.\n\n"
            f"    P: {shown['shrunk']['p']}\n    Q: {shown['shrunk']['q']}\n\n" +
            PICTURE.format(statement + "-shrunk.svg"))


def what_it_says(text, findings):
    """The statement, and where ours is another one than the thesis's, that and why."""
    linked = lambda words: with_links_to_findings(words, findings)
    if not text.thesis:
        return f"## Statement\n{linked(text.says)}\n\n"
    return (f"## The statement of the thesis\n{linked(text.thesis)}\n\n"
            f"## What is stated here\n{linked(text.says)}\n\n" +
            (f"*The difference:* {linked(text.differs)}\n\n" if text.differs else ""))


def statement_page(statement, text_of_it, statements, mutants, records):
    """The text of the page. text_of_it: from statements.md; mutants: by name."""
    def of_this(entries):
        return [entry for entry in entries if entry["statement"] == id]
    id = statement["statement"]
    run, kills = records.runs[id], of_this(records.kills)
    above = [s["statement"] for s in statements if id in s["rests_on"]]
    cited_by = ", ".join(f"[{page}](../{page}.md)" for page in records.citing.get(id, []))
    protects = sorted({mutants[kill["mutant"]]["file"] for kill in kills})
    text = (f"# {statement['title']}\n{source_of_theory(statement)}, `{id}`. Words and symbols: "
            "[notation](../notation.md). Generated from the sources by `properties/pages/pages.py`.\n\n"
            f"{what_it_says(text_of_it, records.findings)}"
            f"{proofs(of_this(records.theorems), records.backing.in_words(id))}"
            f"## Why it holds\n{with_links_to_findings(statement['why'], records.findings)}\n\n## Hypotheses\n" +
            "".join(f"- {hypothesis}\n" for hypothesis in statement["hypotheses"]) +
            f"\nRests on: {list_of_statements(statement['rests_on'], 'definitions only')}.\n"
            f"\nWhat rests on it: {list_of_statements(above, 'nothing')}. All of this: [the graph](graph.md).\n" +
            (f"\nCited by: {cited_by}.\n" if cited_by else "") +
            f"\n## How it is tested\n- the property: {link_to_source(statement['file'])}\n"
            f"- what it protects: {', '.join(map(link_to_source, protects))}\n" + answers(of_this(records.queries)) +
            recorded_run(statement, run) + kill_table(kills, mutants))
    if "typical" in run:
        text += ("\n## A typical case\nThe median by size of the pairs of the run.\n\n" +
                 PICTURE.format(id + "-typical.svg"))
    return text + counterexample(id, kills)
