#!/usr/bin/env python3
"""Makes the tables of command-line.md, scene.md and database.md from the program and the schema.

usage: docs/reference/make.py [PROGRAM] [--check]
PROGRAM is build/eerie unless told otherwise. What stands above the mark in a page is kept.
--check writes nothing and fails where a page differs from the program.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SCHEMA = HERE.parents[1] / "solver/scene/scene.schema.json"
MARK = "<!-- Made by docs/reference/make.py; do not edit below. -->\n"
SHARED_BY = 2  # an option of so many commands stands in one table for all


def output_of(program, *arguments, folder=None):
    done = subprocess.run([program, *arguments], capture_output=True, text=True, cwd=folder)
    if done.returncode:
        sys.exit(f"{program} {' '.join(arguments)}: {done.stderr}")
    return done.stdout


def table(header, rows):
    """Markdown; a column without content is left out."""
    kept = [k for k, _ in enumerate(header) if any(row[k] for row in rows)]
    header, rows = [header[k] for k in kept], [[row[k] for k in kept] for row in rows]
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    for row in rows:
        cells = [str(cell).replace("|", "\\|") for cell in row]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


class Command:
    """What `eerie NAME --help` says."""

    def __init__(self, program, name):
        text = output_of(program, *name.split(), "--help")
        self.name, self.about = name, text.split("\n", 1)[0]
        usage = re.search(r"^Usage: eerie (.*)$", text, re.M).group(1)
        self.usage = "eerie " + usage.replace(" [OPTIONS]", "").replace(" SUBCOMMAND", "")
        self.options = [self.option(line) for line in self.lines(text, "Options")]
        self.subcommands = [line.split()[0] for line in self.lines(text, "Subcommands")]

    @staticmethod
    def lines(text, section):
        """Entries of a section, each on one line."""
        part = re.search(rf"^{section}:\n((?:  .*\n?)+)", text, re.M)
        entries = re.sub(r"\n {10,}", "  ", part.group(1)) if part else ""
        return [line.strip() for line in entries.split("\n") if line.strip()]

    @staticmethod
    def option(line):
        """(names, value, default, meaning)"""
        head, _, meaning = line.partition("  ")
        names, _, kind = head.partition(" ")
        kind, more = kind.removesuffix(" ..."), kind.endswith(" ...")
        kind = re.sub(r" ?(Excludes|Needs): .*| ?REQUIRED", "", kind)
        kind, _, default = kind.partition("=")
        kind = re.sub(r"^(INT|FLOAT):(INT|FLOAT) in", "", kind)
        kind = {"TEXT:FILE": "file"}.get(kind, kind).replace("TEXT:", "")
        kind = {"TEXT": "text", "INT": "whole number", "FLOAT": "number"}.get(kind, kind)
        words = kind.strip().strip("{}").replace(",", ", ").replace(" - ", " to ").strip("[]")
        meaning = meaning.strip()
        if more and "may be repeated" not in meaning:
            meaning += "; may be repeated"
        return names, words, default, meaning


def row_of(option):
    names, value, default, meaning = option
    return ["`" + names.replace(",", "`, `") + "`", value, default, meaning]


def command_line(program):
    commands = []
    for line in Command.lines(output_of(program, "--help"), "Subcommands"):
        command = Command(program, line.split()[0])
        commands += [command] + [Command(program, f"{command.name} {sub}")
                                 for sub in command.subcommands]
    users = {}
    for command in commands:
        for option in command.options:
            users.setdefault(option, []).append(command.name)
    shared = [o for o in users if len(users[o]) >= SHARED_BY and not o[0].startswith("-h")]
    names = [o[0] for o in users]
    of = {o: ", ".join(users[o]) if len(users[o]) < 12 else "all others"
          for o in shared if names.count(o[0]) > 1}
    header = ["option", "value", "default", "meaning"]
    out = "## Options of several commands\n\n" + table(
        [*header, "of"], [row_of(o) + [of.get(o, "")] for o in sorted(shared)])
    for command in commands:
        if command.subcommands:
            continue
        out += f"\n## eerie {command.name}\n\n    {command.usage}\n\n{command.about}.\n"
        own = [o for o in command.options if o not in shared and not o[0].startswith("-h")]
        also = [o[0].split(",")[0] for o in command.options if o in shared]
        if own:
            out += "\n" + table(header, [row_of(o) for o in own])
        if also:
            out += "\nAlso: " + ", ".join(f"`{name}`" for name in also) + ".\n"
    return out


def range_of(field):
    if "enum" in field:
        return ", ".join(f"`{token}`" for token in field["enum"])
    low, high = field.get("minimum"), field.get("maximum")
    above = field.get("exclusiveMinimum")
    text = f"above {above:g}" if above is not None else f"{low:g}" if low is not None else ""
    if high is None:
        return text
    return f"{text} to {high:g}" if low is not None else f"{text}, to {high:g}"


def fields(schema, path=""):
    for name, field in schema["properties"].items():
        here = f"{path}.{name}" if path else name
        if field["type"] == "object":
            yield from fields(field, here)
        else:
            default = field.get("default")
            shown = f"{default:g}" if isinstance(default, (int, float)) and not isinstance(
                default, bool) else json.dumps(default).strip('"')
            yield here, shown, range_of(field), field["description"]
            if field["type"] == "array" and field["items"]["type"] == "object":
                yield from ((f"{a}", b if b != "null" else "", c, d)
                            for a, b, c, d in fields(field["items"], here + "[]"))


def scene(_):
    out = ""
    for name, part in json.loads(SCHEMA.read_text())["properties"].items():
        rows = [[f"`{path}`", default, allowed, meaning] for path, default, allowed, meaning
                in fields({"properties": {name: part}})]
        out += f"## {name}\n\n{part['description'].capitalize()}.\n\n"
        out += table(["field", "default", "allowed", "meaning"], rows) + "\n"
    return out.rstrip("\n") + "\n"


def database(program):
    sweep = {"name": "none", "grid": {"q": [1]}}
    known, out = {}, ""
    with tempfile.TemporaryDirectory() as folder:
        pathlib.Path(folder, "none.json").write_text(json.dumps(sweep))
        output_of(program, "submit", "none.json", "--db", "none.sqlite", folder=folder)
        for view in ("results", "remnants", "maps"):
            answer = json.loads(output_of(program, "query", "--of", view, "--db", "none.sqlite",
                                          "--format", "json-table", folder=folder))
            columns = answer["schema"]["fields"]
            old = [c for c in columns if known.get(c["name"]) == c]
            rows = [[f"`{c['name']}`", c["unit"], c["type"], c["description"]]
                    for c in columns if c not in old]
            known.update({c["name"]: c for c in columns})
            out += f"## {view}\n\n" + table(["column", "unit", "type", "meaning"], rows)
            if old:
                out += "\nAs above: " + ", ".join(f"`{c['name']}`" for c in old) + ".\n"
            out += "\n"
    return out.rstrip("\n") + "\n"


def main(program, check):
    different = []
    for name, made in (("command-line.md", command_line), ("scene.md", scene),
                       ("database.md", database)):
        page = HERE / name
        old = page.read_text(encoding="utf8")
        new = old.partition(MARK)[0] + MARK + "\n" + made(str(pathlib.Path(program).resolve()))
        if new != old:
            different.append(name)
            if not check:
                page.write_text(new, encoding="utf8")
    if check and different:
        print(f"{', '.join(different)}: not what the program says; "
              "docs/reference/make.py writes them anew")
    return 1 if check and different else 0


if __name__ == "__main__":
    names = [a for a in sys.argv[1:] if not a.startswith("-")]
    sys.exit(main(names[0] if names else "build/eerie", "--check" in sys.argv))
