#!/usr/bin/env python3
"""The parts of pages that repeat what the program prints: its verbs, help, solvers and families, each
between <!-- listed: KIND --> and <!-- end -->. Fails where a page says something else.

  listed.py LCPBENCH           LCPBENCH_WRITE_PAGES=1 in the environment writes the pages instead
"""
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = ["harness/README.md", "harness/cli/README.md", "solvers/README.md", "problems/README.md"]
PARTS = {"stability": ("perturb", "frontier", "loop")}


def printed(*words):
    return subprocess.check_output([sys.argv[1], *words], text=True)


def verbs_of(*words):
    """(verb, what it does) of a page of help."""
    listed = printed(*words, "--help").split("Subcommands:\n")[1].split("\n\n")[0]
    return [line.split(None, 1) for line in listed.splitlines()]


def verbs():
    found = [(verb, does) for verb, does in verbs_of()]
    for verb, parts in PARTS.items():
        place = [name for name, _ in found].index(verb)
        found[place:place + 1] = [(f"{verb} {part}", does) for part, does in verbs_of(verb)]
    return found


def verb_table():
    lines = [f"| [`{verb}`](cli/README.md#{verb.replace(' ', '-')}) | {does} |" for verb, does in verbs()]
    return "\n".join(["| verb | does |", "|---|---|", *lines])


def help_texts():
    return "\n\n".join(f"## {verb}\n\n```\n{printed(*verb.split(), '--help').strip()}\n```" for verb, _ in verbs())


def rows(kind, *columns):
    """Of the registry: the project's own."""
    found = [row for row in json.loads(printed("list", kind, "--json"))[kind] if not row.get("library")]
    return "\n".join(["| " + " | ".join(["name", *columns]) + " |", "|---" * (1 + len(columns)) + "|"]
                     + ["| " + " | ".join([f"`{row['name']}`"] + [row[column] for column in columns]) + " |"
                        for row in found])


KINDS = {
    "verbs": verb_table,
    "help": help_texts,
    "solvers": lambda: rows("solvers", "summary", "supports", "source"),
    "families": lambda: rows("families", "summary", "source"),
}


def main():
    stale = []
    for name in PAGES:
        page = ROOT / name
        text = page.read_text()
        now = re.sub(r"(<!-- listed: (\w+) -->\n\n).*?(\n*<!-- end -->)",
                     lambda each: f"{each[1]}{KINDS[each[2]]()}\n\n<!-- end -->", text, flags=re.S)
        if os.environ.get("LCPBENCH_WRITE_PAGES"):
            page.write_text(now)
        elif now != text:
            stale.append(name)
    if stale:
        sys.exit(f"{', '.join(stale)}: not what the program prints; to write it:\n"
                 f"  LCPBENCH_WRITE_PAGES=1 tests/example/listed.py build/release/lcpbench")


if __name__ == "__main__":
    main()
