#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails on what would be wrong about the files that a hosting service reads: a workflow or an issue form that is not
YAML or has a key that GitHub does not know, logic in a workflow, a script that it calls and that does not exist, a job
without a limit; a CITATION.cff of another title or licence; a file that says another version than <oplus/version.hpp>;
a licence that LICENSE does not name."""

import re
from pathlib import Path

import yaml

from sources import ROOT, report

WORKFLOW = {"name", "on", "permissions", "concurrency", "jobs"}
JOB = {"name", "runs-on", "container", "environment", "timeout-minutes", "defaults", "steps"}
EVENTS = {"push": {"branches", "tags"}, "pull_request": {"branches"}, "schedule": None, "workflow_dispatch": set()}
STEP = {"id", "uses", "with", "run"}
FORM = {"name", "description", "title", "labels", "body"}
ELEMENT = {"markdown": {"value"}, "input": {"label", "description", "placeholder", "value"},
           "textarea": {"label", "description", "placeholder", "value", "render"},
           "dropdown": {"label", "description", "multiple", "options"}, "checkboxes": {"label", "description", "options"}}
CONFIG = {"blank_issues_enabled", "contact_links"}
CITATION = {"cff-version", "message", "type", "title", "version", "authors", "license", "keywords", "references"}
# Where else the version is, and how it is said there.
VERSIONS = {"CITATION.cff": r"(?m)^version: (\S+)", "CHANGELOG.md": r"(?m)^## (\d\S*)",
            "checked/bindings/npm/package.json": r'"version": "(.*?)"',
            "checked/bindings/npm/oplus.d.ts": r'version of oplus, such as "(.*?)"',
            "checked/bindings/c/oplus.h": r'oplus_version.*Returns "(.*?)"', "docs/npm.md": r"oplus-(\d[\d.]*)\.tgz"}
# A script of the repository with words, and nothing that a shell would make of them.
RUN = re.compile(r"(?:bash|python3 -B) ([\w./-]+)(?: (?:[\w./=-]+|\"[\w./=|-]+\"))*")


def keys(value, known, where):
    if not isinstance(value, dict):
        return [f"{where}: is no mapping"]
    return [f"{where}: {key} is unknown" for key in value if key not in known]


def missing(value, wanted, where):
    return [f"{where}: has no {key}" for key in wanted if key not in value]


def wrong_workflow(root, workflow):
    found = keys(workflow, WORKFLOW, "workflow") + missing(workflow, ("name", "on", "permissions", "jobs"), "workflow")
    if found:
        return found
    events = workflow["on"]
    for event, filters in (events if isinstance(events, dict) else dict.fromkeys(events)).items():
        found += [] if event in EVENTS else [f"on: {event} is unknown"]
        found += keys(filters, EVENTS.get(event, ()), event) if isinstance(filters, dict) else []
    for name, job in workflow["jobs"].items():
        found += keys(job, JOB, name) + missing(job, ("runs-on", "timeout-minutes", "steps"), name)
        for step in job.get("steps", ()):
            found += keys(step, STEP, name)
            if ("run" in step) == ("uses" in step):
                found.append(f"{name}: a step has one of run and uses")
            if "uses" in step and not re.fullmatch(r"[\w-]+/[\w-]+@v\d+", step["uses"]):
                found.append(f"{name}: {step['uses']} is no action with its version")
            if "run" in step:
                script = RUN.fullmatch(step["run"])
                if not script:
                    found.append(f"{name}: `{step['run']}` is not a script and its arguments")
                elif not (root / script[1]).is_file():
                    found.append(f"{name}: {script[1]} does not exist")
    return found


def wrong_form(form):
    found = keys(form, FORM, "form") + missing(form, ("name", "description", "body"), "form")
    ids = [element["id"] for element in form.get("body", ()) if "id" in element]
    found += [f"body: two elements are {name}" for name in sorted(set(ids)) if ids.count(name) > 1]
    for element in form.get("body", ()):
        kind = element.get("type")
        where = element.get("id", kind)
        found += keys(element, {"type", "id", "attributes", "validations"}, where)
        found += keys(element.get("attributes"), ELEMENT.get(kind, ()), where)
        found += keys(element.get("validations", {}), {"required"}, where)
        if kind != "markdown":
            found += missing(element.get("attributes", {}), ("label",), where)
    return found


def wrong_citation(root, citation):
    found = keys(citation, CITATION, "citation") + missing(citation, CITATION, "citation")
    if found:
        return found
    readme = re.sub(r"\s+", " ", (root / "README.md").read_text(encoding="utf-8"))
    for title in [citation["title"]] + [one["title"] for one in citation["references"]]:
        if not re.search(rf"(# |\*){re.escape(title)}[* ]", readme):
            found.append(f"title: README has no `{title}`")
    found += [f"license: LICENSES has no {name}" for name in citation["license"]
              if not (root / f"LICENSES/{name}.txt").is_file()]
    return found


def unnamed_licences(root):
    text = (root / "LICENSE").read_text(encoding="utf-8")
    return [f"LICENSE: does not name {path.name}" for path in sorted((root / "LICENSES").iterdir())
            if f"LICENSES/{path.name}" not in text]


def other_versions(root):
    header = (root / "checked/oplus/version.hpp").read_text(encoding="utf-8")
    version = ".".join(re.findall(r"#define OPLUS_VERSION_\w+ (\d+)", header))
    for name, said in VERSIONS.items():
        # Of the change log, the newest.
        there = re.findall(said, (root / name).read_text(encoding="utf-8"))[:1 if name == "CHANGELOG.md" else None]
        for one in there or ["none"]:
            if one != version:
                yield f"{name}: version: {one} is not {version}"


def in_yaml(root):
    return sorted((root / ".github").rglob("*.y*ml")) + [root / "CITATION.cff"]


def violations(root):
    found = unnamed_licences(root) + list(other_versions(root))
    for path in in_yaml(root):
        name = path.relative_to(root).as_posix()
        try:
            # Keys and values stay the texts that they are: `on` is a word.
            value = yaml.load(path.read_text(encoding="utf-8"), Loader=yaml.BaseLoader)
        except yaml.YAMLError as error:
            found.append(f"{name}: {' '.join(str(error).split())}")
            continue
        if name == "CITATION.cff":
            wrong = wrong_citation(root, value)
        elif path.name == "config.yml":
            wrong = keys(value, CONFIG, "config")
        else:
            wrong = wrong_form(value) if path.parent.name == "ISSUE_TEMPLATE" else wrong_workflow(root, value)
        found += [f"{name}: {one}" for one in wrong]
    return found


if __name__ == "__main__":
    report("project files", len(in_yaml(ROOT)), violations(ROOT))
