#!/usr/bin/env python3
"""Fails where a page links to a file or heading that is not there, names a source that is not there,
or cannot be reached from docs/README.md.

usage: links.py ROOT
"""
import pathlib
import re
import sys

TOPS = ("solver/", "campaign/", "analysis/", "db/", "sweeps/", "tests/", "docs/")


def without_code(markdown):
    return re.sub(r"^```.*?^```", "", markdown, flags=re.S | re.M)


def anchors(path):
    found = set()
    for line in without_code(path.read_text(encoding="utf8")).split("\n"):
        if line.startswith("#"):
            title = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", line.lstrip("#").strip()).lower()
            found.add(re.sub(r"[^\w\- ]", "", title).replace(" ", "-"))
    return found


def main(root):
    pages = [root / "README.md", root / "CONTRIBUTING.md", root / "sweeps/README.md",
             *sorted(root.glob("docs/**/*.md"))]
    assert len(pages) > 10, f"{root} holds no documentation"
    bad, leads_to = [], {}
    for page in pages:
        text, here = without_code(page.read_text(encoding="utf8")), page.relative_to(root)
        leads_to[page.resolve()] = set()
        for target in re.findall(r"\]\(([^)\s]+)\)", text):
            if re.match(r"[a-z]+:", target):
                continue
            file, _, anchor = target.partition("#")
            there = (page.parent / file).resolve() if file else page.resolve()
            leads_to[page.resolve()].add(there)
            if not there.exists():
                bad.append(f"{here}: {target} is not there")
            elif anchor and anchor not in anchors(there):
                bad.append(f"{here}: {target}: there is no such heading")
        for name in re.findall(r"`([\w./-]+)`", text):
            if name.startswith(TOPS) and not (root / name).exists():
                bad.append(f"{here}: `{name}` is not there")
    reached, edge = set(), [(root / "docs/README.md").resolve()]
    while edge:
        page = edge.pop()
        if page not in reached:
            reached.add(page)
            edge += [p for p in leads_to.get(page, ()) if p.suffix == ".md" or p.is_dir()]
    for page in pages:
        if page.is_relative_to(root / "docs") and page.resolve() not in reached:
            bad.append(f"{page.relative_to(root)}: nothing that docs/README.md leads to links here")
    print("\n".join(bad))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
