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
AS_ELSEWHERE = 4  # so many shared options, the same as those of a command before, are named there alone


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


def anchor(heading):
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


class Command:
    """What `eerie NAME --help` says."""

    def __init__(self, program, name):
        text = output_of(program, *name.split(), "--help")
        self.name, self.about = name, text.split("\n", 1)[0]
        usage = re.search(r"^Usage: eerie (.*)$", text, re.M).group(1)
        self.usage = usage.replace(" [OPTIONS]", "").replace(" SUBCOMMAND", "")
        self.options = [self.option(line) for line in self.lines(text, "Options")
                        if not line.startswith("-h")]
        self.subcommands = [line.split()[0] for line in self.lines(text, "Subcommands")]

    @staticmethod
    def lines(text, section):
        """Entries of a section, each on one line, two blanks before its meaning."""
        part = re.search(rf"^{section}:\n((?:  .*\n?)+)", text, re.M)
        entries = re.sub(r"\n {10,}", "  ", part.group(1)) if part else ""
        # A head that fills its column to the last letter has one blank behind it.
        entries = re.sub(r"^(  \S.{25}\S) (?=\S+ [^ ].*$)(?!.*  )", r"\1  ", entries, flags=re.M)
        return [line.strip() for line in entries.split("\n") if line.strip()]

    @staticmethod
    def option(line):
        """(names, value, meaning)"""
        head, _, meaning = line.partition("  ")
        names, _, kind = head.partition(" ")
        required = "REQUIRED" in kind
        kind = re.sub(r" ?(Excludes|Needs): .*| ?REQUIRED", "", kind)
        kind, more = kind.removesuffix(" ..."), kind.endswith(" ...")
        kind, _, default = kind.partition("=")
        kind = re.sub(r"^(INT|FLOAT):(INT|FLOAT) in \[(.*) - (.*)\]", r"\3..\4", kind)
        kind = {"TEXT:FILE": "FILE", "INT": "INTEGER", "FLOAT": "NUMBER"}.get(kind, kind).replace("TEXT:", "")
        meaning = re.sub("; may be (repeated|given several times)", "", meaning.strip())
        if default:
            meaning += f" (default: {default.strip('[]')})"
        if required:
            meaning += " (required)"
        return names, kind + ("..." if more else ""), meaning


def row_of(option):
    names, value, meaning = option
    return [f"`{names}={value}`" if value else f"`{names}`", meaning]


def command_line(program):
    commands = []
    for line in Command.lines(output_of(program, "--help"), "Subcommands"):
        command = Command(program, line.split()[0])
        commands += [Command(program, f"{command.name} {sub}") for sub in command.subcommands] or [command]
    users = {}
    for command in commands:
        for option in command.options:
            users.setdefault(option, []).append(command.name)
    shared = [o for o in users if len(users[o]) >= SHARED_BY]
    usual = [o for o in shared if 2 * len(users[o]) > len(commands)]
    named = [o[0] for o in shared]

    def of(option):
        """Told where commands do not name it, and where two have one name."""
        if option in usual:
            return "all but " + ", ".join(c.name for c in commands
                                          if option[0] not in [o[0] for o in c.options])
        return ", ".join(users[option]) if named.count(option[0]) > 1 else ""

    out = "## Shared options\n\nA command names those that it has, unless nearly all have them (*all but*). "
    out += "Ranges have both their ends; `...`: may be repeated.\n\n" + table(
        ["option", "meaning", "of"], [row_of(o) + [of(o)] for o in sorted(shared)])
    first_with = {}
    for command in commands:
        out += f"\n## {command.usage}\n\n{command.about}.\n"
        own = [o for o in command.options if o not in shared]
        also = frozenset(o for o in command.options if o in shared and o not in usual)
        first = first_with.setdefault(also, command)
        if own:
            out += "\n" + table(["", ""], [row_of(o) for o in own])
        if len(also) >= AS_ELSEWHERE and first is not command:
            out += f"\nAlso as [`{first.name}`](#{anchor(first.usage)}).\n"
        elif also:
            names = [o[0].split(",")[0] for o in command.options if o in also]
            out += "\nAlso " + ", ".join(f"`{name}`" for name in names) + ".\n"
    return out


def range_of(field):
    if "enum" in field:
        return ", ".join(f"`{token}`" for token in field["enum"])
    low, high, above = (field.get(k) for k in ("minimum", "maximum", "exclusiveMinimum"))
    text = f">{above:g}" if above is not None else f"{low:g}" if low is not None else ""
    return f"{text}..{high:g}" if high is not None else text and f"{text}.."


def fields(schema, path=""):
    for name, field in schema["properties"].items():
        here = f"{path}.{name}" if path else name
        if field["type"] == "object":
            yield from fields(field, here)
        else:
            default = field.get("default", "")
            shown = f"{default:g}" if isinstance(default, (int, float)) and not isinstance(
                default, bool) else json.dumps(default).strip('"')
            yield here, shown, range_of(field), field["description"]
            if field["type"] == "array" and field["items"]["type"] == "object":
                yield from fields(field["items"], here + "[]")


def scene(_):
    out, known = "", {}
    for name, part in json.loads(SCHEMA.read_text())["properties"].items():
        all_fields = list(fields(part))
        old = [f for f in all_fields if f in known]
        rows = [[f"`{name}.{path}`", *rest] for path, *rest in all_fields if (path, *rest) not in known]
        out += f"## {name}\n\n{part['description'].capitalize()}.\n\n"
        out += table(["field", "default", "allowed", "meaning"], rows) if rows else ""
        for section in dict.fromkeys(known[f] for f in old):
            same = ", ".join(f"`{name}.{f[0]}`" for f in old if known[f] == section)
            out += ("\n" if rows else "") + f"As in `{section}`: {same}.\n"
        known.update({f: name for f in all_fields if f not in known})
        out += "\n"
    return out.rstrip("\n") + "\n"


def rows_of(columns):
    """Names that differ by the axis alone stand in one row."""
    rows = {}
    for c in columns:
        told = c["unit"], re.sub(r", [xyz]$", "", c["description"])
        rows.setdefault(told, []).append(f"`{c['name']}`")
    return [[", ".join(names), *told] for told, names in rows.items()]


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
            rows = rows_of(c for c in columns if c not in old)
            known.update({c["name"]: c for c in columns})
            out += f"## {view}\n\n" + table(["column", "unit", "meaning"], rows)
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
